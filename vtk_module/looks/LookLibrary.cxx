// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "looks/LookLibrary.h"

#include "looks/LookFile.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>

namespace penumbra
{
namespace
{
namespace fs = std::filesystem;

constexpr const char* Ending = ".json";
constexpr const char* OwnLight = "as-is"; ///< the look that changes nothing

fs::path UserFolder()
{
  const char* folder = std::getenv("PENUMBRA_LOOK_PATH");
  return folder ? folder : "";
}

std::string ReadFile(const fs::path& path)
{
  std::error_code failed;
  std::ifstream file(path);
  std::ostringstream text;
  if (fs::is_directory(path, failed) || !file || !(text << file.rdbuf()))
  {
    throw LookError("the look '" + path.string() + "' cannot be read: there is no such file");
  }
  return text.str();
}
}

std::vector<std::string> LookNames()
{
  std::set<std::string> names;
  for (const auto& look : EmbeddedLooks())
  {
    names.insert(fs::path(look.first).stem().string());
  }
  std::error_code failed; // a folder that cannot be read has no looks
  for (const auto& entry : fs::directory_iterator(UserFolder(), failed))
  {
    if (entry.path().extension() == Ending)
    {
      names.insert(entry.path().stem().string());
    }
  }
  names.erase(OwnLight);
  std::vector<std::string> sorted = { OwnLight };
  sorted.insert(sorted.end(), names.begin(), names.end());
  return sorted;
}

std::string FindLook(const std::string& nameOrPath)
{
  const fs::path path = nameOrPath;
  if (path.has_parent_path() || path.extension() == Ending)
  {
    return ReadFile(path);
  }
  const fs::path own = UserFolder() / (nameOrPath + Ending);
  std::error_code failed;
  if (!UserFolder().empty() && fs::exists(own, failed))
  {
    return ReadFile(own);
  }
  const auto found = EmbeddedLooks().find(nameOrPath + Ending);
  if (found != EmbeddedLooks().end())
  {
    return found->second;
  }
  std::string names;
  for (const std::string& name : LookNames())
  {
    names += (names.empty() ? "" : ", ") + name;
  }
  throw LookError("there is no look '" + nameOrPath + "': there are " + names +
    ", or the path of a file that ends with .json");
}
}
