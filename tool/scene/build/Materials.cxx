// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "scene/build/Materials.h"

#include "scene/build/TextureFiles.h"

#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyDataTangents.h>
#include <vtkProperty.h>
#include <vtkTexture.h>
#include <vtkTriangleFilter.h>

namespace penumbra::tool
{
namespace
{
bool Emits(const Material& material)
{
  return material.Emission != Vec3{ 0, 0, 0 } || !material.EmissionTexture.empty();
}

/// Tangents at the points of faces with any number of corners. vtkPolyDataTangents supports triangles only: the points of
/// other faces get none and turn black.
vtkSmartPointer<vtkDataArray> MakeTangents(vtkPolyData* geometry)
{
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(geometry);
  vtkNew<vtkPolyDataTangents> tangents;
  tangents->SetInputConnection(triangles->GetOutputPort());
  tangents->Update();
  return tangents->GetOutput()->GetPointData()->GetTangents();
}

void ApplyShading(const Material& material, vtkProperty* property)
{
  property->SetInterpolation(material.Shading);
  if (material.Shading == VTK_PBR)
  {
    property->SetMetallic(material.Metallic);
    property->SetBaseIOR(material.RefractiveIndex);
    property->SetRoughness(material.Roughness);
  }
  property->SetColor(material.Color[0], material.Color[1], material.Color[2]);
  property->SetAmbient(material.Ambient);
  property->SetDiffuse(material.Diffuse);
  property->SetSpecular(material.Specular);
  property->SetSpecularPower(material.SpecularPower);
  Vec3 specular = material.SpecularColor.value_or(Vec3{ 1, 1, 1 });
  property->SetSpecularColor(specular.data());
  property->SetOpacity(material.Opacity);
  property->SetLighting(material.Lighting);
  property->SetRepresentation(material.Representation);
  property->SetBackfaceCulling(material.Cull == Culling::Back);
  property->SetFrontfaceCulling(material.Cull == Culling::Front);
  property->SetLineWidth(static_cast<float>(material.LineWidth));
  property->SetPointSize(static_cast<float>(material.PointSize));
  if (material.EdgeColor)
  {
    property->EdgeVisibilityOn();
    Vec3 edges = *material.EdgeColor;
    property->SetEdgeColor(edges.data());
  }
}

/// VTK's PBR shader takes emission from a texture only, its Phong shader from the ambient term.
void ApplyEmission(const Material& material, vtkProperty* property)
{
  Vec3 emission = material.Emission;
  if (material.Shading == VTK_PBR)
  {
    property->SetEmissiveTexture(material.EmissionTexture.empty()
        ? MakeWhiteTexture()
        : ReadTexture(material.EmissionTexture, TextureUse::Color));
    const bool factorGiven = emission != Vec3{ 0, 0, 0 };
    emission = factorGiven ? emission : Vec3{ 1, 1, 1 };
    property->SetEmissiveFactor(emission.data());
    return;
  }
  property->SetAmbient(1);
  property->SetAmbientColor(emission.data());
}

void ApplyTextures(const Material& material, vtkActor* actor)
{
  vtkProperty* property = actor->GetProperty();
  if (!material.Texture.empty() && material.Shading == VTK_PBR)
  {
    property->SetBaseColorTexture(ReadTexture(material.Texture, TextureUse::Color));
  }
  else if (!material.Texture.empty())
  {
    actor->SetTexture(ReadTexture(material.Texture, TextureUse::Data));
  }
  if (!material.NormalTexture.empty())
  {
    property->SetNormalTexture(ReadTexture(material.NormalTexture, TextureUse::Data));
  }
  if (!material.OrmTexture.empty())
  {
    property->SetORMTexture(ReadTexture(material.OrmTexture, TextureUse::Data));
  }
}
}

Material DefaultMaterial(std::size_t index, bool underEnvironment)
{
  static const std::vector<Vec3> palette = {
    { 0.86, 0.80, 0.72 }, // ivory
    { 0.76, 0.42, 0.34 }, // brick
    { 0.40, 0.56, 0.74 }, // steel blue
    { 0.56, 0.68, 0.48 }, // sage
    { 0.85, 0.68, 0.36 }, // ochre
    { 0.60, 0.46, 0.64 }, // plum
    { 0.38, 0.64, 0.62 }, // teal
    { 0.62, 0.60, 0.58 }, // stone
  };
  Material material;
  material.Color = palette[index % palette.size()];
  material.Shading = underEnvironment ? VTK_PBR : VTK_PHONG;
  material.Specular = underEnvironment ? 1 : 0.12;
  material.SpecularPower = 24;
  material.Roughness = 0.45;
  return material;
}

bool HasTextures(const Material& material)
{
  return !(material.Texture.empty() && material.NormalTexture.empty() &&
    material.OrmTexture.empty() && material.EmissionTexture.empty());
}

vtkSmartPointer<vtkPolyData> PrepareGeometry(const Material& material, vtkPolyData* geometry)
{
  vtkPointData* data = geometry->GetPointData();
  auto prepared = vtkSmartPointer<vtkPolyData>::New();
  prepared->ShallowCopy(geometry);
  if (!data->GetTCoords() && Emits(material) && material.Shading == VTK_PBR)
  {
    vtkNew<vtkFloatArray> coordinates;
    coordinates->SetName("texture coordinates");
    coordinates->SetNumberOfComponents(2);
    coordinates->SetNumberOfTuples(geometry->GetNumberOfPoints());
    coordinates->Fill(0.5);
    prepared->GetPointData()->SetTCoords(coordinates);
  }
  if (!material.NormalTexture.empty() && data->GetTCoords() && data->GetNormals() &&
    !data->GetTangents())
  {
    prepared->GetPointData()->SetTangents(MakeTangents(geometry));
  }
  return prepared;
}

void ApplyMaterial(const Material& material, vtkActor* actor)
{
  ApplyShading(material, actor->GetProperty());
  ApplyTextures(material, actor);
  if (Emits(material))
  {
    ApplyEmission(material, actor->GetProperty());
  }
  if (material.BackColor)
  {
    vtkNew<vtkProperty> back;
    back->DeepCopy(actor->GetProperty());
    Vec3 color = *material.BackColor;
    back->SetColor(color.data());
    actor->SetBackfaceProperty(back);
  }
}
}
