// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// Checks that files are complete where VTK's readers do not notice that the end is missing.
#ifndef penumbra_tool_Completeness_h
#define penumbra_tool_Completeness_h

#include <string>

namespace penumbra::tool
{
/// Each throws a Failure where the file is shorter than its header says, or its compressed data is
/// damaged. What they do not understand they leave to the reader.
void RequireCompleteXml(const std::string& path);
void RequireCompleteStl(const std::string& path);
void RequireCompletePly(const std::string& path);
void RequireCompleteMetaImage(const std::string& path);
void RequireCompleteNrrd(const std::string& path);
void RequireCompleteDem(const std::string& path);
void RequireCompleteNetcdf(const std::string& path);
}

#endif
