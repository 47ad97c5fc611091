# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
# The system's JSON library, also for sources that include VTK's headers.
#
# VTK 9.3 may include its own copy of the library. One of its headers then defines the name "nlohmann" as a macro, and the
# forward declarations of both copies have the same include guard, so that whichever comes second does not compile. In that
# case VTK's headers, which only name the type, get the system's copy.
find_package(nlohmann_json REQUIRED)
if(NOT DEFINED PENUMBRA_JSON_BESIDE_VTK)
  include(CheckCXXSourceCompiles)
  set(CMAKE_REQUIRED_LIBRARIES nlohmann_json::nlohmann_json VTK::CommonCore)
  check_cxx_source_compiles("
    #include <nlohmann/json.hpp>
    #include <vtkAbstractArray.h>
    nlohmann::json value;
    int main() {}" PENUMBRA_JSON_BESIDE_VTK)
  unset(CMAKE_REQUIRED_LIBRARIES)
endif()
get_target_property(_options nlohmann_json::nlohmann_json INTERFACE_COMPILE_OPTIONS)
if(NOT PENUMBRA_JSON_BESIDE_VTK AND NOT "${_options}" MATCHES "VTK_NLOHMANN_JSON")
  set_property(TARGET nlohmann_json::nlohmann_json APPEND PROPERTY INTERFACE_COMPILE_OPTIONS
    -Dvtk_nlohmannjson_h "-DVTK_NLOHMANN_JSON(name)=<nlohmann/name>")
endif()
