# Embree builds the trees for ray tracing. Version 4 is preferred to 3. Each version's package accepts only requests for its
# own major version.
find_package(embree 4 QUIET)
if(NOT embree_FOUND)
  find_package(embree 3 REQUIRED)
endif()
