// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Layers of the denoiser's network on the GPU, against the same sums in C++.
#include "WindowTest.h"

#include "gpu/Commands.h"
#include "techniques/denoising/NetworkWeights.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <random>
#include <set>

using namespace penumbra;
using namespace penumbra_test;

namespace
{
constexpr int Width = 19;
constexpr int Height = 13;

/// Activations of a layer, by row, column and channel.
struct Activations
{
  Activations(int width, int height, int channels)
    : Columns(width)
    , Rows(height)
    , Channels(channels)
    , Values(static_cast<std::size_t>(width) * height * channels)
  {
  }
  float& At(int x, int y, int channel)
  {
    return this
      ->Values[(static_cast<std::size_t>(y) * this->Columns + x) * this->Channels + channel];
  }
  /// 0 outside.
  double Get(int x, int y, int channel)
  {
    return x < 0 || y < 0 || x >= this->Columns || y >= this->Rows ? 0.0 : this->At(x, y, channel);
  }

  int Columns;
  int Rows;
  int Channels;
  std::vector<float> Values;
};

/// Random numbers that half floats hold.
Activations Noise(int width, int height, int channels)
{
  std::minstd_rand random(static_cast<unsigned>(channels));
  Activations made(width, height, channels);
  for (float& value : made.Values)
  {
    value = static_cast<float>(random() % 257) / 128.0f;
  }
  return made;
}

class GuideNetworkTest : public WindowTest
{
protected:
  void SetUp() override
  {
    WindowTest::SetUp();
    if (!IsSkipped())
    {
      this->Runner.SetWindow(this->Window);
    }
  }

  void TearDown() override { this->Library.Release(); }

  /// Number of activations that come from the smaller layer above.
  static int Joined(const std::string& name)
  {
    const std::map<std::string, std::string> layerAbove = { { "d0", "e3" }, { "d1", "d0" },
      { "d2", "d1" } };
    const auto found = layerAbove.find(name);
    return found == layerAbove.end() ? 0 : NetworkLayers().at(found->second).Outputs;
  }

  static Texture Upload(Activations from)
  {
    const int fours = from.Channels / 4;
    Texture texture({ GL_RGBA16F, from.Columns, from.Rows, fours });
    glBindTexture(GL_TEXTURE_2D_ARRAY, texture.Get());
    for (int four = 0; four < fours; ++four)
    {
      std::vector<float> layer;
      for (std::size_t i = 0; i < from.Values.size(); i += static_cast<std::size_t>(from.Channels))
      {
        const auto first = from.Values.begin() + static_cast<std::ptrdiff_t>(i) + 4 * four;
        layer.insert(layer.end(), first, first + 4);
      }
      glTexSubImage3D(GL_TEXTURE_2D_ARRAY, 0, 0, 0, four, from.Columns, from.Rows, 1, GL_RGBA,
        GL_FLOAT, layer.data());
    }
    glBindTexture(GL_TEXTURE_2D_ARRAY, 0);
    return texture;
  }

  Activations Download(const Texture& texture, int channels)
  {
    const TextureDesc& desc = texture.Desc();
    Activations read(desc.Width, desc.Height, channels);
    std::vector<float> values(read.Values.size());
    this->Runner.BeforeUse(texture, GL_TEXTURE_UPDATE_BARRIER_BIT);
    glBindTexture(GL_TEXTURE_2D_ARRAY, texture.Get());
    glGetTexImage(GL_TEXTURE_2D_ARRAY, 0, GL_RGBA, GL_FLOAT, values.data());
    glBindTexture(GL_TEXTURE_2D_ARRAY, 0);
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      const std::size_t pixel = i / 4 % (static_cast<std::size_t>(desc.Width) * desc.Height);
      const std::size_t four = i / 4 / (static_cast<std::size_t>(desc.Width) * desc.Height);
      read.Values[pixel * static_cast<std::size_t>(channels) + 4 * four + i % 4] = values[i];
    }
    return read;
  }

