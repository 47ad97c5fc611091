# Embree builds the trees that rays walk through: version 4 where it is, else 3. Their packages accept only their own
# major version.
find_package(embree 4 QUIET)
if(NOT embree_FOUND)
  find_package(embree 3 REQUIRED)
endif()
