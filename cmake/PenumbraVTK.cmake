# Finds VTK, either ParaView's or plain VTK, and builds the module against it.
include(PenumbraPythonTargets)

# Sets out to the folder of ParaView's CMake package, or to nothing. In Debian it contains ParaView's copy of VTK, which is
# not in find_package's default path. A ParaView that was built with the system's VTK has no copy.
function(_penumbra_find_paraview out)
  file(GLOB candidates
    "/usr/lib/*/cmake/paraview-*" "/usr/lib/cmake/paraview-*" "/usr/local/lib/cmake/paraview-*" "${ParaView_DIR}")
  set(${out} "" PARENT_SCOPE)
  foreach(candidate IN LISTS candidates)
    if(EXISTS "${candidate}/paraview-config.cmake")
      set(${out} "${candidate}" PARENT_SCOPE)
    endif()
  endforeach()
endfunction()

if(NOT PENUMBRA_VTK MATCHES "^(auto|paraview|vtk)$")
  message(FATAL_ERROR "PENUMBRA_VTK is '${PENUMBRA_VTK}': it must be auto, paraview or vtk.")
endif()
set(PENUMBRA_PARAVIEW_PACKAGE "")
if(NOT PENUMBRA_VTK STREQUAL "vtk")
  _penumbra_find_paraview(PENUMBRA_PARAVIEW_PACKAGE)
  if(PENUMBRA_PARAVIEW_PACKAGE AND NOT VTK_DIR AND EXISTS "${PENUMBRA_PARAVIEW_PACKAGE}/vtk/vtk-config.cmake")
    set(VTK_DIR "${PENUMBRA_PARAVIEW_PACKAGE}/vtk" CACHE PATH "VTK's CMake package")
  elseif(EXISTS "${PENUMBRA_PARAVIEW_PACKAGE}/vtk/vtk-config.cmake" AND NOT VTK_DIR STREQUAL "${PENUMBRA_PARAVIEW_PACKAGE}/vtk")
    set(PENUMBRA_PARAVIEW_PACKAGE "") # its VTK is not the requested one
  elseif(PENUMBRA_VTK STREQUAL "paraview" AND NOT PENUMBRA_PARAVIEW_PACKAGE AND NOT VTK_DIR)
    message(FATAL_ERROR "PENUMBRA_VTK is 'paraview' but no ParaView development files were found: "
      "install paraview-dev and python3-paraview, or configure with -DPENUMBRA_VTK=vtk.")
  endif()
endif()

find_package(Threads REQUIRED)
find_package(glm REQUIRED)
set(_vtk_components
  CommonCore CommonDataModel CommonMath CommonSystem CommonTransforms CommonExecutionModel
  RenderingContext2D RenderingContextOpenGL2 RenderingCore RenderingOpenGL2 RenderingUI
  FiltersCore FiltersGeneral FiltersGeometry FiltersModeling FiltersSources
  ImagingCore IOImage IOXML IOXMLParser)
if(PENUMBRA_WRAP_PYTHON)
  list(APPEND _vtk_components WrappingPythonCore Python)
  # VTK was built for the system's interpreter, but another python3 may come first in the path.
  if(NOT Python3_EXECUTABLE AND EXISTS "/usr/bin/python3")
    set(Python3_EXECUTABLE "/usr/bin/python3" CACHE FILEPATH "The interpreter VTK was wrapped for")
  endif()
endif()
if(VTK_DIR)
  penumbra_python_targets("${VTK_DIR}")
endif()
# Molecules can be traced if VTK was built with this module.
find_package(VTK 9.1 REQUIRED COMPONENTS ${_vtk_components}
  OPTIONAL_COMPONENTS DomainsChemistryOpenGL2)
message(STATUS "Penumbra: VTK ${VTK_VERSION} from ${VTK_DIR}")

macro(penumbra_build_module)
  vtk_module_find_modules(_penumbra_module_files "${CMAKE_CURRENT_SOURCE_DIR}/vtk_module")
  vtk_module_scan(
    MODULE_FILES "${CMAKE_CURRENT_SOURCE_DIR}/vtk_module/vtk.module"
    PROVIDES_MODULES _penumbra_modules
    REQUIRES_MODULES _penumbra_required
    REQUEST_MODULES Penumbra::RenderingGI
    ENABLE_TESTS OFF)
  vtk_module_build(
    MODULES ${_penumbra_modules}
    INSTALL_EXPORT Penumbra
    INSTALL_HEADERS ON
    HEADERS_DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/penumbra"
    CMAKE_DESTINATION "${CMAKE_INSTALL_LIBDIR}/cmake/penumbra"
    LIBRARY_NAME_SUFFIX ""
    PACKAGE Penumbra
    VERSION "${PROJECT_VERSION}"
    SOVERSION "${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}")
  if(PENUMBRA_WRAP_PYTHON)
    include(PenumbraPython)
  endif()
endmacro()
