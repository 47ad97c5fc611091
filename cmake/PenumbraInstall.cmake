# The CMake package: find_package(Penumbra) provides Penumbra::RenderingGI and VTK. The module installs its own library,
# headers and targets; this adds the files by which CMake finds them.
include(CMakePackageConfigHelpers)
set(_package "${CMAKE_INSTALL_LIBDIR}/cmake/penumbra")
configure_package_config_file(
  "${CMAKE_CURRENT_SOURCE_DIR}/cmake/PenumbraConfig.cmake.in"
  "${CMAKE_BINARY_DIR}/${_package}/PenumbraConfig.cmake"
  INSTALL_DESTINATION "${_package}"
  NO_SET_AND_CHECK_MACRO NO_CHECK_REQUIRED_COMPONENTS_MACRO)
write_basic_package_version_file(
  "${CMAKE_BINARY_DIR}/${_package}/PenumbraConfigVersion.cmake" COMPATIBILITY SameMinorVersion)
install(
  FILES
    "${CMAKE_BINARY_DIR}/${_package}/PenumbraConfig.cmake"
    "${CMAKE_BINARY_DIR}/${_package}/PenumbraConfigVersion.cmake"
    "${CMAKE_CURRENT_SOURCE_DIR}/cmake/PenumbraPythonTargets.cmake"
  DESTINATION "${_package}"
  COMPONENT development)

install(FILES LICENSE README.md DESTINATION "${CMAKE_INSTALL_DATAROOTDIR}/doc/penumbra" COMPONENT runtime)

if(PENUMBRA_BUILD_TESTS)
  add_subdirectory(tests/install)
endif()
