// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// Detects truncated files for which VTK's readers silently return what there is, or zeros. The readers report other damage,
/// and the supervisor reports their crashes.
#pragma once

#include <string>

class vtkDataObject;

namespace penumbra::tool
{
/// Each throws a Failure if the file is shorter than its header and the data read from it, if there are any, imply. Files that they do not
/// understand are left to the reader.
void RequireCompleteXml(const std::string& path, vtkDataObject* data = nullptr);
void RequireCompletePly(const std::string& path, vtkDataObject* data);
void RequireCompleteMetaImage(const std::string& path, vtkDataObject* data);
void RequireCompleteStl(const std::string& path);
void RequireCompleteDem(const std::string& path);
void RequireCompleteNetcdf(const std::string& path);
}