  /// Run a layer. above: the smaller layer that is joined, with no channels if there is none.
  Activations Run(
    const std::string& name, const Activations& input, const Activations& above, bool buffers)
  {
    const NetworkLayer& layer = NetworkLayers().at(name);
    const Texture source = Upload(input);
    const Texture result({ GL_RGBA16F, Width, Height, layer.Outputs / 4 });
    Arguments arguments = Arguments()
                            .Sample("activations", &source)
                            .Image("result", result, ShaderAccess::Write)
                            .Set("size", glm::ivec2(Width, Height));
    Defines variant;
    std::optional<Texture> smaller;
    if (above.Channels > 0)
    {
      smaller = Upload(above);
      arguments.Sample("above", &*smaller);
    }
    std::vector<Buffer> weights(layer.Parts.size());
    for (std::size_t i = 0; i < layer.Parts.size(); ++i)
    {
      const std::vector<float>& part = layer.Parts[i];
      if (buffers)
      {
        variant["GI_WEIGHTS_BUFFER"] = "1";
        weights[i].Upload(GL_UNIFORM_BUFFER, part.data(), part.size() * sizeof(float));
        arguments.Block("GiWeights", weights[i]);
      }
      this->Runner.Dispatch(
        this->Library.Compute(
          "denoising/network/" + name + "_" + std::to_string(i) + ".comp", variant),
        arguments, Work::Items(Width, Height));
    }
    return this->Download(result, layer.Outputs);
  }

  ShaderLibrary Library;
  Commands Runner{ this->Library };
};

/// The layer's sums in double precision. The weights' order is that of glsl/denoising/layer.glsl.
Activations Expected(const std::string& name, Activations input, Activations above)
{
  const NetworkLayer& layer = NetworkLayers().at(name);
  Activations result(Width, Height, layer.Outputs);
  const auto get = [&](int x, int y, int channel) {
    const bool inside = x >= 0 && y >= 0 && x < Width && y < Height;
    return channel < above.Channels ? (inside ? above.Get(x / 2, y / 2, channel) : 0.0)
                                    : input.Get(x, y, channel - above.Channels);
  };
  int first = 0; // of the part's outputs
  for (const std::vector<float>& part : layer.Parts)
  {
    const int fours = static_cast<int>(part.size()) / (9 * layer.Inputs * 4 + 4);
    for (int y = 0; y < Height; ++y)
    {
      for (int x = 0; x < Width; ++x)
      {
        for (int output = 0; output < 4 * fours; ++output)
        {
          double sum = part[static_cast<std::size_t>(output)];
          for (int tap = 0; tap < 9; ++tap)
          {
            for (int channel = 0; channel < layer.Inputs; ++channel)
            {
              const int matrix = (tap * layer.Inputs / 4 + channel / 4) * fours + output / 4;
              sum += part[static_cast<std::size_t>(
                       4 * fours + 16 * matrix + 4 * (channel % 4) + output % 4)] *
                get(x + tap % 3 - 1, y + tap / 3 - 1, channel);
            }
          }
          result.At(x, y, first + output) =
            static_cast<float>(name == "out" ? sum : std::max(sum, 0.0));
        }
      }
    }
    first += 4 * fours;
  }
  return result;
}
}

// Sums of hundreds of half floats, which are stored as half floats.
TEST_F(GuideNetworkTest, LayersAreConvolutions)
{
  std::set<std::string> others; // of single pixels: functions of another shader, see tests/denoiser
  for (const auto& [name, layer] : NetworkLayers())
  {
    if (layer.Parts.empty())
    {
      others.insert(name);
      continue;
    }
    const int above = this->Joined(name);
    const Activations input = Noise(Width, Height, layer.Inputs - above);
    const Activations smaller = Noise((Width + 1) / 2, (Height + 1) / 2, above);
    const Activations expected = Expected(name, input, smaller);
    double size = 0.0;
    for (const float value : expected.Values)
    {
      size = std::max(size, std::abs(static_cast<double>(value)));
    }
    for (const bool buffers : { false, true })
    {
      const Activations found = this->Run(name, input, smaller, buffers);
      double worst = 0.0;
      for (std::size_t i = 0; i < expected.Values.size(); ++i)
      {
        worst =
          std::max(worst, std::abs(static_cast<double>(found.Values[i]) - expected.Values[i]));
      }
      std::printf("%s%s: difference %.1e of the largest sum\n", name.c_str(),
        buffers ? " from a buffer" : "", worst / size);
      EXPECT_LT(worst, 1e-3 * size) << name << (buffers ? " from a buffer" : "");
      EXPECT_GT(size, 0.0);
    }
  }
  EXPECT_EQ(others, (std::set<std::string>{ "fine", "fine_out" }));
}
