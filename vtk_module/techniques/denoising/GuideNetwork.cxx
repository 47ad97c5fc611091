// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "techniques/denoising/GuideNetwork.h"

#include "techniques/denoising/NetworkWeights.h"

#include "denoising.h"

#include <stdexcept>

namespace penumbra
{
namespace
{
constexpr int Levels = GuideNetwork::Levels;
constexpr int Inputs = 16; // numbers for each pixel

constexpr const char* Prefix = "denoising.network.";
constexpr const char* Tiles = "denoising.network.tiles";
constexpr const char* Features = "denoising.network.features";

const std::string First = "inputs";
const std::string Last = "out";
const std::string Fine = "fine"; // of single pixels

// A texture for each level of the filter: software OpenGL reads them faster than layers.
std::string Counts(int level)
{
  return "counts" + std::to_string(level);
}
std::string Encoder(int level)
{
  return "e" + std::to_string(level);
}
std::string Pooled(int level)
{
  return "pooled" + std::to_string(level);
}
// On the way up layers are numbered from the smallest one.
std::string Decoder(int level)
{
  return "d" + std::to_string(Levels - 2 - level);
}

glm::ivec2 SizeAt(const glm::ivec2& pixels, int level)
{
  const int block = 2 << level;
  return (pixels + block - 1) / block;
}

int ChannelsOf(const std::string& layer)
{
  return NetworkLayers().at(layer).Outputs;
}

const Texture* OutputOf(FrameContext& context, const std::string& layer)
{
  return context.Output((Prefix + layer).c_str());
}

glm::ivec2 PixelsOf(FrameContext& context)
{
  return { context.GetView().Viewport.z, context.GetView().Viewport.w };
}

void Pool(FrameContext& context, const std::string& from, const std::string& to, int level)
{
  const glm::ivec2 size = SizeAt(PixelsOf(context), level);
  context.Dispatch("denoising/pool.comp", {},
    Arguments()
      .Sample("activations", OutputOf(context, from))
      .Image("result", *OutputOf(context, to), ShaderAccess::Write)
      .Set("size", size),
    Work::Items((size.x + 1) / 2, (size.y + 1) / 2));
}
}

void GuideNetwork::Declare(PassDeclaration& pass, const Frame& frame)
{
  const glm::ivec2 window = frame.GetView().WindowSize;
  const auto write = [&](const std::string& name, int channels, int level) {
    const glm::ivec2 size = SizeAt(window, level);
    pass.Write(Prefix + name, { GL_RGBA16F, size.x, size.y, channels / 4 });
  };
  const glm::ivec2 tiles = (window + GI_DENOISING_TILE - 1) / GI_DENOISING_TILE;
  pass.Write(Tiles, { GL_RG32F, tiles.x, tiles.y, 0 });
  write(First, Inputs, 0);
  for (int level = 0; level < Levels; ++level)
  {
    write(Encoder(level), ChannelsOf(Encoder(level)), level);
    if (level + 1 < Levels)
    {
      write(Pooled(level + 1), ChannelsOf(Encoder(level)), level + 1);
      write(Decoder(level), ChannelsOf(Decoder(level)), level);
    }
  }
  write(Last, ChannelsOf(Last), 0);
  pass.Write(Prefix + Fine, { GL_RGBA16F, window.x, window.y, ChannelsOf(Fine) / 4 })
    .Write(Features, frame.WindowTexture(GL_RGBA16F));
  for (int level = 0; level < Levels; ++level)
  {
    pass.Write(Prefix + Counts(level), frame.WindowTexture(GL_RGBA16F));
  }
}

void GuideNetwork::Convolve(FrameContext& context, const std::string& layer,
  const std::string& above, const std::string& input, int level)
{
  Defines variant;
  const glm::ivec2 size = SizeAt(PixelsOf(context), level);
  Arguments arguments = Arguments()
                          .Sample("activations", OutputOf(context, input))
                          .Image("result", *OutputOf(context, layer), ShaderAccess::Write)
                          .Set("size", size);
  if (!above.empty())
  {
    arguments.Sample("above", OutputOf(context, above));
  }
  int number = 0;
  for (const std::vector<float>& values : NetworkLayers().at(layer).Parts)
  {
    const std::string name = layer + "_" + std::to_string(number++);
    if (this->UsesBuffers)
    {
      Buffer& weights = this->Weights[name];
      if (weights.Get() == 0)
      {
        weights.Upload(GL_UNIFORM_BUFFER, values.data(), values.size() * sizeof(float));
      }
      variant["GI_WEIGHTS_BUFFER"] = "1";
      arguments.Block("GiWeights", weights);
    }
    context.Dispatch(
      "denoising/network/" + name + ".comp", variant, arguments, Work::Items(size.x, size.y));
  }
}

void GuideNetwork::Infer(FrameContext& context, const Texture* signal)
{
  const glm::ivec2 pixels = PixelsOf(context);
  const glm::ivec2 tiles = (pixels + GI_DENOISING_TILE - 1) / GI_DENOISING_TILE;
  const glm::ivec2 blocks = SizeAt(pixels, 0);
  context.Dispatch("denoising/tiles.comp", {},
    Arguments()
      .Sample("signalTexture", signal)
      .Image("tiles", *context.Output(Tiles), ShaderAccess::Write),
    Work::Items(tiles.x, tiles.y));
  context.Dispatch("denoising/inputs.comp", {},
    Arguments()
      .Sample("signalTexture", signal)
      .Sample("tileTexture", context.Output(Tiles))
      .Image("inputs", *OutputOf(context, First), ShaderAccess::Write)
      .Image("fine", *OutputOf(context, Fine), ShaderAccess::Write),
    Work::Items(blocks.x, blocks.y));
  for (int level = 0; level < Levels; ++level)
  {
    if (level > 0)
    {
      Pool(context, Encoder(level - 1), Pooled(level), level - 1);
    }
    this->Convolve(context, Encoder(level), {}, level > 0 ? Pooled(level) : First, level);
  }
  std::string above = Encoder(Levels - 1);
  for (int level = Levels - 2; level >= 0; --level)
  {
    this->Convolve(context, Decoder(level), above, Encoder(level), level);
    above = Decoder(level);
  }
  this->Convolve(context, Last, {}, above, 0);
  std::vector<Attachment> targets = { { context.Output(Features), -1 } };
  for (int level = 0; level < Levels; ++level)
  {
    targets.push_back({ OutputOf(context, Counts(level)), -1 });
  }
  context.BindTarget(targets, {});
  context.DrawBound("denoising/guides.frag", {},
    Arguments().Sample("outputs", OutputOf(context, Last)).Sample("fine", OutputOf(context, Fine)));
}

Arguments GuideNetwork::Guides(FrameContext& context, int level)
{
  return Arguments()
    .Sample("featureTexture", context.Output(Features))
    .Sample("countTexture", OutputOf(context, Counts(level)));
}

bool GuideNetwork::Run(FrameContext& context, const Texture* signal)
{
  try
  {
    this->Infer(context, signal);
    this->HasRun = true;
    return true;
  }
  catch (const std::runtime_error& error)
  {
    this->Failure = error.what();
    return false;
  }
}
}
