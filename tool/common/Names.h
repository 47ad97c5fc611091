// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// Sentences about names that do not exist.
#pragma once

#include <string>
#include <vector>

namespace penumbra::tool
{
/// The candidate with the least edit distance, or "" where none is near.
std::string Nearest(const std::string& name, const std::vector<std::string>& candidates);

/// "unknown KIND 'NAME' of OWNER: did you mean 'X'?", with the candidates where they are few or none is
/// near. owner may be empty.
std::string UnknownName(const std::string& kind, const std::string& name, const std::string& owner,
  const std::vector<std::string>& candidates);

/// The names joined by commas; a long list is cut and says how many more there are.
std::string Join(const std::vector<std::string>& names, std::size_t most = 40);
}
