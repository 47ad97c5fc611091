// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Lightmaps as VTK's data.
#include "bake/lightmap/LightmapFile.h"

#include <vtkCellArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>

#include <algorithm>
#include <map>

namespace penumbra::lightmap
{
void AddSurfaces(Lightmap& lightmap, const Surfaces& surfaces, const std::vector<Chart>& charts,
  const Atlas& atlas)
{
  lightmap.Origin = surfaces.Center();
  for (const Tile& tile : atlas.Tiles)
  {
    const Chart& chart = charts[tile.Chart];
    // Corners of one point with one normal are one.
    std::map<std::pair<std::uint32_t, std::array<double, 3>>, std::uint32_t> made;
    for (const std::uint32_t t : chart.Triangles)
    {
      const Triangle& triangle = surfaces.Triangles[t];
      glm::uvec3 corners(0);
      for (int k = 0; k < 3; ++k)
      {
        const Vec3 normal = triangle.Normals[k] * (tile.Back ? -1.0 : 1.0);
        const std::uint32_t point = triangle.Points[k];
        const auto found =
          made.emplace(std::make_pair(point, std::array<double, 3>{ normal.x, normal.y, normal.z }),
            static_cast<std::uint32_t>(lightmap.Points.size()));
        if (found.second)
        {
          const Vec3& at = surfaces.Points[point];
          lightmap.Points.emplace_back(at - lightmap.Origin);
          lightmap.Normals.emplace_back(normal);
          const Vec2 place = tile.ToTexels(chart, chart.Project(at)) + Vec2(tile.At) + 0.5;
          lightmap.Places.emplace_back(place / Vec2(atlas.Width, atlas.Height));
        }
        corners[tile.Back ? 2 - k : k] = found.first->second;
      }
      lightmap.Triangles.push_back(corners);
    }
  }
}

vtkSmartPointer<vtkPolyData> MakeSurfaces(const Lightmap& lightmap)
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  const auto count = static_cast<vtkIdType>(lightmap.Points.size());
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(count);
  vtkNew<vtkFloatArray> places;
  places->SetName("places");
  places->SetNumberOfComponents(2);
  places->SetNumberOfTuples(count);
  vtkNew<vtkFloatArray> normals;
  normals->SetName("normals");
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    const auto at = static_cast<std::size_t>(i);
    const Vec3 p = lightmap.Origin + Vec3(lightmap.Points[at]);
    points->SetPoint(i, &p[0]);
    places->SetTypedTuple(i, &lightmap.Places[at][0]);
    normals->SetTypedTuple(i, &lightmap.Normals[at][0]);
  }
  vtkNew<vtkCellArray> cells;
  for (const glm::uvec3& t : lightmap.Triangles)
  {
    const vtkIdType corners[] = { t.x, t.y, t.z };
    cells->InsertNextCell(3, corners);
  }
  data->SetPoints(points);
  data->SetPolys(cells);
  data->GetPointData()->SetTCoords(places);
  data->GetPointData()->SetNormals(normals);
  vtkNew<vtkStringArray> scene;
  scene->SetName("scene");
  scene->InsertNextValue(lightmap.Scene);
  data->GetFieldData()->AddArray(scene);
  return data;
}

vtkSmartPointer<vtkImageData> MakeImage(const Lightmap& lightmap)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  const Light& baked = lightmap.Baked;
  image->SetDimensions(baked.Width, baked.Height, 1);
  image->AllocateScalars(VTK_FLOAT, baked.Channels + lightmap.Lamps.Channels);
  auto* to = static_cast<float*>(image->GetScalarPointer());
  for (std::size_t i = 0; i < std::size_t(baked.Width) * baked.Height; ++i)
  {
    for (const Light* light : { &lightmap.Baked, &lightmap.Lamps })
    {
      for (int c = 0; c < light->Channels; ++c)
      {
        *to++ = light->At(i)[c];
      }
    }
  }
  return image;
}
}
