// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// Loading of files.
#pragma once

#include "common/Reporter.h"
#include "scene/model/LoadedData.h"

#include <string>

namespace penumbra::tool
{
/// Throws a Failure unless the path is a readable file that is not empty.
void RequireReadableFile(const std::string& path);

/// Reads a file. Throws a Failure if it cannot be read or is empty.
LoadedData Load(const std::string& path, Reporter& reporter);
}
