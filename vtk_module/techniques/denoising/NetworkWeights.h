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
/// A layer of convolutions.
struct NetworkLayer
{
  int Inputs;
  int Outputs;
  /// Weights of each shader, which computes a part of the outputs: biases, then matrices, see glsl/denoising/layer.glsl.
  std::vector<std::vector<float>> Parts;
};

/// By name: e0 to e3 on the way down, d0 to d2 on the way up, out; fine and fine_out, of single pixels, without parts: they are
/// functions of denoising/network/fine.glsl.
const std::map<std::string, NetworkLayer>& NetworkLayers();
}
