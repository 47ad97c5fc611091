// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What can be told of a prop before it is drawn. Of an assembly, of any of its parts.
 */
#pragma once

class vtkProp;

namespace penumbra
{
/// Whether a prop's mapper writes the G-buffer through the render pass hooks; of an assembly, whether all parts' do.
bool CanCapture(vtkProp* prop);

/// Whether the G-buffer needs what textures and physically based materials add to it.
bool NeedsExtended(vtkProp* prop);

/// Whether the highlight reflects this share of light from all around or more, facing the eye.
bool ReflectsShare(vtkProp* prop, double share);

/// Whether opaque fragments may have an alpha below one: VTK looks at neither where the actor is forced opaque, nor at
/// the textures of its property.
bool MayCoverInPart(vtkProp* prop);

/// Whether a prop that is captured may leave anything in the G-buffer's ambient target: what it reflects of ambient
/// light, or its colour where VTK draws it as it is. environment: images light physically based materials. Of what is
/// not known for certain, it may.
bool MayHaveAmbient(vtkProp* prop, bool environment);
}
