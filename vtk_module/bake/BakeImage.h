// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What all images of baked light share: texts in their field data, and a checksum.
 */
#pragma once

#include <string>
#include <vector>

class vtkFieldData;
class vtkImageData;

namespace penumbra
{
constexpr const char* BakeFormat = "format";
constexpr const char* BakedSceneText = "scene";

void SetText(vtkFieldData* data, const char* name, const std::string& text);
/// "" where there is none of that name.
std::string GetText(vtkFieldData* data, const char* name);

/// Names of the arrays that a checksum covers. Other arrays may be added to an image freely.
struct BakeArrays
{
  std::vector<const char*> Texts, Fields, Points;
};

/// Adds the checksum of the image's grid and arrays.
void SealBake(vtkImageData* image, const BakeArrays& arrays);
/// Throws std::invalid_argument where the checksum does not fit.
void RequireSealed(vtkImageData* image, const BakeArrays& arrays);
}
