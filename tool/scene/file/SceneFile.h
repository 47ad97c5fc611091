// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// The scene file, described in docs/scene-file.md.
#pragma once

#include "scene/model/SceneModel.h"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace penumbra::tool
{
/// Reads a scene. Paths in it are relative to its folder. Throws a Failure that names the file, and the key or position of
/// the error.
Scene ReadSceneFile(const std::string& path);

/// Parts of a scene, also read from the texts of options such as --light. where: the part's name in messages.
Light ReadLight(const nlohmann::json& value, const std::string& where);
Camera ReadCamera(const nlohmann::json& value, const std::string& where);
EnvironmentMap ReadEnvironment(const nlohmann::json& value, const std::string& where);
Background ReadBackground(const nlohmann::json& value, const std::string& where);
Object ReadObject(const nlohmann::json& value, const std::string& where);
}
