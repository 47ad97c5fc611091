// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bake/lightmap/Progress.h"

#include "common/Failure.h"

#include <OpenImageIO/hash.h>

#include <cstring>
#include <filesystem>
#include <fstream>

namespace penumbra::lightmap
{
namespace
{
namespace fs = std::filesystem;
constexpr const char* Head = "penumbra lightmap in the making 1\n";

template <typename Visit>
void ForEachArray(Gathered& gathered, const Visit& visit)
{
  const auto array = [&visit](auto& values) {
    visit(reinterpret_cast<char*>(values.data()), values.size() * sizeof(values[0]));
  };
  visit(reinterpret_cast<char*>(&gathered.Round), sizeof(gathered.Round));
  visit(reinterpret_cast<char*>(&gathered.Block), sizeof(gathered.Block));
  array(gathered.Halves[0]);
  array(gathered.Halves[1]);
  array(gathered.First);
  array(gathered.Backs);
  array(gathered.Kept);
  array(gathered.Direct);
  array(gathered.DirectRounds);
}
}

std::string ProgressFile::Load(Gathered& gathered) const
{
  std::ifstream file(this->Path, std::ios::binary);
  if (!file)
  {
    return "";
  }
  const std::string bytes((std::istreambuf_iterator<char>(file)), {});
  constexpr std::size_t digits = 40; // of the checksum, at the end
  if (bytes.size() < digits ||
    OIIO::SHA1(bytes.data(), bytes.size() - digits).digest() != bytes.substr(bytes.size() - digits))
  {
    return "is damaged";
  }
  const std::string head = Head + this->Identity + "\n";
  Gathered read = gathered;
  std::size_t size = head.size() + digits;
  ForEachArray(read, [&size](const char*, std::size_t count) { size += count; });
  if (bytes.compare(0, head.size(), head) != 0 || size != bytes.size())
  {
    return "is of another scene or of other settings";
  }
  const char* from = bytes.data() + head.size();
  ForEachArray(read, [&from](char* to, std::size_t count) {
    std::memcpy(to, from, count);
    from += count;
  });
  gathered = std::move(read);
  return "";
}

void ProgressFile::Save(const Gathered& gathered)
{
  const auto start = std::chrono::steady_clock::now();
  if (start < this->Next)
  {
    return;
  }
  std::string bytes = Head + this->Identity + "\n";
  ForEachArray(const_cast<Gathered&>(gathered), // only read here
    [&bytes](const char* from, std::size_t count) { bytes.append(from, count); });
  bytes += OIIO::SHA1(bytes.data(), bytes.size()).digest();
  const std::string half = this->Path + ".half";
  std::ofstream file(half, std::ios::binary);
  file << bytes;
  file.close();
  std::error_code error;
  if (file)
  {
    fs::rename(half, this->Path, error);
  }
  if (!file || error)
  {
    fs::remove(half, error);
    tool::Fail(
      "'{}', which holds the progress of the bake, cannot be written: make room on the disk",
      this->Path);
  }
  // Saving takes at most a twentieth of the time.
  constexpr int share = 20;
  const auto end = std::chrono::steady_clock::now();
  this->Next =
    end + std::max<std::chrono::steady_clock::duration>(FirstWait, share * (end - start));
}

void ProgressFile::Remove() const
{
  std::error_code error;
  fs::remove(this->Path, error);
}
}
