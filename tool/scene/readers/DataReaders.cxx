// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// VTK readers that need more than the file name.
#include "scene/readers/Completeness.h"
#include "scene/readers/FormatReaders.h"

#include <vtkExodusIIReader.h>
#include <vtkNIFTIImageReader.h>
#include <vtkNrrdReader.h>

namespace penumbra::tool
{
LoadedData ReadNifti(const std::string& path, Step& step)
{
  vtkNew<vtkNIFTIImageReader> reader;
  reader->SetFileName(path.c_str());
  step.Observe(reader);
  reader->Update();
  LoadedData loaded;
  loaded.Data = reader->GetOutputDataObject(0);
  // If a file has both transformations, the sform is preferred (NIfTI-1 standard).
  vtkMatrix4x4* placed =
    reader->GetSFormMatrix() ? reader->GetSFormMatrix() : reader->GetQFormMatrix();
  if (placed && placed->Determinant() != 0)
  {
    loaded.ToWorld = vtkSmartPointer<vtkMatrix4x4>::New();
    loaded.ToWorld->DeepCopy(placed);
  }
  return loaded;
}

LoadedData ReadNrrd(const std::string& path, Step& step)
{
  vtkNew<vtkNrrdReader> reader;
  return reader->CanReadFile(path.c_str()) ? ReadWith<vtkNrrdReader>(path, step) : LoadedData();
}

LoadedData ReadExodus(const std::string& path, Step& step)
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
  LoadedData loaded;
  loaded.Data = reader->GetOutputDataObject(0);
  return loaded;
}
}
