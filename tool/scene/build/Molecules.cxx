// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "scene/build/Molecules.h"

#include <vtkCellArray.h>
#include <vtkDataSetAttributes.h>
#include <vtkFloatArray.h>
#include <vtkMolecule.h>
#include <vtkMoleculeMapper.h>
#include <vtkNew.h>
#include <vtkOpenGLSphereMapper.h>
#include <vtkPeriodicTable.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkSimpleBondPerceiver.h>
#include <vtkUnsignedCharArray.h>

#include <map>

namespace penumbra::tool
{
namespace
{
using Rgb = std::array<unsigned char, 3>;

/// The usual colours of elements (Corey and Pauling 1953, Koltun 1965), in shades that leave room for light and shadow. Other
/// elements have the colours of the periodic table.
Rgb ElementColor(unsigned short number, vtkPeriodicTable* table)
{
  static const std::map<unsigned short, Rgb> colors = {
    { 1, { 236, 236, 232 } }, // hydrogen
    { 6, { 148, 154, 162 } }, // carbon
    { 7, { 72, 112, 208 } },  // nitrogen
    { 8, { 206, 62, 54 } },   // oxygen
    { 9, { 122, 196, 92 } },  // fluorine
    { 15, { 232, 142, 60 } }, // phosphorus
    { 16, { 232, 196, 70 } }, // sulphur
    { 17, { 84, 178, 84 } },  // chlorine
    { 26, { 196, 108, 58 } }, // iron
  };
  if (const auto found = colors.find(number); found != colors.end())
  {
    return found->second;
  }
  float rgb[3];
  table->GetDefaultRGBTuple(number, rgb);
  Rgb color;
  for (int i = 0; i < 3; ++i)
  {
    color[i] = static_cast<unsigned char>(255 * rgb[i]);
  }
  return color;
}

constexpr double UnknownRadius = 1.7; // of carbon, in Angstrom
}

vtkSmartPointer<vtkPolyData> MakeAtoms(vtkMolecule* molecule)
{
  const vtkIdType count = molecule->GetNumberOfAtoms();
  vtkNew<vtkPeriodicTable> table;
  vtkNew<vtkFloatArray> radii;
  radii->SetName("radius");
  radii->SetNumberOfTuples(count);
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetName("element color");
  colors->SetNumberOfComponents(3);
  colors->SetNumberOfTuples(count);
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> vertices;
  for (vtkIdType i = 0; i < count; ++i)
  {
    const unsigned short number = molecule->GetAtomAtomicNumber(i);
    const float radius = table->GetVDWRadius(number);
    radii->SetValue(i, radius > 0 ? radius : static_cast<float>(UnknownRadius));
    colors->SetTypedTuple(i, ElementColor(number, table).data());
    double position[3];
    molecule->GetAtomPosition(i, position);
    points->InsertNextPoint(position);
    vertices->InsertNextCell(1, &i);
  }
  auto atoms = vtkSmartPointer<vtkPolyData>::New();
  atoms->SetPoints(points);
  atoms->SetVerts(vertices);
  atoms->GetPointData()->ShallowCopy(molecule->GetAtomData());
  atoms->GetPointData()->AddArray(radii);
  atoms->GetPointData()->SetScalars(colors);
  return atoms;
}

vtkSmartPointer<vtkOpenGLSphereMapper> MakeBallMapper(vtkPolyData* points, const char* radiusArray)
{
  auto mapper = vtkSmartPointer<vtkOpenGLSphereMapper>::New();
  mapper->SetInputData(points);
  mapper->SetScaleArray(radiusArray);
  return mapper;
}

vtkSmartPointer<vtkActor> MakeStickModel(vtkMolecule* molecule, MoleculeStyle style)
{
  vtkNew<vtkSimpleBondPerceiver> bonds;
  bonds->SetInputData(molecule);
  bonds->Update();
  vtkNew<vtkMoleculeMapper> mapper;
  mapper->SetInputData(bonds->GetOutput());
  if (style == MoleculeStyle::Sticks)
  {
    mapper->UseLiquoriceStickSettings();
  }
  else
  {
    mapper->UseBallAndStickSettings();
  }
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  return actor;
}
}
