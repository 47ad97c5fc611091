// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// VTK readers that need more than the file's name.
#include "scene/readers/Completeness.h"
#include "scene/readers/FormatReaders.h"

#include <vtkExodusIIReader.h>
#include <vtkNIFTIImageReader.h>
#include <vtkNrrdReader.h>

namespace penumbra::tool
{
Loaded ReadNifti(const std::string& path, Step& step)
{
  vtkNew<vtkNIFTIImageReader> reader;
  reader->SetFileName(path.c_str());
  step.Observe(reader);
  reader->Update();
  Loaded loaded;
  loaded.Data = reader->GetOutputDataObject(0);
  // The sform is the better of the two placements where a file has both (NIfTI-1 standard).
  vtkMatrix4x4* placed =
    reader->GetSFormMatrix() ? reader->GetSFormMatrix() : reader->GetQFormMatrix();
  if (placed && placed->Determinant() != 0)
  {
    loaded.ToWorld = vtkSmartPointer<vtkMatrix4x4>::New();
    loaded.ToWorld->DeepCopy(placed);
  }
  return loaded;
}

Loaded ReadNrrd(const std::string& path, Step& step)
{
  vtkNew<vtkNrrdReader> asks;
  return asks->CanReadFile(path.c_str()) ? ReadWith<vtkNrrdReader>(path, step) : Loaded();
}

Loaded ReadExodus(const std::string& path, Step& step)
{
  RequireCompleteNetcdf(path);
  vtkNew<vtkExodusIIReader> reader;
  reader->SetFileName(path.c_str());
  step.Observe(reader);
  reader->UpdateInformation();
  for (int type : { vtkExodusIIReader::NODAL, vtkExodusIIReader::ELEM_BLOCK })
  {
    reader->SetAllArrayStatus(type, 1);
  }
  reader->Update();
  Loaded loaded;
  loaded.Data = reader->GetOutputDataObject(0);
  return loaded;
}
}
