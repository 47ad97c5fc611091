// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// A file with the progress of a bake, to resume after an interruption.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

namespace penumbra::lightmap
{
struct Gathered
{
  std::uint32_t Round = 0; ///< the next round, and its next block of texels
  std::uint32_t Block = 0;
  std::vector<float> Halves[2]; ///< sums of light of even and odd rounds
  std::vector<float> First;     ///< light of the first round
  std::vector<float> Direct;    ///< sums of direct light, and their numbers of rounds
  std::vector<unsigned char> DirectRounds;
  std::vector<float> Backs;        ///< sums of the shares of rays that hit back faces
  std::vector<unsigned char> Kept; ///< 1 for texels with light of an earlier bake
};

class ProgressFile
{
public:
  /// identity: a checksum of the scene and settings.
  ProgressFile(std::string path, std::string identity)
    : Path(std::move(path))
    , Identity(std::move(identity))
  {
  }

  /// Reads the file into vectors of the right sizes. Returns "" on success or if there is no file, or else why the file is
  /// rejected.
  std::string Load(Gathered& gathered) const;

  /// Writes the file if it is due. The existing file stays intact until the new one is complete. Throws a Failure.
  void Save(const Gathered& gathered);

  void Remove() const;

private:
  std::string Path;
  std::string Identity;
  std::chrono::steady_clock::time_point Next = std::chrono::steady_clock::now() + FirstWait;
  static constexpr std::chrono::milliseconds FirstWait{ 1000 };
};
}
