// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// The scene file: docs/scene-file.md describes it.
#pragma once

#include "scene/model/SceneModel.h"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace penumbra::tool
{
/// Reads a scene; relative paths in it are taken from its folder. Throws a Failure that names the file
/// and the key or place where it is not as documented.
Scene ReadSceneFile(const std::string& path);

/// Parts of a scene, also used for the texts of --light, --camera and their like. where is how
/// sentences name the part.
Light ReadLight(const nlohmann::json& value, const std::string& where);
Camera ReadCamera(const nlohmann::json& value, const std::string& where);
Background ReadBackground(const nlohmann::json& value, const std::string& where);
Terrain ReadTerrain(const nlohmann::json& value, const std::string& where);
Object ReadObject(const nlohmann::json& value, const std::string& where);
}
