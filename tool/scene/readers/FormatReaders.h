// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// The readers behind the table of formats.
#pragma once

#include "common/Reporter.h"
#include "scene/model/Loaded.h"

#include <vtkNew.h>

#include <string>

namespace penumbra::tool
{
/// Reads with a VTK reader that needs nothing but the file's name.
template <typename Reader>
Loaded ReadWith(const std::string& path, Step& step)
{
  vtkNew<Reader> reader;
  reader->SetFileName(path.c_str());
  step.Observe(reader);
  reader->Update();
  Loaded loaded;
  loaded.Data = reader->GetOutputDataObject(0);
  return loaded;
}

/// As ReadWith, with a check that finds what the reader does not notice.
template <typename Reader, void (*Check)(const std::string&, vtkDataObject*)>
Loaded ReadChecked(const std::string& path, Step& step)
{
  Loaded loaded = ReadWith<Reader>(path, step);
  Check(path, loaded.Data);
  return loaded;
}

/// As ReadWith, for pictures whose values are elevations.
Loaded ReadObj(const std::string& path, Step& step);
Loaded ReadGltf(const std::string& path, Step& step);
Loaded ReadPdb(const std::string& path, Step& step);
Loaded ReadNifti(const std::string& path, Step& step);
Loaded ReadNrrd(const std::string& path, Step& step);
Loaded ReadExodus(const std::string& path, Step& step);
Loaded ReadDemHeights(const std::string& path, Step& step);
Loaded ReadNumpyHeights(const std::string& path, Step& step);
Loaded ReadPictureHeights(const std::string& path, Step& step);
}
