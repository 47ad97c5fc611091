// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The network's layers with their weights. The source is generated from glsl/denoising/network.txt.
 */
#pragma once

#include <map>
#include <string>
#include <vector>

namespace penumbra
{
/// What a shader computes of a layer.
struct NetworkPart
{
  int FirstOutput;            ///< in fours
  std::vector<float> Weights; ///< biases, then matrices, see glsl/denoising/layer.glsl
};

/// A layer of 3x3 convolutions.
struct NetworkLayer
{
  int Inputs;
  int Outputs;
  std::vector<NetworkPart> Parts;
};

/// By name: e0 to e3 on the way down, d0 to d2 on the way up, out.
const std::map<std::string, NetworkLayer>& NetworkLayers();
}
