// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// Short texts of the command line, such as "point:1,2,3,intensity=2", as JSON for the scene file's
/// readers.
#pragma once

#include "scene/model/SceneModel.h"

#include <nlohmann/json_fwd.hpp>

namespace penumbra::tool
{
enum class SpecKind
{
  TypeFirst, ///< TYPE or TYPE:..., where numbers before the first key are the position
  KeysOnly   ///< KEY=VALUE,KEY=VALUE,... where a key alone is true
};

/// A value is a number, several numbers with commas between them, or a word.
nlohmann::json ParseSpec(const std::string& text, SpecKind kind);

/// Numbers with commas between them; throws a Failure that names where.
std::vector<double> ParseNumbers(const std::string& text, const std::string& where);

/// A colour as three numbers, #rrggbb or a name.
Vec3 ParseColorOption(const std::string& text, const std::string& where);
}
