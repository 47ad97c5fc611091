// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "common/WholeFile.h"

#include "common/VtkMessages.h"

#include <vtkXMLWriter.h>

#include <filesystem>

namespace penumbra::tool
{
bool WriteWhole(vtkXMLWriter* writer, const std::string& path)
{
  const std::string half = path + ".half";
  writer->SetFileName(half.c_str());
  const bool written = writer->Write() != 0 && TakeVtkMessages().Errors.empty();
  std::error_code error, ignored;
  if (written)
  {
    std::filesystem::rename(half, path, error);
  }
  if (!written || error)
  {
    std::filesystem::remove(half, ignored);
    TakeVtkMessages();
    return false;
  }
  return true;
}
}
