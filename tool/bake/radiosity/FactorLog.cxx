// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bake/radiosity/FactorLog.h"

#include "common/Failure.h"

#include <OpenImageIO/hash.h>

#include <cstring>
#include <filesystem>

namespace penumbra::radiosity
{
namespace
{
namespace fs = std::filesystem;
constexpr const char* Head = "penumbra form factors in the making 1\n";
constexpr std::size_t Digits = 40; // of a checksum

// Before the rows: whose they are, from which on, how many bytes. After them a checksum of both.
struct BlockHead
{
  char Elements[Digits];
  std::uint64_t First;
  std::uint64_t Size;
};

template <typename T>
void Append(std::string& bytes, const std::vector<T>& values)
{
  const std::uint64_t count = values.size();
  bytes.append(reinterpret_cast<const char*>(&count), sizeof(count));
  bytes.append(reinterpret_cast<const char*>(values.data()), count * sizeof(T));
}

template <typename T>
bool Extract(const char*& from, const char* end, std::vector<T>& values)
{
  std::uint64_t count = 0;
  if (std::size_t(end - from) < sizeof(count))
  {
    return false;
  }
  std::memcpy(&count, from, sizeof(count));
  from += sizeof(count);
  if (count > std::size_t(end - from) / sizeof(T))
  {
    return false;
  }
  values.resize(count);
  std::memcpy(static_cast<void*>(values.data()), from, count * sizeof(T));
  from += count * sizeof(T);
  return true;
}

bool ReadBlock(std::istream& file, BlockHead& head, std::string& rows, std::uint64_t left)
{
  std::string sum(Digits, '\0');
  if (left < sizeof(head) + Digits || !file.read(reinterpret_cast<char*>(&head), sizeof(head)) ||
    head.Size > left - sizeof(head) - Digits)
  {
    return false;
  }
  rows.resize(head.Size);
  if (!file.read(rows.data(), static_cast<std::streamsize>(rows.size())) ||
    !file.read(sum.data(), Digits))
  {
    return false;
  }
  OIIO::SHA1 check(&head, sizeof(head));
  check.append(rows.data(), rows.size());
  return check.digest() == sum;
}
}

std::string Fingerprint(const std::vector<Element>& elements)
{
  OIIO::SHA1 sum;
  for (const Element& element : elements)
  {
    sum.append(&element.Corners, sizeof(element.Corners));
    sum.append(&element.Present, sizeof(element.Present));
  }
  return sum.digest();
}

FactorLog::FactorLog(std::string path, const std::string& identity, bool anew)
  : Path(std::move(path))
{
  const std::string head = Head + OIIO::SHA1(identity.data(), identity.size()).digest() + "\n";
  std::error_code error;
  const std::uint64_t size = anew ? 0 : fs::file_size(this->Path, error);
  const bool known = !anew && !error;
  std::uint64_t good = 0;
  if (known)
  {
    std::ifstream file(this->Path, std::ios::binary);
    std::string found(head.size(), '\0');
    if (!file.read(found.data(), static_cast<std::streamsize>(found.size())) || found != head)
    {
      this->WhyRefused = "is of another scene or of other settings, or damaged";
    }
    else
    {
      good = head.size();
      BlockHead block;
      std::string rows;
      while (ReadBlock(file, block, rows, size - good))
      {
        this->Blocks[{ std::string(block.Elements, Digits), block.First }] = { good + sizeof(block),
          block.Size };
        good += sizeof(block) + block.Size + Digits;
      }
      fs::resize_file(this->Path, good, error);
    }
  }
  this->Open(head, good == 0);
}

void FactorLog::Open(const std::string& head, bool anew)
{
  const auto mode = std::ios::binary | std::ios::in | std::ios::out;
  this->File.open(this->Path, anew ? mode | std::ios::trunc : mode);
  if (anew)
  {
    this->File << head << std::flush;
  }
  if (!this->File)
  {
    this->FailToWrite();
  }
}

void FactorLog::FailToWrite() const
{
  tool::Fail("'{}', which keeps what is traced so far, cannot be written: make room on the disk",
    this->Path);
}

bool FactorLog::Take(const std::string& elements, std::size_t first, TracedRows& rows)
{
  const auto found = this->Blocks.find({ elements, first });
  if (found == this->Blocks.end())
  {
    return false;
  }
  std::string bytes(found->second.second, '\0');
  this->File.seekg(static_cast<std::streamoff>(found->second.first));
  this->File.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  const char* from = bytes.data();
  const char* end = from + bytes.size();
  const bool whole = this->File && Extract(from, end, rows.Lengths) &&
    Extract(from, end, rows.Entries) && Extract(from, end, rows.Escaped) &&
    Extract(from, end, rows.Sky) && from == end;
  this->File.clear();
  this->Taken += whole ? rows.Lengths.size() : 0;
  return whole;
}

void FactorLog::Put(const std::string& elements, std::size_t first, const TracedRows& rows)
{
  std::string bytes;
  Append(bytes, rows.Lengths);
  Append(bytes, rows.Entries);
  Append(bytes, rows.Escaped);
  Append(bytes, rows.Sky);
  BlockHead head;
  std::memcpy(head.Elements, elements.data(), Digits);
  head.First = first;
  head.Size = bytes.size();
  OIIO::SHA1 check(&head, sizeof(head));
  check.append(bytes.data(), bytes.size());
  this->File.seekp(0, std::ios::end);
  this->File.write(reinterpret_cast<const char*>(&head), sizeof(head));
  this->File << bytes << check.digest() << std::flush;
  if (!this->File)
  {
    this->FailToWrite();
  }
  this->Traced += rows.Lengths.size();
}

double FactorLog::ShareTaken() const
{
  const std::size_t all = this->Taken + this->Traced;
  return all > 0 ? double(this->Taken) / double(all) : 0.0;
}

void FactorLog::Remove()
{
  this->File.close();
  std::error_code error;
  fs::remove(this->Path, error);
}
}
