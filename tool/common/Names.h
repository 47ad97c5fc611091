// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// Sentences about unknown names.
#pragma once

#include <string>
#include <vector>

namespace penumbra::tool
{
/// "unknown KIND 'NAME' of OWNER: did you mean 'X'?", followed by the candidates if they are few or if none is similar.
/// owner may be empty.
std::string UnknownName(const std::string& kind, const std::string& name, const std::string& owner,
  const std::vector<std::string>& candidates);

std::string Lower(std::string text);

/// Text without spaces, tabs and carriage returns at both ends.
std::string Trim(std::string text);

/// Names joined by commas. A long list ends with the number of names left out.
std::string Join(const std::vector<std::string>& names, std::size_t most = 40);
}
