// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Exodus II files are netCDF files; the library fills what is missing at the end of a classic one with
// zeros. The header is read as in "The NetCDF Classic Format Specification" (Unidata 2011), which also
// gives the names used here.
#include "scene/readers/Completeness.h"
#include "scene/readers/CompletenessTools.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <vector>

namespace penumbra::tool
{
namespace
{
constexpr double Huge = 4294967295.0; ///< a vsize that does not fit, by the specification

class ClassicHeader
{
public:
  explicit ClassicHeader(const std::string& path)
    : File(path, std::ios::binary)
  {
    char magic[4] = {};
    this->File.read(magic, sizeof(magic));
    this->Version = magic[3];
    const bool version = this->Version == 1 || this->Version == 2 || this->Version == 5;
    this->Understood = std::string(magic, 3) == "CDF" && version;
    if (this->Understood)
    {
      this->Read();
    }
  }

  /// Bytes the file must have, or 0 where the header is of another kind.
  double RequiredSize() const
  {
    const double records =
      this->FirstRecord > 0 ? this->FirstRecord + this->Records * this->RecordSize : 0;
    // The last value needs no padding.
    return this->Understood ? std::max(this->End, records) - 3 : 0;
  }

private:
  double Integer(std::size_t bytes)
  {
    double value = 0;
    for (std::size_t i = 0; i < bytes; ++i)
    {
      const int byte = this->File.get();
      this->Understood = this->Understood && byte >= 0;
      value = value * 256 + byte;
    }
    return value;
  }
  double NonNegative() { return this->Integer(this->Version == 5 ? 8 : 4); }
  /// The length of a list, after its tag.
  double ListLength()
  {
    this->Integer(4);
    const double length = this->NonNegative();
    constexpr double most = 1e6; // dimensions, attributes, variables
    this->Understood = this->Understood && length <= most;
    return this->Understood ? length : 0;
  }
  void Skip(double bytes)
  {
    constexpr double padding = 4;
    const double padded = std::min(1e12, std::ceil(bytes / padding) * padding);
    this->File.seekg(static_cast<std::streamoff>(padded), std::ios::cur);
  }
  void SkipName() { this->Skip(this->NonNegative()); }
  void SkipAttributes()
  {
    static const double sizes[] = { 0, 1, 1, 2, 4, 4, 8, 1, 2, 4, 8, 8 }; // by nc_type
    for (double left = this->ListLength(); left > 0 && this->Understood; --left)
    {
      this->SkipName();
      const double type = this->Integer(4);
      this->Understood = this->Understood && type >= 1 && type <= 11;
      const double count = this->NonNegative();
      this->Skip(this->Understood ? count * sizes[static_cast<int>(type)] : 0);
    }
  }

  void Read()
  {
    this->Records = this->NonNegative();
    std::vector<bool> isRecord;
    for (double left = this->ListLength(); left > 0 && this->Understood; --left)
    {
      this->SkipName();
      isRecord.push_back(this->NonNegative() == 0);
    }
    this->SkipAttributes();
    for (double left = this->ListLength(); left > 0 && this->Understood; --left)
    {
      this->SkipName();
      this->ReadVariable(isRecord);
    }
  }

  void ReadVariable(const std::vector<bool>& isRecord)
  {
    const double axes = this->NonNegative();
    bool record = false;
    for (double axis = 0; axis < axes && this->Understood; ++axis)
    {
      const double id = this->NonNegative();
      this->Understood = this->Understood && id < static_cast<double>(isRecord.size());
      record = record || (this->Understood && axis == 0 && isRecord[static_cast<std::size_t>(id)]);
    }
    this->SkipAttributes();
    this->Integer(4); // nc_type
    const double size = this->NonNegative();
    const double begin = this->Integer(this->Version == 1 ? 4 : 8);
    this->Understood = this->Understood && size < Huge;
    if (record)
    {
      this->FirstRecord = this->FirstRecord > 0 ? std::min(this->FirstRecord, begin) : begin;
      this->RecordSize += size;
    }
    else
    {
      this->End = std::max(this->End, begin + size);
    }
  }

  std::ifstream File;
  int Version = 0;
  bool Understood = false;
  double Records = 0;
  double RecordSize = 0;
  double FirstRecord = 0;
  double End = 0;
};
}

void RequireCompleteNetcdf(const std::string& path)
{
  const double needed = ClassicHeader(path).RequiredSize();
  if (FileSize(path) < needed)
  {
    FailShort(path, needed, FileSize(path));
  }
}
}
