// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// The readers in the table of formats.
#pragma once

#include "common/Reporter.h"
#include "scene/model/LoadedData.h"

#include <vtkNew.h>

#include <string>

namespace penumbra::tool
{
/// Reads with a VTK reader that only needs the file name.
template <typename Reader>
LoadedData ReadWith(const std::string& path, Step& step)
{
  vtkNew<Reader> reader;
  reader->SetFileName(path.c_str());
  step.Observe(reader);
  reader->Update();
  LoadedData loaded;
  loaded.Data = reader->GetOutputDataObject(0);
  return loaded;
}

/// Reads with a VTK reader, and checks for damage that it does not detect.
template <typename Reader, void (*Check)(const std::string&, vtkDataObject*)>
LoadedData ReadChecked(const std::string& path, Step& step)
{
  LoadedData loaded = ReadWith<Reader>(path, step);
  Check(path, loaded.Data);
  return loaded;
}

/// Checks a file for damage, and reads it with a VTK reader that would ask for as much memory as the damaged file names.
template <typename Reader, void (*Check)(const std::string&)>
LoadedData ReadAfterCheck(const std::string& path, Step& step)
{
  Check(path);
  return ReadWith<Reader>(path, step);
}

/// Readers that need more.
LoadedData ReadObj(const std::string& path, Step& step);
LoadedData ReadGltf(const std::string& path, Step& step);
LoadedData ReadPdb(const std::string& path, Step& step);
LoadedData ReadNifti(const std::string& path, Step& step);
LoadedData ReadNrrd(const std::string& path, Step& step);
LoadedData ReadExodus(const std::string& path, Step& step);
LoadedData ReadDemHeights(const std::string& path, Step& step);
LoadedData ReadNumpyHeights(const std::string& path, Step& step);
LoadedData ReadPictureHeights(const std::string& path, Step& step);

/// Links ExpatDeferral.cxx, which replaces XML_ParserCreate(). Does nothing else.
void KeepXmlReadable();
}
