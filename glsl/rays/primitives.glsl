// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Intersections of a ray with a triangle, a sphere or a cylinder. Each test returns true if it finds one at a distance
// in [tMin, hit.x), and then sets hit.x to that distance and hit.yz to the surface parameters.

// Shear of a ray along its dominant axis, for the triangle test.
struct RayShear
{
  int axis; // the largest component of the direction
  vec3 shear;
};

vec3 rayPermute(vec3 v, int axis)
{
  return axis == 0 ? v.yzx : (axis == 1 ? v.zxy : v);
}

RayShear rayShear(vec3 direction)
{
  vec3 size = abs(direction);
  RayShear result;
  result.axis = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
  vec3 d = rayPermute(direction, result.axis);
  result.shear = vec3(d.x / d.z, d.y / d.z, 1.0 / d.z);
  return result;
}

// Twice the signed area between the origin and an edge. Exactly negated if the ends are exchanged, even if the compiler
// fuses one product of a difference, and zero if they are equal. `precise`, which forbids that, makes shaders with several
// traversals four times as slow with NVIDIA's driver 580.
float rayEdge(vec2 p, vec2 q)
{
  bool ordered = p.x < q.x || (p.x == q.x && p.y < q.y);
  vec2 first = ordered ? p : q;
  vec2 last = ordered ? q : p;
  float area = first.x * last.y - first.y * last.x;
  return p == q ? 0.0 : (ordered ? area : -area);
}

// Woop, Benthin, Wald 2013, "Watertight ray/triangle intersection" (JCGT 2:1). Both triangles at an
// edge compute the same value for it, so no ray passes between them. The paper's fallback to doubles where
// an edge function is zero is left out: zero counts as inside on both sides, so the fallback would only
// choose between the neighbours.
bool rayTriangle(
  vec3 origin, RayShear ray, float tMin, vec3 v0, vec3 v1, vec3 v2, inout vec3 hit)
{
  vec3 a = rayPermute(v0 - origin, ray.axis);
  vec3 b = rayPermute(v1 - origin, ray.axis);
  vec3 c = rayPermute(v2 - origin, ray.axis);
  vec2 pa = a.xy - ray.shear.xy * a.z;
  vec2 pb = b.xy - ray.shear.xy * b.z;
  vec2 pc = c.xy - ray.shear.xy * c.z;
  float u = rayEdge(pc, pb);
  float v = rayEdge(pa, pc);
  float w = rayEdge(pb, pa);
  bool inside = (u >= 0.0 && v >= 0.0 && w >= 0.0) || (u <= 0.0 && v <= 0.0 && w <= 0.0);
  float area = u + v + w;
  // Divide before multiplying: for a tiny triangle the products would underflow.
  float t = dot(vec3(u, v, w) / area, vec3(a.z, b.z, c.z)) * ray.shear.z;
  if (inside && area != 0.0 && t >= tMin && t < hit.x)
  {
    hit = vec3(t, vec2(v, w) / area);
    return true;
  }
  return false;
}

// Haines, Günther, Akenine-Möller 2019, "Precision improvements for ray/sphere intersection" (Ray
// Tracing Gems, ch. 7): computes the discriminant at the point of the ray nearest to the centre.
bool raySphere(
  vec3 origin, vec3 direction, float tMin, vec3 center, float radius, inout vec3 hit)
{
  float a = dot(direction, direction);
  float middle = dot(center - origin, direction) / a;
  vec3 nearest = origin + middle * direction - center;
  float discriminant = radius * radius - dot(nearest, nearest);
  float halfway = sqrt(max(discriminant, 0.0) / a);
  float t = middle - halfway >= tMin ? middle - halfway : middle + halfway;
  if (discriminant >= 0.0 && t >= tMin && t < hit.x)
  {
    hit = vec3(t, 0.0, 0.0);
    return true;
  }
  return false;
}

// Applies the same method to the component of the ray across the axis, from the point of the ray nearest to the middle
// of the cylinder. hit.y runs from 0 to 1 along the axis; hit.z is 0 on the side and 1 on a cap.
bool rayCylinder(vec3 origin, vec3 direction, float tMin, vec3 end0, vec3 end1, float radius,
  bool capped, inout vec3 hit)
{
  vec3 axis = end1 - end0;
  float axisLength = length(axis);
  axis /= axisLength;
  float start = dot(0.5 * (end0 + end1) - origin, direction) / dot(direction, direction);
  vec3 from = origin + start * direction - end0;
  float along = dot(direction, axis);
  float height = dot(from, axis);
  vec3 across = direction - along * axis;
  vec3 offset = from - height * axis;
  float a = dot(across, across);
  float middle = -dot(offset, across) / a;
  vec3 nearest = offset + middle * across;
  float discriminant = radius * radius - dot(nearest, nearest);
  float halfway = sqrt(max(discriminant, 0.0) / a);
  bool meets = discriminant >= 0.0 && a > 0.0;
  bool found = false;
  for (int i = 0; i < 2; ++i)
  {
    float t = middle + (i == 0 ? -halfway : halfway);
    float h = height + t * along;
    if (meets && h >= 0.0 && h <= axisLength && start + t >= tMin && start + t < hit.x)
    {
      hit = vec3(start + t, h / axisLength, 0.0);
      found = true;
    }
  }
  for (int i = 0; i < 2; ++i)
  {
    float t = (float(i) * axisLength - height) / along;
    vec3 cap = offset + t * across;
    if (capped && along != 0.0 && dot(cap, cap) <= radius * radius && start + t >= tMin &&
      start + t < hit.x)
    {
      hit = vec3(start + t, float(i), 1.0);
      found = true;
    }
  }
  return found;
}
