# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
# The system's JSON library, also for those who include VTK's headers.
#
# VTK 9.3 may bring the library itself. One of its headers then makes the name "nlohmann" a macro, and the forward
# declarations of both have the same include guard, so that whatever comes second does not compile. Where that is so,
# VTK's headers, which only name the type, take the system's.
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
