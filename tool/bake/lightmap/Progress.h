// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// What a bake has gathered so far, kept in a file that a killed bake goes on from.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

namespace penumbra::lightmap
{
struct Gathered
{
  std::uint32_t Round = 0; ///< the next to gather, and which block of texels of it
  std::uint32_t Block = 0;
  std::vector<float> Halves[2]; ///< sums of the light of even and of odd rounds, texel by texel
  std::vector<float> First;     ///< of the first round
  std::vector<float> Lamps;     ///< sums of what lamps send, and how many rounds each is of
  std::vector<unsigned char> LampRounds;
  std::vector<float> Backs;        ///< sums of the share of rays that met backs
  std::vector<unsigned char> Kept; ///< texels whose light is taken from an earlier bake
};

class ProgressFile
{
public:
  /// identity: tells what is baked.
  ProgressFile(std::string path, std::string identity)
    : Path(std::move(path))
    , Identity(std::move(identity))
  {
  }

  /// Fills in what the file holds. Returns "" where it did or where there is no file, else why the file is of no use;
  /// sizes of vectors must be as they were.
  std::string Load(Gathered& gathered) const;

  /// Writes if it is time to. The file that is there stays whole until the new one is. Throws a Failure.
  void Save(const Gathered& gathered);

  void Remove() const;

private:
  std::string Path;
  std::string Identity;
  std::chrono::steady_clock::time_point Next = std::chrono::steady_clock::now() + FirstWait;
  static constexpr std::chrono::milliseconds FirstWait{ 1000 };
};
}
