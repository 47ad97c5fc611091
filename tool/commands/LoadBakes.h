// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// Files of baked light, of any kind, given to the technique that they are for.
#pragma once

#include <string>
#include <vector>

class vtkGIPass;

namespace penumbra::tool
{
class Reporter;

/// Tells each file's kind by what is in it, and switches its technique on. Throws a Failure for one that is none,
/// or is damaged.
void LoadBakes(const std::vector<std::string>& files, vtkGIPass* pass, Reporter& reporter);
}
