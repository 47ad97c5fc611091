// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// Files that are there as a whole or not at all.
#pragma once

#include <string>

class vtkXMLWriter;

namespace penumbra::tool
{
/// Writes in one step: whatever happens, there is the former file or the new one. False where it cannot be written; what VTK
/// says of that is dropped.
bool WriteWhole(vtkXMLWriter* writer, const std::string& path);
}
