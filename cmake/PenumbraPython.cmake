# Wraps the module for Python as the package "penumbra" in build/python, which can be added to PYTHONPATH.
set(PENUMBRA_PYTHON_DIR "${CMAKE_BINARY_DIR}/python")
set(_python_version "python${Python3_VERSION_MAJOR}.${Python3_VERSION_MINOR}")
if(NOT EXISTS "/etc/debian_version")
  set(_python_packages "lib/${_python_version}/site-packages")
elseif(CMAKE_INSTALL_PREFIX STREQUAL "/usr")
  set(_python_packages "lib/python3/dist-packages")
else()
  set(_python_packages "lib/${_python_version}/dist-packages")
endif()
set(PENUMBRA_PYTHON_DESTINATION "${_python_packages}" CACHE STRING
  "Folder of Python packages, relative to the prefix of the installation")

vtk_module_wrap_python(
  MODULES ${_penumbra_modules}
  TARGET Penumbra::Python
  PYTHON_PACKAGE "penumbra"
  MODULE_DESTINATION "${PENUMBRA_PYTHON_DESTINATION}"
  LIBRARY_DESTINATION "${CMAKE_INSTALL_LIBDIR}"
  BUILD_STATIC OFF
  INSTALL_HEADERS OFF)
set_target_properties(vtkRenderingGIPython PROPERTIES
  LIBRARY_OUTPUT_DIRECTORY "${PENUMBRA_PYTHON_DIR}/penumbra")

set(_python_folder "${CMAKE_CURRENT_SOURCE_DIR}/python/penumbra")
file(GLOB_RECURSE _python_sources CONFIGURE_DEPENDS "${_python_folder}/*.py")
set(_python_copies "")
foreach(_source IN LISTS _python_sources)
  file(RELATIVE_PATH _name "${_python_folder}" "${_source}")
  set(_copy "${PENUMBRA_PYTHON_DIR}/penumbra/${_name}")
  add_custom_command(OUTPUT "${_copy}"
    COMMAND "${CMAKE_COMMAND}" -E copy "${_source}" "${_copy}"
    DEPENDS "${_source}"
    COMMENT "Copying ${_name}"
    VERBATIM)
  list(APPEND _python_copies "${_copy}")
endforeach()
add_custom_target(penumbra_python ALL DEPENDS ${_python_copies})
install(DIRECTORY "${_python_folder}/" DESTINATION "${PENUMBRA_PYTHON_DESTINATION}/penumbra" COMPONENT python
  FILES_MATCHING PATTERN "*.py" PATTERN "__pycache__" EXCLUDE)
