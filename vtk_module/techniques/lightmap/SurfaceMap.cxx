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
  this->TakeSurfaces(bake->GetFieldData());
  this->TakePicture(bake);
}

void SurfaceMap::TakeSurfaces(vtkFieldData* fields)
{
  vtkDataArray* points = fields->GetArray(lightmap_image::Points);
  vtkDataArray* normals = fields->GetArray(lightmap_image::Normals);
  vtkDataArray* places = fields->GetArray(lightmap_image::Places);
  vtkDataArray* triangles = fields->GetArray(lightmap_image::Triangles);
  const vtkIdType count = points ? points->GetNumberOfTuples() : 0;
  if (count == 0 || !triangles || triangles->GetNumberOfTuples() == 0)
  {
    Refuse("it has no surfaces");
  }
  if (!Has(normals, 3, count) || !Has(places, 2, count))
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
    glm::dvec3 at, normal;
    glm::dvec2 place;
    points->GetTuple(i, &at[0]);
    normals->GetTuple(i, &normal[0]);
    places->GetTuple(i, &place[0]);
    this->Points.push_back({ glm::vec3(at - this->Origin), glm::vec3(normal), glm::vec2(place) });
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

void SurfaceMap::TakePicture(vtkImageData* bake)
{
  const int* size = bake->GetDimensions();
  if (size[0] > LargestSide || size[1] > LargestSide)
  {
    Refuse("its picture is larger than 16384 pixels a side; bake it with a smaller --max-size");
  }
  std::array<vtkDataArray*, lightmap_image::Layers.size()> layers{};
  for (std::size_t i = 0; i < layers.size(); ++i)
  {
    const auto& [name, components] = lightmap_image::Layers[i];
    layers[i] = bake->GetPointData()->GetArray(name);
    if (layers[i] && !Has(layers[i], components, bake->GetNumberOfPoints()))
    {
      Refuse("its light is not as long as its picture");
    }
  }
  this->Directional = layers[1] != nullptr;
  this->Lamps = layers[2] != nullptr;
  if (!layers[0] || size[2] != 1 || (layers[3] != nullptr) != (this->Directional && this->Lamps))
  {
    Refuse("its light is no picture, or has moments in part");
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
  this->OnCard = std::make_unique<Uploaded>();
  Uploaded& card = *this->OnCard;
  GLuint name = 0;
  glGenVertexArrays(1, &name);
  card.Layout = VertexArrayHandle(name);
  glBindVertexArray(name);
  card.Points.Upload(GL_ARRAY_BUFFER, this->Points.data(), this->Points.size() * sizeof(Point));
  card.Corners.Upload(
    GL_ELEMENT_ARRAY_BUFFER, this->Corners.data(), this->Corners.size() * sizeof(this->Corners[0]));
  glBindBuffer(GL_ARRAY_BUFFER, card.Points.Get());
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, card.Corners.Get());
  const std::size_t offsets[] = { offsetof(Point, Position), offsetof(Point, Normal),
    offsetof(Point, Place) };
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
  card.Light =
    std::make_unique<Texture>(TextureDesc{ format, this->Width, this->Height, this->Layers });
  glBindTexture(card.Light->Target(), card.Light->Get());
  glTexSubImage3D(card.Light->Target(), 0, 0, 0, 0, this->Width, this->Height, this->Layers,
    GL_RGBA, GL_FLOAT, this->Values.data());
  glBindTexture(card.Light->Target(), 0);
  card.Light->SetParameter(GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  card.Light->SetParameter(GL_TEXTURE_MAG_FILTER, GL_LINEAR);
}

void SurfaceMap::Draw(FrameContext& context, double intensity, bool solid)
{
  this->Old.clear();
  if (!this->OnCard)
  {
    this->Upload();
  }
  const View& view = context.GetView();
  Defines variant;
  if (this->Directional)
  {
    variant["GI_LIGHTMAP_DIRECTIONAL"] = "1";
  }
  if (this->Lamps)
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
      .Sample("lightTexture", this->OnCard->Light.get())
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
  glBindVertexArray(this->OnCard->Layout.Get());
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
  this->OnCard.reset();
  this->Old.clear();
}

void SurfaceMap::TakeOld(SurfaceMap& other)
{
  this->Old = std::move(other.Old);
  if (other.OnCard)
  {
    this->Old.push_back(std::move(other.OnCard));
  }
}
}
