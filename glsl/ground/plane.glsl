// The ground at a pixel. Needs shared/view.h, lib/reconstruct.glsl.
uniform vec4 plane; // xyz: normal, w: distance from the eye along it, negative; in view coordinates
uniform vec4 disc;  // xyz: middle; w: radius

struct GiGround
{
  vec3 P;
  float opacity; // 0 if the ground is not there
};

GiGround giGroundAt(vec2 window)
{
  vec3 near = giViewPosition(window, 0.0);
  bool parallel = view.Scene.y > 0.5;
  vec3 origin = parallel ? near : vec3(0.0);
  vec3 direction = parallel ? vec3(0.0, 0.0, -1.0) : near;
  float along = (plane.w - dot(plane.xyz, origin)) / min(dot(plane.xyz, direction), -1e-20);
  GiGround ground;
  ground.P = origin + along * direction;
  // The smallest part of the radius keeps the horizon, where numbers overflow, outside.
  float away = length(ground.P - disc.xyz) / disc.w;
  ground.opacity = along > 0.0 && away < 1.0 ? 1.0 - smoothstep(0.5, 1.0, away) : 0.0;
  return ground;
}
