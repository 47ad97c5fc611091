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

// Precedes the rows: fingerprint of the elements, index of the first, number of bytes. A checksum of both follows the rows.
struct BlockHead
{
  char Elements[Digits];
  std::uint64_t First;
  std::uint64_t Size;
};

template <typename T>
void AppendBytes(std::string& bytes, const std::vector<T>& values)
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

FactorLog::FactorLog(std::string path, const std::string& identity, bool fromScratch)
  : Path(std::move(path))
{
  const std::string head = Head + OIIO::SHA1(identity.data(), identity.size()).digest() + "\n";
  std::error_code error;
  const std::uint64_t size = fromScratch ? 0 : fs::file_size(this->Path, error);
  std::uint64_t valid = 0;
  if (!fromScratch && !error)
  {
    std::ifstream file(this->Path, std::ios::binary);
    std::string found(head.size(), '\0');
    if (!file.read(found.data(), static_cast<std::streamsize>(found.size())) || found != head)
    {
      this->Reason = "is of another scene or of other settings, or damaged";
    }
    else
    {
      valid = head.size();
      BlockHead block;
      std::string rows;
      while (ReadBlock(file, block, rows, size - valid))
      {
        this->Blocks[{ std::string(block.Elements, Digits), block.First }] = {
          valid + sizeof(block), block.Size
        };
        valid += sizeof(block) + block.Size + Digits;
      }
      fs::resize_file(this->Path, valid, error);
    }
  }
  const auto mode = std::ios::binary | std::ios::in | std::ios::out;
  this->File.open(this->Path, valid == 0 ? mode | std::ios::trunc : mode);
  if (valid == 0)
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
  tool::Fail("'{}', which holds the traced form factors, cannot be written: make room on the disk",
    this->Path);
}

bool FactorLog::Read(const std::string& elements, std::size_t first, TracedRows& rows)
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
  this->Reused += whole ? rows.Lengths.size() : 0;
  return whole;
}

void FactorLog::Append(const std::string& elements, std::size_t first, const TracedRows& rows)
{
  std::string bytes;
  AppendBytes(bytes, rows.Lengths);
  AppendBytes(bytes, rows.Entries);
  AppendBytes(bytes, rows.Escaped);
  AppendBytes(bytes, rows.Sky);
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

double FactorLog::ReusedShare() const
{
  const std::size_t all = this->Reused + this->Traced;
  return all > 0 ? double(this->Reused) / double(all) : 0.0;
}

void FactorLog::Remove()
{
  this->File.close();
  std::error_code error;
  fs::remove(this->Path, error);
}
}
