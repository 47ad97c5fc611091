// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A small convolutional network that says how to average light: a U-Net (Ronneberger, Fischer and Brox 2015) at half
 * resolution, whose features and bandwidths guide the filter (Isik, Mullia, Fisher, Eisenmann and Gharbi 2021, Interactive
 * Monte Carlo Denoising using Affinity of Neural Features). Weights are part of the shaders' text.
 */
#pragma once

#include "graph/Frame.h"

#include <map>
#include <string>

namespace penumbra
{
class GuideNetwork
{
public:
  static constexpr int Levels = 4; ///< of the U-Net, and of the filter

  bool UsesBuffers = false; ///< whether weights are read from buffers instead
  bool HasRun = false;
  std::string Failure; ///< why the driver does not compile it; "" for nothing

  /// Have a pass write what the network needs.
  static void Declare(PassDeclaration& pass, const Frame& frame);

  /// Run the network on a signal of the pass. Returns whether that succeeded.
  bool Run(FrameContext& context, const Texture* signal);

  /// The textures that guide a level of denoising/filter.frag.
  static Arguments Guides(FrameContext& context, int level);

private:
  void Infer(FrameContext& context, const Texture* signal);
  void Convolve(FrameContext& context, const std::string& layer, const std::string& above,
    const std::string& input, int level);

  std::map<std::string, Buffer> Weights; ///< of parts of layers
};
}
