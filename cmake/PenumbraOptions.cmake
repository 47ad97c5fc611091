# Everything a user may choose, in one place.
set(PENUMBRA_VTK "auto" CACHE STRING
  "Which VTK to build against: auto (ParaView's if installed, else plain VTK), paraview, vtk")
set_property(CACHE PENUMBRA_VTK PROPERTY STRINGS auto paraview vtk)
option(PENUMBRA_BUILD_TOOL "Build the penumbra command" ON)
option(PENUMBRA_BUILD_EXAMPLES "Build the examples" ON)
option(PENUMBRA_BUILD_TESTS "Build the tests and benchmarks" ON)
option(PENUMBRA_WRAP_PYTHON "Wrap the module for Python" ON)

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()
set(CMAKE_CXX_STANDARD 17)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
option(BUILD_SHARED_LIBS "Build the module as a shared library" ON)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/bin")
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/lib")

# An installed program finds the library beside it, wherever both are moved, and VTK where it was.
set(CMAKE_INSTALL_RPATH "$ORIGIN/../${CMAKE_INSTALL_LIBDIR}")
set(CMAKE_INSTALL_RPATH_USE_LINK_PATH ON)
