// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// Files written completely or not at all.
#pragma once

#include <string>

class vtkXMLWriter;

namespace penumbra::tool
{
/// Writes under another name first, so that an existing file stays intact until the new one is complete. Returns false if
/// it cannot be written; VTK's messages are dropped.
bool WriteWhole(vtkXMLWriter* writer, const std::string& path);
}
