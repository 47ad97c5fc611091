// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// Conversion of short texts of the command line, such as "point:1,2,3,intensity=2", to JSON of the scene file.
#pragma once

#include "scene/model/SceneModel.h"

#include <nlohmann/json_fwd.hpp>

namespace penumbra::tool
{
enum class SpecKind
{
  TypeFirst, ///< TYPE or TYPE:...; numbers before the first key are the position
  KeysOnly   ///< KEY=VALUE,KEY=VALUE,...; a key without a value is true
};

/// A value is a number, several numbers separated by commas, or a word.
nlohmann::json ParseSpec(const std::string& text, SpecKind kind);

/// Numbers separated by commas. Throws a Failure that contains where.
std::vector<double> ParseNumbers(const std::string& text, const std::string& where);

/// A colour as three numbers, #rrggbb or a name.
Vec3 ParseColorOption(const std::string& text, const std::string& where);
}
