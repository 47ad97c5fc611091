// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// Reads NumPy's array files: .npy, and .npz, which is a zip archive of them.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace penumbra::tool
{
struct NumpyArray
{
  std::vector<std::size_t> Shape; ///< empty for a single number
  std::vector<double> Values;     ///< in C order
};

/// The numeric arrays by name. The array of a .npy file has the name "".
std::map<std::string, NumpyArray> ReadNumpyFile(const std::string& path);
}
