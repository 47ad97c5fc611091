// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// The file formats, one row each, and the one way in.
#pragma once

#include "common/Reporter.h"
#include "scene/model/Loaded.h"

#include <string>
#include <vector>

namespace penumbra::tool
{
struct Format
{
  std::string Extension; ///< with the dot, lower case, "" never
  std::string Description;
  Loaded (*Read)(const std::string& path, Step& step);
  DefaultView View;
};

/// The table of formats.
const std::vector<Format>& Formats();

/// The row for a file name, or nullptr; the longest extension wins (".nii.gz").
const Format* FindFormat(const std::string& path);

/// Throws a Failure unless the path is a readable, not empty file.
void RequireReadableFile(const std::string& path);

/// Reads a file; throws a Failure that names it when it cannot be read or holds nothing.
Loaded Load(const std::string& path, Reporter& reporter);
}
