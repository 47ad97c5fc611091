// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Formats that bring their own materials: Wavefront OBJ and glTF.
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
/// Runs an importer into a window that is never opened and takes the actors out of it.
Loaded Import(vtkImporter* importer)
{
  vtkNew<vtkGenericOpenGLRenderWindow> window;
  vtkNew<vtkRenderer> renderer;
  window->AddRenderer(renderer);
  importer->SetRenderWindow(window);
  importer->Update();
  Loaded loaded;
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

/// The file named by "mtllib", or "" where there is none; the statement stands near the top.
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

/// VTK's plain reader repeats each point for each face that uses it, where texture coordinates have
/// indices of their own.
Loaded ReadPlainObj(const std::string& path, Step& step)
{
  Loaded loaded = ReadWith<vtkOBJReader>(path, step);
  loaded.PointsRepeated = true;
  return loaded;
}
}

Loaded ReadObj(const std::string& path, Step& step)
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
      fmt::format("the materials of '{}' are left out: '{}' is not beside it", path, library));
    return ReadPlainObj(path, step);
  }
  vtkNew<vtkOBJImporter> importer;
  importer->SetFileName(path.c_str());
  importer->SetFileNameMTL((folder / library).c_str());
  importer->SetTexturePath(folder.c_str());
  return Import(importer);
}

Loaded ReadGltf(const std::string& path, Step&)
{
  vtkNew<vtkGLTFImporter> importer;
  importer->SetFileName(path.c_str());
  return Import(importer);
}
}
