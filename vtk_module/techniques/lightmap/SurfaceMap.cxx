// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "techniques/lightmap/SurfaceMap.h"

#include "gpu/ScopedState.h"
#include "technique/FrameBuilder.h"
#include "techniques/lightmap/LightmapImage.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <glm/gtc/matrix_transform.hpp>

#include <array>
#include <cmath>
#include <stdexcept>

namespace penumbra
{
namespace
{
constexpr int LargestSide = 16384; // texture size that every OpenGL 4.3 implementation supports

// Offset by which a surface may lie behind VTK's depth, because another shader program rounds differently: a fraction
// of a pixel on slopes, and steps of the depth buffer. It is about the same as in lightmap/surface.frag, which uses
// the sum of the slopes along both axes, while this applies to the steeper one only.
constexpr GLfloat Pixels = 0.03f;
constexpr GLfloat Digits = 4.0f;

bool Has(vtkDataArray* array, int components, vtkIdType tuples)
{
  return array && array->GetNumberOfComponents() == components &&
    array->GetNumberOfTuples() == tuples;
}

[[noreturn]] void Refuse(const char* reason)
{
  throw std::invalid_argument(reason);
}
}

SurfaceMap::SurfaceMap(vtkImageData* bake)
{
  this->ReadSurfaces(bake->GetFieldData());
  this->ReadLight(bake);
}

void SurfaceMap::ReadSurfaces(vtkFieldData* fields)
{
  vtkDataArray* points = fields->GetArray(lightmap_image::Points);
  vtkDataArray* normals = fields->GetArray(lightmap_image::Normals);
  vtkDataArray* texturePoints = fields->GetArray(lightmap_image::Places);
  vtkDataArray* triangles = fields->GetArray(lightmap_image::Triangles);
  const vtkIdType count = points ? points->GetNumberOfTuples() : 0;
  if (count == 0 || !triangles || triangles->GetNumberOfTuples() == 0)
  {
    Refuse("it has no surfaces");
  }
  if (!Has(normals, 3, count) || !Has(texturePoints, 2, count))
  {
    Refuse("its surfaces lack texture coordinates or normals");
  }
  if (!Has(points, 3, count) || !Has(triangles, 3, triangles->GetNumberOfTuples()))
  {
    Refuse("its surfaces are not triangles of its points");
  }
  glm::dvec3 low, high;
  for (int axis = 0; axis < 3; ++axis)
  {
    double range[2];
    points->GetRange(range, axis);
    low[axis] = range[0];
    high[axis] = range[1];
  }
  this->Origin = 0.5 * (low + high);
  if (!std::isfinite(glm::length(high - low)))
  {
    Refuse("it has no surfaces");
  }
  for (vtkIdType i = 0; i < count; ++i)
  {
    glm::dvec3 position, normal;
    glm::dvec2 texturePoint;
    points->GetTuple(i, &position[0]);
    normals->GetTuple(i, &normal[0]);
    texturePoints->GetTuple(i, &texturePoint[0]);
    this->Points.push_back(
      { glm::vec3(position - this->Origin), glm::vec3(normal), glm::vec2(texturePoint) });
  }
  for (vtkIdType i = 0; i < 3 * triangles->GetNumberOfTuples(); ++i)
  {
    const double corner = triangles->GetComponent(i / 3, static_cast<int>(i % 3));
    if (!(corner >= 0.0 && corner < static_cast<double>(count)))
    {
      Refuse("its surfaces are not triangles of its points");
    }
    this->Corners.push_back(static_cast<std::uint32_t>(corner));
  }
}

void SurfaceMap::ReadLight(vtkImageData* bake)
{
  const int* size = bake->GetDimensions();
  if (size[0] > LargestSide || size[1] > LargestSide)
  {
    Refuse("its picture is more than 16384 pixels wide or high; bake it with a smaller --max-size");
  }
  std::array<vtkDataArray*, lightmap_image::Layers.size()> layers{};
  for (std::size_t i = 0; i < layers.size(); ++i)
  {
    const auto& [name, components] = lightmap_image::Layers[i];
    layers[i] = bake->GetPointData()->GetArray(name);
    if (layers[i] && !Has(layers[i], components, bake->GetNumberOfPoints()))
    {
      Refuse("its arrays of light do not have one value per pixel");
    }
  }
  this->Directional = layers[1] != nullptr;
  this->DirectLight = layers[2] != nullptr;
  if (!layers[0] || size[2] != 1 ||
    (layers[3] != nullptr) != (this->Directional && this->DirectLight))
  {
    Refuse("its light is not a picture, or some of its moments are missing");
  }
  this->Width = size[0];
  this->Height = size[1];
  const std::size_t pixels = static_cast<std::size_t>(this->Width) * this->Height;
  for (vtkDataArray* layer : layers)
  {
    for (int first = 0; layer && first < layer->GetNumberOfComponents(); first += 3)
    {
      const std::size_t begin = 4 * pixels * this->Layers++;
      this->Values.resize(begin + 4 * pixels);
      for (std::size_t i = 0; i < 3 * pixels; ++i)
      {
        const double value =
          layer->GetComponent(static_cast<vtkIdType>(i / 3), first + static_cast<int>(i % 3));
        this->Values[begin + 4 * (i / 3) + i % 3] =
          std::isfinite(value) ? static_cast<float>(value) : 0.0f;
      }
    }
  }
}

void SurfaceMap::Upload()
{
  this->Gpu = std::make_unique<GpuResources>();
  GpuResources& gpu = *this->Gpu;
  GLuint name = 0;
  glGenVertexArrays(1, &name);
  gpu.Layout = VertexArrayHandle(name);
  glBindVertexArray(name);
  gpu.Points.Upload(GL_ARRAY_BUFFER, this->Points.data(), this->Points.size() * sizeof(Point));
  gpu.Corners.Upload(
    GL_ELEMENT_ARRAY_BUFFER, this->Corners.data(), this->Corners.size() * sizeof(this->Corners[0]));
  glBindBuffer(GL_ARRAY_BUFFER, gpu.Points.Get());
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, gpu.Corners.Get());
  const std::size_t offsets[] = { offsetof(Point, Position), offsetof(Point, Normal),
    offsetof(Point, TexturePoint) };
  for (GLuint i = 0; i < 3; ++i)
  {
    glEnableVertexAttribArray(i);
    glVertexAttribPointer(i, i < 2 ? 3 : 2, GL_FLOAT, GL_FALSE, sizeof(Point),
      reinterpret_cast<const void*>(offsets[i]));
  }
  glBindVertexArray(0);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  // RGB9_E5 has no sign, so it suits light, but not its moments.
  const GLenum format = this->Layers == 1 ? GL_RGB9_E5 : GL_RGBA16F;
  gpu.Light =
    std::make_unique<Texture>(TextureDesc{ format, this->Width, this->Height, this->Layers });
  glBindTexture(gpu.Light->Target(), gpu.Light->Get());
  glTexSubImage3D(gpu.Light->Target(), 0, 0, 0, 0, this->Width, this->Height, this->Layers, GL_RGBA,
    GL_FLOAT, this->Values.data());
  glBindTexture(gpu.Light->Target(), 0);
  gpu.Light->SetParameter(GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  gpu.Light->SetParameter(GL_TEXTURE_MAG_FILTER, GL_LINEAR);
}

void SurfaceMap::Draw(FrameContext& context, double intensity, bool solid)
{
  this->Retired.clear();
  if (!this->Gpu)
  {
    this->Upload();
  }
  const View& view = context.GetView();
  Defines variant;
  if (this->Directional)
  {
    variant["GI_LIGHTMAP_DIRECTIONAL"] = "1";
  }
  if (this->DirectLight)
  {
    variant["GI_LIGHTMAP_LAMPS"] = "1";
  }
  if (!solid)
  {
    variant["GI_LIGHTMAP_HOLES"] = "1";
  }
  const glm::dmat4 toView = glm::translate(view.WorldToView, this->Origin);
  context.Use(context.Shaders().Raster("lightmap/surface.vert", "lightmap/surface.frag", variant),
    Arguments()
      .Sample("lightTexture", this->Gpu->Light.get())
      .Set("mapToClip", glm::mat4(view.ViewToClip * toView))
      .Set("viewToWorld", glm::mat3(glm::dmat3(view.ViewToWorld)))
      .Set("intensity", intensity));
  // Triangles are visible only from the side that they were baked for.
  ScopedState scope(context.State());
  scope.Set(GL_CULL_FACE, true);
  context.State()->vtkglCullFace(GL_BACK);
  if (solid)
  {
    scope.Set(GL_DEPTH_TEST, true);
    scope.DepthFunc(GL_LEQUAL);
    glEnable(GL_POLYGON_OFFSET_FILL); // VTK's state cache does not track it
    glPolygonOffset(-Pixels, -Digits);
  }
  glBindVertexArray(this->Gpu->Layout.Get());
  glDrawElements(
    GL_TRIANGLES, static_cast<GLsizei>(this->Corners.size()), GL_UNSIGNED_INT, nullptr);
  glBindVertexArray(0);
  if (solid)
  {
    glPolygonOffset(0.0f, 0.0f);
    glDisable(GL_POLYGON_OFFSET_FILL);
  }
}

void SurfaceMap::Release()
{
  this->Gpu.reset();
  this->Retired.clear();
}

void SurfaceMap::TakeResources(SurfaceMap& other)
{
  this->Retired = std::move(other.Retired);
  if (other.Gpu)
  {
    this->Retired.push_back(std::move(other.Gpu));
  }
}
}
