// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "scene/readers/Formats.h"

#include "common/Failure.h"
#include "common/Names.h"
#include "common/VtkMessages.h"
#include "scene/readers/CleanGeometry.h"
#include "scene/readers/Completeness.h"
#include "scene/readers/FormatReaders.h"
#include "scene/readers/StandingAxis.h"

#include <vtkGenericDataObjectReader.h>
#include <vtkMetaImageReader.h>
#include <vtkPLYReader.h>
#include <vtkSLCReader.h>
#include <vtkSTLReader.h>
#include <vtkXMLImageDataReader.h>
#include <vtkXMLMultiBlockDataReader.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLRectilinearGridReader.h>
#include <vtkXMLStructuredGridReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <filesystem>
#include <fstream>

namespace penumbra::tool
{
namespace
{
struct Format
{
  std::string Extension; ///< with the dot, in lower case
  std::string Description;
  LoadedData (*Read)(const std::string& path, Step& step);
  DefaultView View;
};

template <typename Reader>
constexpr auto ReadXml = ReadChecked<Reader, RequireCompleteXml>;

/// Maximum reading time in seconds: some readers never return for damaged files. The slowest formats (text, XML) take a
/// tenth of a second per megabyte.
double ReadingLimit(const std::string& path)
{
  constexpr double least = 10, secondsPerByte = 1e-6;
  std::error_code error;
  const auto size = std::filesystem::file_size(path, error);
  return least + (error ? 0 : secondsPerByte * static_cast<double>(size));
}

const std::vector<Format>& Formats()
{
  static const std::vector<Format> formats = {
    { ".vti", "VTK image data", ReadXml<vtkXMLImageDataReader>, SimulationView },
    { ".vtp", "VTK polygonal data", ReadXml<vtkXMLPolyDataReader>, ModelView },
    { ".vtu", "VTK unstructured grid", ReadXml<vtkXMLUnstructuredGridReader>, SimulationView },
    { ".vtr", "VTK rectilinear grid", ReadXml<vtkXMLRectilinearGridReader>, SimulationView },
    { ".vts", "VTK structured grid", ReadXml<vtkXMLStructuredGridReader>, SimulationView },
    { ".vtm", "VTK multi-block data", ReadXml<vtkXMLMultiBlockDataReader>, SimulationView },
    { ".vtk", "VTK legacy file", ReadWith<vtkGenericDataObjectReader>, SimulationView },
    { ".ply", "Stanford polygons", ReadChecked<vtkPLYReader, RequireCompletePly>, ModelView },
    { ".stl", "stereolithography", ReadAfterCheck<vtkSTLReader, RequireCompleteStl>,
      SimulationView },
    { ".obj", "Wavefront object, with its materials", ReadObj, ModelView },
    { ".glb", "glTF 2.0, binary", ReadGltf, ModelView },
    { ".gltf", "glTF 2.0", ReadGltf, ModelView },
    { ".pdb", "Protein Data Bank", ReadPdb, ModelView },
    { ".nii", "NIfTI volume", ReadNifti, PatientView },
    { ".nii.gz", "NIfTI volume, compressed", ReadNifti, PatientView },
    { ".mha", "MetaImage volume", ReadChecked<vtkMetaImageReader, RequireCompleteMetaImage>,
      SimulationView },
    { ".mhd", "MetaImage volume with a header of its own",
      ReadChecked<vtkMetaImageReader, RequireCompleteMetaImage>, SimulationView },
    { ".nrrd", "nearly raw raster data", ReadNrrd, SimulationView },
    { ".slc", "SLC volume", ReadWith<vtkSLCReader>, SimulationView },
    { ".ex2", "Exodus II", ReadExodus, SimulationView },
    { ".e", "Exodus II", ReadExodus, SimulationView },
    { ".exo", "Exodus II", ReadExodus, SimulationView },
    { ".dem", "USGS elevation", ReadDemHeights, LandView },
    { ".npz", "NumPy archive with an elevation array", ReadNumpyHeights, LandView },
    { ".npy", "NumPy elevation array", ReadNumpyHeights, LandView },
    { ".png", "elevation picture", ReadPictureHeights, LandView },
    { ".jpg", "elevation picture", ReadPictureHeights, LandView },
    { ".jpeg", "elevation picture", ReadPictureHeights, LandView },
    { ".tif", "elevation picture", ReadPictureHeights, LandView },
    { ".tiff", "elevation picture", ReadPictureHeights, LandView },
  };
  return formats;
}

/// The row for a file name, or nullptr. The longest extension wins (".nii.gz").
const Format* FindFormat(const std::string& path)
{
  const std::string lower = Lower(path);
  const Format* found = nullptr;
  for (const Format& format : Formats())
  {
    const std::string& end = format.Extension;
    const bool fits =
      lower.size() > end.size() && lower.compare(lower.size() - end.size(), end.size(), end) == 0;
    if (fits && (!found || end.size() > found->Extension.size()))
    {
      found = &format;
    }
  }
  return found;
}
}

void RequireReadableFile(const std::string& path)
{
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status))
  {
    Fail("'{}' does not exist: check the name and the folder", path);
  }
  if (std::filesystem::is_directory(status))
  {
    Fail("'{}' is a folder: name a file in it", path);
  }
  if (std::filesystem::is_regular_file(status) && std::filesystem::file_size(path, error) == 0)
  {
    Fail("'{}' is empty (0 bytes): copy or download it again", path);
  }
  if (!std::ifstream(path))
  {
    Fail("'{}' cannot be opened: check that you may read it", path);
  }
}

LoadedData Load(const std::string& path, Reporter& reporter)
{
  KeepXmlReadable();
  RequireReadableFile(path);
  const Format* format = FindFormat(path);
  if (!format)
  {
    std::vector<std::string> known;
    for (const Format& row : Formats())
    {
      known.push_back(row.Extension.substr(1));
    }
    Fail("'{}' has no supported format: convert it to one of {}", path, Join(known));
  }
  TakeVtkMessages();
  const std::string damaged =
    fmt::format("'{}' cannot be read as {}: it is damaged, cut off or in another format", path,
      format->Description);
  LoadedData loaded;
  try
  {
    Step step(reporter, fmt::format("reading '{}'", path), ReadingLimit(path));
    loaded = format->Read(path, step);
  }
  catch (const Failure&)
  {
    throw;
  }
  catch (const std::bad_alloc&)
  {
    Fail("{} (it asks for more memory than this machine has)", damaged);
  }
  catch (const std::exception& error)
  {
    Fail("{} ({})", damaged, error.what());
  }
  ThrowVtkErrors(damaged);
  if (!HasValidCells(loaded.Data))
  {
    Fail("{} (its cells are not where the file says)", damaged);
  }
  loaded.View = format->View;
  if (auto* polygons = vtkPolyData::SafeDownCast(loaded.Data))
  {
    DroppedPoints notedWhenBuilt;
    const auto usable = DropNonFinite(polygons, notedWhenBuilt);
    const Standing standing = FindStanding(usable, format->View, format->Extension == ".vtp");
    loaded.View = standing.View;
    if (standing.Reason)
    {
      reporter.Note(fmt::format("'{}' stands along {}, because {}: give --camera up=X,Y,Z for "
                                "another axis",
        path, standing.View.Up[2] > 0 ? "z" : "y", standing.Reason));
    }
  }
  if (!loaded.Data && loaded.Actors.empty())
  {
    Fail("{}", damaged);
  }
  return loaded;
}
}
