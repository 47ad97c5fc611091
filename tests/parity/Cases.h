// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Scenes of which the pass, with every technique off, must draw stock VTK's picture.
#pragma once

#include "Stage.h"

#include <iosfwd>

namespace penumbra_test
{
/// A scene as data. The picture must show something, and where Captured is set some of its pixels
/// must have come through the G-buffer.
struct ParityCase
{
  const char* Name;
  void (*Build)(Stage&);
  bool Captured = true;
  double Share = 0.999; ///< least share of pixels within 2/255 of stock VTK's

  std::string Id() const; ///< the name in letters, digits and underscores
};
void PrintTo(const ParityCase& row, std::ostream* os);

using ParityCases = std::vector<ParityCase>;

ParityCases SurfaceCases();    ///< shading, representations, normals, cell kinds
ParityCases MaterialCases();   ///< scalars, textures, physically based materials, environments
ParityCases MapperCases();     ///< the mappers and props beside a polydata mapper's actor
ParityCases LightCases();      ///< the lights
ParityCases ViewCases();       ///< cameras, viewports, windows, backgrounds, coordinates
ParityCases LayerCases();      ///< translucent props, volumes and images among surfaces
ParityCases AnnotationCases(); ///< text, axes and 2-D props over surfaces
ParityCases CustomCases();     ///< the user's own shader code, and rare switches
ParityCases AllCases();

/// A tessellated ball without lines of symmetry along the axes of the picture.
vtkSmartPointer<vtkPolyData> Ball(int resolution = 24);

/// A torus, with normals and texture coordinates.
vtkSmartPointer<vtkPolyData> Torus();

/// A smooth colourful image: 8 bits, with 3 or 4 components.
vtkSmartPointer<vtkImageData> Checks(int components = 3);
}
