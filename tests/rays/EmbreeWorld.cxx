// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "RayStage.h"

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <atomic>
#include <cmath>
#include <thread>

using namespace penumbra;

namespace penumbra_test
{
struct EmbreeWorld::Internals
{
  RTCDevice Device = nullptr;
  RTCScene Scene = nullptr;

  RTCGeometry MakeTriangles(const RayGeometry& geometry) const
  {
    RTCGeometry result = rtcNewGeometry(this->Device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* points = static_cast<glm::vec3*>(rtcSetNewGeometryBuffer(result, RTC_BUFFER_TYPE_VERTEX,
      0, RTC_FORMAT_FLOAT3, sizeof(glm::vec3), geometry.Points.size()));
    std::copy(geometry.Points.begin(), geometry.Points.end(), points);
    auto* corners = static_cast<glm::uvec3*>(rtcSetNewGeometryBuffer(result, RTC_BUFFER_TYPE_INDEX,
      0, RTC_FORMAT_UINT3, sizeof(glm::uvec3), geometry.Triangles.size()));
    std::copy(geometry.Triangles.begin(), geometry.Triangles.end(), corners);
    rtcCommitGeometry(result);
    return result;
  }

  void TraceRay(const shared::RayQuery& ray, shared::RayAnswer& answer) const
  {
    RTCRayHit hit{};
    hit.ray = { ray.Origin.x, ray.Origin.y, ray.Origin.z, ray.Origin.w, ray.Direction.x,
      ray.Direction.y, ray.Direction.z, 0.0f, ray.Direction.w, ~0u, 0, 0 };
    hit.hit.geomID = hit.hit.primID = hit.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
#if RTC_VERSION_MAJOR >= 4
    rtcIntersect1(this->Scene, &hit);
#else
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(this->Scene, &context, &hit);
#endif
    const bool found = hit.hit.geomID != RTC_INVALID_GEOMETRY_ID;
    answer.Hit = glm::ivec2(found ? static_cast<int>(hit.hit.instID[0]) : -1,
      found ? static_cast<int>(hit.hit.primID) : -1);
    answer.Barycentrics = glm::vec2(hit.hit.u, hit.hit.v);
    answer.Distance = hit.ray.tfar;
  }

  void TracePacket(const shared::RayQuery* rays, shared::RayAnswer* answers) const
  {
    alignas(32) int valid[8];
    RTCRayHit8 hit{};
    for (int i = 0; i < 8; ++i)
    {
      valid[i] = -1;
      hit.ray.org_x[i] = rays[i].Origin.x;
      hit.ray.org_y[i] = rays[i].Origin.y;
      hit.ray.org_z[i] = rays[i].Origin.z;
      hit.ray.tnear[i] = rays[i].Origin.w;
      hit.ray.dir_x[i] = rays[i].Direction.x;
      hit.ray.dir_y[i] = rays[i].Direction.y;
      hit.ray.dir_z[i] = rays[i].Direction.z;
      hit.ray.tfar[i] = rays[i].Direction.w;
      hit.ray.mask[i] = ~0u;
      hit.hit.geomID[i] = hit.hit.primID[i] = hit.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
    }
#if RTC_VERSION_MAJOR >= 4
    RTCIntersectArguments arguments;
    rtcInitIntersectArguments(&arguments);
    arguments.flags = RTC_RAY_QUERY_FLAG_COHERENT;
    rtcIntersect8(valid, this->Scene, &hit, &arguments);
#else
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    rtcIntersect8(valid, this->Scene, &context, &hit);
#endif
    for (int i = 0; i < 8; ++i)
    {
      const bool found = hit.hit.geomID[i] != RTC_INVALID_GEOMETRY_ID;
      answers[i].Hit = glm::ivec2(found ? static_cast<int>(hit.hit.instID[0][i]) : -1,
        found ? static_cast<int>(hit.hit.primID[i]) : -1);
      answers[i].Distance = hit.ray.tfar[i];
    }
  }

  void TraceShadowRay(const shared::RayQuery& ray, shared::RayAnswer& answer) const
  {
    RTCRay shadow = { ray.Origin.x, ray.Origin.y, ray.Origin.z, ray.Origin.w, ray.Direction.x,
      ray.Direction.y, ray.Direction.z, 0.0f, ray.Direction.w, ~0u, 0, 0 };
#if RTC_VERSION_MAJOR >= 4
    rtcOccluded1(this->Scene, &shadow);
#else
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcOccluded1(this->Scene, &context, &shadow);
#endif
    answer.Hit = glm::ivec2(shadow.tfar < 0.0f ? 0 : -1, -1);
  }
};

EmbreeWorld::EmbreeWorld(const RayWorld& world)
  : Internal(std::make_unique<Internals>())
{
  Internals& e = *this->Internal;
  e.Device = rtcNewDevice(nullptr);
  std::vector<RTCScene> meshes;
  for (const RayGeometry& geometry : world.Meshes)
  {
    RTCScene scene = rtcNewScene(e.Device);
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
    RTCGeometry triangles = e.MakeTriangles(geometry);
    rtcAttachGeometry(scene, triangles);
    rtcReleaseGeometry(triangles);
    rtcCommitScene(scene);
    meshes.push_back(scene);
  }
  e.Scene = rtcNewScene(e.Device);
  rtcSetSceneFlags(e.Scene, RTC_SCENE_FLAG_ROBUST);
  for (std::size_t i = 0; i < world.Instances.size(); ++i)
  {
    const RayWorld::Placement& placement = world.Instances[i];
    glm::dmat4 matrix = placement.MeshToWorld;
    matrix[3] = matrix * glm::dvec4(world.Meshes[placement.Mesh].Origin, 1.0);
    matrix[3] -= glm::dvec4(world.Center, 0.0);
    const glm::mat4 rounded(matrix);
    RTCGeometry instance = rtcNewGeometry(e.Device, RTC_GEOMETRY_TYPE_INSTANCE);
    rtcSetGeometryInstancedScene(instance, meshes[placement.Mesh]);
    rtcSetGeometryTransform(instance, 0, RTC_FORMAT_FLOAT4X4_COLUMN_MAJOR, &rounded[0][0]);
    rtcCommitGeometry(instance);
    rtcAttachGeometryByID(e.Scene, instance, static_cast<unsigned int>(i));
    rtcReleaseGeometry(instance);
  }
  for (RTCScene mesh : meshes)
  {
    rtcReleaseScene(mesh);
  }
  rtcCommitScene(e.Scene);
}

EmbreeWorld::~EmbreeWorld()
{
  rtcReleaseScene(this->Internal->Scene);
  rtcReleaseDevice(this->Internal->Device);
}

Seconds EmbreeWorld::Trace(const Rays& rays, Answers& answers, Mode mode) const
{
  answers.resize(rays.size());
  const Seconds begin = Seconds::Now();
  std::atomic<std::size_t> next{ 0 };
  const auto traceParts = [&] {
    constexpr std::size_t part = 4096;
    for (std::size_t first; (first = next.fetch_add(part)) < rays.size();)
    {
      const std::size_t last = std::min(first + part, rays.size());
      for (std::size_t i = first; i < last;)
      {
        if (mode == Packets && i + 8 <= last)
        {
          this->Internal->TracePacket(&rays[i], &answers[i]);
          i += 8;
          continue;
        }
        mode == Occluded ? this->Internal->TraceShadowRay(rays[i], answers[i])
                         : this->Internal->TraceRay(rays[i], answers[i]);
        ++i;
      }
    }
  };
  std::vector<std::thread> threads;
  for (unsigned int i = 1; i < std::max(1u, std::thread::hardware_concurrency()); ++i)
  {
    threads.emplace_back(traceParts);
  }
  traceParts();
  for (std::thread& thread : threads)
  {
    thread.join();
  }
  return begin.Since();
}
}
