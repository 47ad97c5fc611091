// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Scenes that the pass, with every technique off, must draw like stock VTK.
#pragma once

#include "Stage.h"

#include <iosfwd>

namespace penumbra_test
{
/// A named scene. Its picture must not be empty.
struct ParityCase
{
  const char* Name;
  void (*Build)(Stage&);
  bool Captured = true; ///< whether any pixel comes through the G-buffer
  double Share = 0.999; ///< smallest share of pixels within 2/255 of stock VTK's

  std::string Id() const; ///< the name in letters, digits and underscores
};
void PrintTo(const ParityCase& row, std::ostream* os);

using ParityCases = std::vector<ParityCase>;

ParityCases SurfaceCases();    ///< shading, representations, normals, cell kinds
ParityCases MaterialCases();   ///< scalars, textures, physically based materials, environments
ParityCases MapperCases();     ///< mappers and props other than an actor with polygonal data
ParityCases LightCases();      ///< lights of every type
ParityCases ViewCases();       ///< cameras, viewports, windows, backgrounds, coordinates
ParityCases LayerCases();      ///< translucent props, volumes and images among surfaces
ParityCases AnnotationCases(); ///< text, axes and 2-D props over surfaces
ParityCases CustomCases();     ///< shader code of users, and rare switches
ParityCases AllCases();

/// A tessellated ball without lines of symmetry along the axes of the picture.
vtkSmartPointer<vtkPolyData> Ball(int resolution = 24);

/// A torus, with normals and texture coordinates.
vtkSmartPointer<vtkPolyData> Torus();

/// A checkerboard with gradients in colour: 8 bits, with up to 4 components.
vtkSmartPointer<vtkImageData> Checkerboard(int components = 3);

/// Add the torus and look at it.
vtkActor* AddTorus(Stage& stage, double specular = 0.0, double specularPower = 1.0);
/// Add the torus with a highlight.
vtkActor* AddShinyTorus(Stage& stage);
}
