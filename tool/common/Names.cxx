// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "common/Names.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <numeric>

namespace penumbra::tool
{
std::string Lower(std::string text)
{
  std::transform(
    text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

std::string Trim(std::string text)
{
  text.erase(0, text.find_first_not_of(" \t\r"));
  text.erase(text.find_last_not_of(" \t\r") + 1);
  return text;
}

namespace
{
/// Levenshtein 1966, Binary codes capable of correcting deletions, insertions, and reversals.
std::size_t EditDistance(const std::string& a, const std::string& b)
{
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0);
  for (std::size_t i = 1; i <= a.size(); ++i)
  {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j)
    {
      const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({ replaced, row[j] + 1, row[j - 1] + 1 });
    }
  }
  return row[b.size()];
}

/// The candidate with the smallest edit distance, or "" if none is similar.
std::string Nearest(const std::string& name, const std::vector<std::string>& candidates)
{
  std::string best;
  // A name with more than half of its letters wrong is no misspelling.
  std::size_t least = std::max<std::size_t>(2, name.size() / 2) + 1;
  for (const std::string& candidate : candidates)
  {
    std::size_t distance = EditDistance(Lower(name), Lower(candidate));
    const bool starts = name.size() > 2 && Lower(candidate).rfind(Lower(name), 0) == 0;
    distance = starts ? std::min<std::size_t>(distance, 1) : distance;
    if (distance < least)
    {
      least = distance;
      best = candidate;
    }
  }
  return best;
}
}

std::string UnknownName(const std::string& kind, const std::string& name, const std::string& owner,
  const std::vector<std::string>& candidates)
{
  const std::string subject =
    fmt::format("unknown {} '{}'{}{}", kind, name, owner.empty() ? "" : " of ", owner);
  const std::string nearest = Nearest(name, candidates);
  constexpr std::size_t few = 12;
  if (candidates.empty())
  {
    return subject + ": there are none";
  }
  if (nearest.empty())
  {
    return fmt::format("{}: known are {}", subject, Join(candidates));
  }
  return candidates.size() > few
    ? fmt::format("{}: did you mean '{}'?", subject, nearest)
    : fmt::format("{}: did you mean '{}'? (known are {})", subject, nearest, Join(candidates));
}

std::string Join(const std::vector<std::string>& names, std::size_t most)
{
  const std::size_t shown = std::min(most, names.size());
  std::string text = fmt::format("{}", fmt::join(names.begin(), names.begin() + shown, ", "));
  return shown < names.size() ? fmt::format("{} and {} more", text, names.size() - shown) : text;
}
}
