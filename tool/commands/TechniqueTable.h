// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// The table of techniques, as they describe themselves.
#pragma once

#include <nlohmann/json.hpp>

#include <string>

namespace penumbra::tool
{
/// A list of objects: name, title, term, verb, dynamic, source, parameters.
nlohmann::ordered_json DescribeTechniques();

/// For a terminal.
std::string PlainTable(const nlohmann::ordered_json& techniques, bool parameters);

/// For the documentation.
std::string MarkdownTable(const nlohmann::ordered_json& techniques, bool parameters);
}
