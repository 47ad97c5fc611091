# The sources of the ray core and the builder they link: include() this, add penumbra_ray_sources to
# a target and link penumbra_ray_libraries to it.
set(penumbra_ray_sources)
foreach(_name RayBuffer RayMesh RayScene RaySplits RayTree RayTreeBuilder)
  list(APPEND penumbra_ray_sources "${CMAKE_CURRENT_LIST_DIR}/${_name}.cxx")
endforeach()

# Embree 4 where it is, else 3. Their packages accept only their own major version.
find_package(embree 4 QUIET)
if(NOT embree_FOUND)
  find_package(embree 3 REQUIRED)
endif()
find_package(Threads REQUIRED)
set(penumbra_ray_libraries embree Threads::Threads)
