// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bake/radiosity/Patches.h"

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <vtkBoundingBox.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace penumbra::radiosity
{
struct PatchRays::Internals
{
  RTCDevice Device = nullptr;
  RTCScene Scene = nullptr;
  std::vector<char> Passable; ///< 1 for elements that light passes
  Point Center{ 0.0 };
  double Offset = 0.0; ///< distance of ray origins from their surface

  /// Ignores hits on passable sides.
  static void Filter(const RTCFilterFunctionNArguments* arguments)
  {
    const auto& passable = *static_cast<std::vector<char>*>(arguments->geometryUserPtr);
    for (unsigned int i = 0; i < arguments->N; ++i)
    {
      if (arguments->valid[i] != 0)
      {
        const std::uint32_t patch = RTCHitN_primID(arguments->hit, arguments->N, i);
        const float facing = RTCHitN_Ng_x(arguments->hit, arguments->N, i) *
            RTCRayN_dir_x(arguments->ray, arguments->N, i) +
          RTCHitN_Ng_y(arguments->hit, arguments->N, i) *
            RTCRayN_dir_y(arguments->ray, arguments->N, i) +
          RTCHitN_Ng_z(arguments->hit, arguments->N, i) *
            RTCRayN_dir_z(arguments->ray, arguments->N, i);
        arguments->valid[i] = passable[2 * patch + (facing < 0.0f ? 0 : 1)] ? 0 : -1;
      }
    }
  }

  void Build(const std::vector<Element>& elements)
  {
    const std::size_t count = elements.size() / 2;
    RTCGeometry geometry = rtcNewGeometry(this->Device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* points = static_cast<float*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), 3 * count));
    auto* corners = static_cast<unsigned int*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned int), count));
    bool passes = false;
    for (std::size_t i = 0; i < count; ++i)
    {
      for (unsigned int k = 0; k < 3; ++k)
      {
        const Point at = elements[2 * i].Corners[k] - this->Center;
        for (int axis = 0; axis < 3; ++axis)
        {
          points[9 * i + 3 * k + axis] = static_cast<float>(at[axis]);
        }
        corners[3 * i + k] = static_cast<unsigned int>(3 * i + k);
      }
    }
    for (std::size_t i = 0; i < elements.size(); ++i)
    {
      this->Passable[i] = elements[i].Present ? 0 : 1;
      passes = passes || !elements[i].Present;
    }
    if (passes)
    {
      rtcSetGeometryUserData(geometry, &this->Passable);
      rtcSetGeometryIntersectFilterFunction(geometry, Filter);
      rtcSetGeometryOccludedFilterFunction(geometry, Filter);
    }
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(this->Scene, geometry);
    rtcReleaseGeometry(geometry);
    rtcSetSceneFlags(this->Scene, RTC_SCENE_FLAG_ROBUST);
    rtcCommitScene(this->Scene);
  }

  RTCRay Ray(const Point& from, const Point& normal, const Point& direction) const
  {
    const Point start = from - this->Center + this->Offset * normal;
    RTCRay ray{};
    ray.org_x = static_cast<float>(start.x);
    ray.org_y = static_cast<float>(start.y);
    ray.org_z = static_cast<float>(start.z);
    ray.dir_x = static_cast<float>(direction.x);
    ray.dir_y = static_cast<float>(direction.y);
    ray.dir_z = static_cast<float>(direction.z);
    ray.tfar = std::numeric_limits<float>::infinity();
    ray.mask = ~0u;
    return ray;
  }

  bool Occluded(RTCRay& ray) const
  {
#if RTC_VERSION_MAJOR >= 4
    rtcOccluded1(this->Scene, &ray);
#else
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcOccluded1(this->Scene, &context, &ray);
#endif
    return ray.tfar < 0.0f;
  }
};

PatchRays::PatchRays(const std::vector<Element>& elements)
  : Internal(std::make_unique<Internals>())
{
  Internals& e = *this->Internal;
  vtkBoundingBox bounds;
  for (const Element& element : elements)
  {
    for (const Point& corner : element.Corners)
    {
      bounds.AddPoint(corner.x, corner.y, corner.z);
    }
  }
  if (bounds.IsValid())
  {
    // Floats near the scene's edge have an error of 6e-8 of its size, and hits several times that.
    constexpr double offset = 2e-6;
    bounds.GetCenter(&e.Center[0]);
    e.Offset = offset * bounds.GetDiagonalLength();
  }
  e.Passable.resize(elements.size());
  e.Device = rtcNewDevice(nullptr);
  if (!e.Device)
  {
    throw std::runtime_error("Embree cannot be started");
  }
  e.Scene = rtcNewScene(e.Device);
  e.Build(elements);
}

PatchRays::~PatchRays()
{
  rtcReleaseScene(this->Internal->Scene);
  rtcReleaseDevice(this->Internal->Device);
}

PatchRays::Hit PatchRays::Nearest(
  const Point& from, const Point& normal, const Point& direction) const
{
  RTCRayHit query{};
  query.ray = this->Internal->Ray(from, normal, direction);
  query.hit.geomID = query.hit.primID = query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
#if RTC_VERSION_MAJOR >= 4
  rtcIntersect1(this->Internal->Scene, &query);
#else
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect1(this->Internal->Scene, &context, &query);
#endif
  Hit hit;
  if (query.hit.geomID != RTC_INVALID_GEOMETRY_ID)
  {
    const double facing =
      query.hit.Ng_x * direction.x + query.hit.Ng_y * direction.y + query.hit.Ng_z * direction.z;
    hit = { 2 * query.hit.primID + (facing < 0.0 ? 0u : 1u), query.ray.tfar, query.hit.u,
      query.hit.v };
  }
  return hit;
}

bool PatchRays::Occluded(
  const Point& from, const Point& normal, const Point& to, const Point& toNormal) const
{
  // Both ends are offset from their surfaces, so that these do not occlude.
  const Point along =
    (to + this->Internal->Offset * toNormal) - (from + this->Internal->Offset * normal);
  RTCRay ray = this->Internal->Ray(from, normal, along);
  ray.tfar = 1.0f;
  return this->Internal->Occluded(ray);
}

bool PatchRays::OccludedTowards(
  const Point& from, const Point& normal, const Point& direction) const
{
  RTCRay ray = this->Internal->Ray(from, normal, direction);
  return this->Internal->Occluded(ray);
}
}
