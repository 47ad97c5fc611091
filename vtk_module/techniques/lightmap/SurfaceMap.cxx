// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "techniques/lightmap/SurfaceMap.h"

#include "gpu/ScopedState.h"
#include "technique/FrameBuilder.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <glm/gtc/matrix_transform.hpp>

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

[[noreturn]] void Fail(const char* reason)
{
  throw std::invalid_argument(reason);
}
}

SurfaceMap::SurfaceMap(vtkPolyData* surfaces, vtkImageData* light)
{
  if (!surfaces || !light)
  {
    Fail("it needs both surfaces and light");
  }
  vtkDataArray* coordinates = surfaces->GetPointData()->GetTCoords();
  vtkDataArray* normals = surfaces->GetPointData()->GetNormals();
  if (!coordinates || !normals || coordinates->GetNumberOfComponents() != 2 ||
    normals->GetNumberOfComponents() != 3)
  {
    Fail("its surfaces lack texture coordinates or normals");
  }
  double bounds[6];
  surfaces->GetBounds(bounds);
  const glm::dvec3 low(bounds[0], bounds[2], bounds[4]);
  const glm::dvec3 high(bounds[1], bounds[3], bounds[5]);
  this->Origin = 0.5 * (low + high);
  if (!std::isfinite(glm::length(high - low)) || surfaces->GetNumberOfPolys() == 0)
  {
    Fail("it has no surfaces");
  }
  const vtkIdType count = surfaces->GetNumberOfPoints();
  this->Points.resize(static_cast<std::size_t>(count));
  for (vtkIdType i = 0; i < count; ++i)
  {
    glm::dvec3 at, normal;
    surfaces->GetPoint(i, &at[0]);
    normals->GetTuple(i, &normal[0]);
    this->Points[static_cast<std::size_t>(i)] = { glm::vec3(at - this->Origin), glm::vec3(normal),
      glm::vec2(coordinates->GetComponent(i, 0), coordinates->GetComponent(i, 1)) };
  }
  auto cells = vtk::TakeSmartPointer(surfaces->GetPolys()->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    cells->GetCurrentCell(size, ids);
    for (vtkIdType i = 0; i < size; ++i)
    {
      if (size != 3 || ids[i] < 0 || ids[i] >= count)
      {
        Fail("its surfaces are not triangles of its points");
      }
      this->Corners.push_back(static_cast<std::uint32_t>(ids[i]));
    }
  }
  this->TakePicture(light);
}

void SurfaceMap::TakePicture(vtkImageData* light)
{
  constexpr int plain = 3, directional = 12; // twice as many with direct light
  const int channels = light->GetNumberOfScalarComponents();
  vtkDataArray* scalars = light->GetPointData()->GetScalars();
  const int* size = light->GetDimensions();
  this->Directional = channels % directional == 0;
  const int componentsPerPart = this->Directional ? directional : plain;
  this->Lamps = channels == 2 * componentsPerPart;
  if (!scalars || (channels != componentsPerPart && !this->Lamps) || size[2] != 1)
  {
    Fail("its light is no picture of 3 or 12 components, or of twice as many");
  }
  if (size[0] > LargestSide || size[1] > LargestSide)
  {
    Fail("its picture is larger than 16384 pixels a side; bake it with a smaller --max-size");
  }
  this->Width = size[0];
  this->Height = size[1];
  this->Layers = channels / 3;
  const std::size_t pixels = static_cast<std::size_t>(this->Width) * this->Height;
  this->Values.resize(4 * pixels * this->Layers);
  for (std::size_t i = 0; i < pixels; ++i)
  {
    for (int c = 0; c < channels; ++c)
    {
      const double value = scalars->GetComponent(static_cast<vtkIdType>(i), c);
      this->Values[4 * (pixels * (c / 3) + i) + c % 3] =
        std::isfinite(value) ? static_cast<float>(value) : 0.0f;
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
