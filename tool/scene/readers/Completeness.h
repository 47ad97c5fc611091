// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// Finds files that end early where VTK's readers draw what there is, or zeros, without a word. Other damage is theirs to
/// tell, and where one crashes, the supervisor does.
#pragma once

#include <string>

class vtkDataObject;

namespace penumbra::tool
{
/// Each throws a Failure where the file is shorter than its header and the data that was read from it say. What they do not
/// understand they leave to the reader.
void RequireCompleteXml(const std::string& path, vtkDataObject* data = nullptr);
void RequireCompleteStl(const std::string& path, vtkDataObject* data);
void RequireCompletePly(const std::string& path, vtkDataObject* data);
void RequireCompleteMetaImage(const std::string& path, vtkDataObject* data);
void RequireCompleteDem(const std::string& path);
void RequireCompleteNetcdf(const std::string& path);
}
