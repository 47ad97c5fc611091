// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// A file with traced form factors, to resume after an interruption.
#pragma once

#include "bake/radiosity/Patches.h"

#include <cstdint>
#include <fstream>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace penumbra::radiosity
{
/// Rows of form factors of consecutive elements.
struct TracedRows
{
  struct Entry
  {
    std::uint32_t Column;
    float Value;
  };
  std::vector<std::uint32_t> Lengths; ///< entries of each row
  std::vector<Entry> Entries;         ///< row after row
  std::vector<float> Escaped;         ///< share of each row that hits nothing
  std::vector<Color> Sky;             ///< irradiance of each row from the environment
};

/// A hash of the positions of elements, which determine their form factors.
std::string Fingerprint(const std::vector<Element>& elements);

class FactorLog
{
public:
  /// Opens or creates the file. identity: describes what is traced, besides the elements. A file with another identity is
  /// cleared, also if fromScratch is set; an incomplete last block is removed. Throws a Failure if it cannot be written.
  FactorLog(std::string path, const std::string& identity, bool fromScratch);

  /// Why an existing file was rejected, or "".
  const std::string& Refusal() const { return this->Reason; }

  /// Reads the rows from an element on. elements: their Fingerprint(). Returns false if the file does not hold them.
  bool Read(const std::string& elements, std::size_t first, TracedRows& rows);

  /// Appends rows. Throws a Failure if the disk is full.
  void Append(const std::string& elements, std::size_t first, const TracedRows& rows);

  /// The share of rows that were read from the file.
  double ReusedShare() const;

  /// Deletes the file, once the solution is written.
  void Remove();

private:
  [[noreturn]] void FailToWrite() const;

  std::string Path;
  std::string Reason;
  std::fstream File;
  std::map<std::pair<std::string, std::size_t>, std::pair<std::uint64_t, std::uint64_t>>
    Blocks; ///< offset and size of their rows, by fingerprint and first element
  std::size_t Reused = 0;
  std::size_t Traced = 0;
};
}
