// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Properties of a prop that are known before it is drawn. They hold for an assembly if they hold for any of its parts.
 */
#pragma once

class vtkActor;
class vtkProp;

namespace penumbra
{
/// Whether a prop's mapper writes the G-buffer through the render pass hooks. For an assembly, all parts must do so.
bool CanCapture(vtkProp* prop);

/// Whether the G-buffer needs the targets for textures and PBR.
bool NeedsExtended(vtkProp* prop);

/// Whether some part is a PBR material, which VTK encodes for display.
bool IsPBR(vtkProp* prop);

/// Whether the highlight, facing the eye, reflects at least this share of light from all around.
bool ReflectsShare(vtkProp* prop, double share);

/// Whether fragments drawn as opaque may have an alpha below one: if the actor is forced opaque, or by the textures of
/// its property, which VTK does not check.
bool MayHavePartialCoverage(vtkProp* prop);

/// Whether a captured prop may write anything to the G-buffer's ambient target: reflected ambient
/// light, or its colour if it is shown as drawn. environment: whether images light PBR materials. True if this is
/// not known for certain.
bool MayHaveAmbient(vtkProp* prop, bool environment);

/// Whether colours from data replace the colour of an actor's property.
bool IsColoredByData(vtkActor* actor);
}
