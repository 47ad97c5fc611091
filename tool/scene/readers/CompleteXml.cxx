// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "scene/readers/Completeness.h"
#include "scene/readers/CompletenessTools.h"

#include <algorithm>
#include <fstream>
#include <iterator>

namespace penumbra::tool
{
void RequireCompleteXml(const std::string& path)
{
  // VTK's parser stops where appended data begins; values past the end it takes as they are.
  std::ifstream file(path, std::ios::binary);
  const std::string end = "</VTKFile>";
  constexpr double searched = 4096;
  const double size = FileSize(path);
  file.seekg(static_cast<std::streamoff>(std::max(0.0, size - searched)));
  const std::string tail{ std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>() };
  if (file && size > 0 && tail.find(end) == std::string::npos)
  {
    Fail(
      "'{}' is damaged or cut off: it does not end with {}; copy or download it again", path, end);
  }
}
}
