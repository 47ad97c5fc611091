// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// Files of baked probes: VTK's own of images (.vti), with what vtkGIProbeBaker puts into them.
#ifndef penumbra_tool_ProbeFile_h
#define penumbra_tool_ProbeFile_h

#include <vtkSmartPointer.h>

#include <string>

class vtkImageData;

namespace penumbra::tool
{
/// In one step: whatever happens, there is the former file or the new one. Throws a Failure.
void WriteProbes(const std::string& path, vtkImageData* field);

/// Throws a Failure with the reason where the file is none, or cut off. Whether what it holds was altered is told where that
/// is used.
vtkSmartPointer<vtkImageData> ReadProbes(const std::string& path);

/// Whether a file is of the kind that holds probes; it may be damaged.
bool IsProbes(const std::string& path);

/// A text that a field carries, or "".
std::string ProbeText(vtkImageData* field, const char* name);
void SetProbeText(vtkImageData* field, const char* name, const std::string& text);
}

#endif
