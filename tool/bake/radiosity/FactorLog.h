// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// Traced form factors, kept in a file that a killed solution goes on from.
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
/// What the rays of elements in a row met.
struct TracedRows
{
  struct Entry
  {
    std::uint32_t Column;
    float Value;
  };
  std::vector<std::uint32_t> Lengths; ///< entries of each row
  std::vector<Entry> Entries;         ///< row after row
  std::vector<float> Escaped;         ///< of each row, the share that meets nothing
  std::vector<Color> Sky;             ///< of each row, the irradiance from far away
};

/// Tells elements apart by where they are: their form factors depend on nothing else.
std::string Fingerprint(const std::vector<Element>& elements);

class FactorLog
{
public:
  /// Opens the file, or makes it. identity: tells what is traced, beside the elements. A file of something else begins
  /// anew, as it does if asked; a block that a kill cut off is cut away. Throws a Failure where it cannot be written.
  FactorLog(std::string path, const std::string& identity, bool anew);

  /// Why a file that was there is of no use; "" where it is, or where there was none.
  const std::string& Refusal() const { return this->WhyRefused; }

  /// Fills in the rows from an element on, of elements of this Fingerprint(). False where the file does not hold them.
  bool Take(const std::string& elements, std::size_t first, TracedRows& rows);

  /// Throws a Failure where the disk is full.
  void Put(const std::string& elements, std::size_t first, const TracedRows& rows);

  /// The share of rows so far that were taken from the file.
  double ShareTaken() const;

  /// The solution is written: the file is not needed any more.
  void Remove();

private:
  void Open(const std::string& head, bool anew);
  [[noreturn]] void FailToWrite() const;

  std::string Path;
  std::string WhyRefused;
  std::fstream File;
  std::map<std::pair<std::string, std::size_t>, std::pair<std::uint64_t, std::uint64_t>>
    Blocks; ///< offset and size of their rows
  std::size_t Taken = 0;
  std::size_t Traced = 0;
};
}
