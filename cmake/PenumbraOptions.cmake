# All options for users.
set(PENUMBRA_VTK "auto" CACHE STRING
  "Which VTK to build against: auto (ParaView's if installed, else plain VTK), paraview, vtk")
set_property(CACHE PENUMBRA_VTK PROPERTY STRINGS auto paraview vtk)
option(PENUMBRA_BUILD_TOOL "Build the penumbra command" ON)
option(PENUMBRA_BUILD_PARAVIEW_PLUGIN "Build the ParaView plugin if ParaView's development files are found" ON)
option(PENUMBRA_BUILD_EXAMPLES "Build the examples" ON)
option(PENUMBRA_BUILD_TESTS "Build the tests and benchmarks" ON)
option(PENUMBRA_WRAP_PYTHON "Wrap the module for Python" ON)
set(PENUMBRA_TEST_TIMEOUT 7200 CACHE STRING
  "Seconds after which a test counts as stuck; long enough for a busy machine with sanitizers")
mark_as_advanced(PENUMBRA_TEST_TIMEOUT)
option(PENUMBRA_SANITIZE "Build with AddressSanitizer and UndefinedBehaviorSanitizer" OFF)

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

# Only this build is instrumented. VTK stays as installed, and neither targets nor the package export the flags.
if(PENUMBRA_SANITIZE)
  if(NOT CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
    message(FATAL_ERROR "PENUMBRA_SANITIZE needs GCC or Clang, but the compiler is ${CMAKE_CXX_COMPILER_ID}.")
  endif()
  add_compile_options(-fsanitize=address,undefined -fno-omit-frame-pointer -O1 -g1)
  add_link_options(-fsanitize=address,undefined)
endif()
