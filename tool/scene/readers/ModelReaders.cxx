// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Formats with materials: Wavefront OBJ and glTF.
#include "scene/readers/FormatReaders.h"

#include <vtkActorCollection.h>
#include <vtkGLTFImporter.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkOBJImporter.h>
#include <vtkOBJReader.h>
#include <vtkRenderer.h>
#include <vtkRendererCollection.h>

#include <filesystem>
#include <fstream>

namespace penumbra::tool
{
namespace
{
/// Runs an importer with a window that is never opened, and returns its actors.
LoadedData Import(vtkImporter* importer)
{
  vtkNew<vtkGenericOpenGLRenderWindow> window;
  vtkNew<vtkRenderer> renderer;
  window->AddRenderer(renderer);
  importer->SetRenderWindow(window);
  importer->Update();
  LoadedData loaded;
  loaded.Kind = Content::Actors;
  vtkActorCollection* actors = renderer->GetActors();
  vtkCollectionSimpleIterator cursor;
  actors->InitTraversal(cursor);
  while (vtkActor* actor = actors->GetNextActor(cursor))
  {
    loaded.Actors.emplace_back(actor);
  }
  renderer->RemoveAllViewProps();
  return loaded;
}

/// The file in the statement "mtllib" near the top, or "" if there is none.
std::string MaterialLibrary(const std::string& path)
{
  std::ifstream file(path);
  std::string line;
  constexpr int searched = 1000;
  for (int i = 0; i < searched && std::getline(file, line); ++i)
  {
    if (line.rfind("mtllib ", 0) == 0)
    {
      line.erase(line.find_last_not_of(" \t\r") + 1);
      return line.substr(7);
    }
  }
  return "";
}

/// VTK's plain reader repeats a point for each face that uses it, if texture coordinates have separate indices.
LoadedData ReadPlainObj(const std::string& path, Step& step)
{
  LoadedData loaded = ReadWith<vtkOBJReader>(path, step);
  loaded.PointsRepeated = true;
  return loaded;
}
}

LoadedData ReadObj(const std::string& path, Step& step)
{
  const std::string library = MaterialLibrary(path);
  if (library.empty())
  {
    return ReadPlainObj(path, step);
  }
  const auto folder = std::filesystem::absolute(path).parent_path();
  if (!std::filesystem::exists(folder / library))
  {
    step.Note(
      fmt::format("the materials of '{}' are left out: '{}' is not in its folder", path, library));
    return ReadPlainObj(path, step);
  }
  vtkNew<vtkOBJImporter> importer;
  importer->SetFileName(path.c_str());
  importer->SetFileNameMTL((folder / library).c_str());
  importer->SetTexturePath(folder.c_str());
  return Import(importer);
}

LoadedData ReadGltf(const std::string& path, Step&)
{
  vtkNew<vtkGLTFImporter> importer;
  importer->SetFileName(path.c_str());
  return Import(importer);
}
}
