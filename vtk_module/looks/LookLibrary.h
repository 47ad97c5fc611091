// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The looks by name: those that are embedded at build time from looks/, and those of the user's folder.
 */
#pragma once

#include <map>
#include <string>
#include <vector>

namespace penumbra
{
/// Texts of the embedded looks by file name, "studio.json".
const std::map<std::string, const char*>& EmbeddedLooks();

/// Names of all looks: "as-is" first, then in alphabetical order. The user's folder is read at each call.
std::vector<std::string> LookNames();

/// The text of a look, given by its name or by the path of a file. Throws a LookError.
std::string FindLook(const std::string& nameOrPath);
}
