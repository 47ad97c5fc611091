// View-space positions from window depth. Needs shared/view.h.
vec3 giViewPosition(vec2 window, float depth)
{
  vec2 ndc = (window - view.Viewport.xy) / view.Viewport.zw * 2.0 - 1.0;
  vec4 p = view.ClipToView * vec4(ndc, depth * 2.0 - 1.0, 1.0);
  return p.xyz / p.w;
}

// View-space z at a window depth.
float giViewDepth(float depth)
{
  float ndc = depth * 2.0 - 1.0;
  return (view.ClipToView[2].z * ndc + view.ClipToView[3].z) /
    (view.ClipToView[2].w * ndc + view.ClipToView[3].w);
}

// Unit vector from a point to the eye.
vec3 giToEye(vec3 position)
{
  return view.Scene.y > 0.5 ? vec3(0.0, 0.0, 1.0) : normalize(-position);
}
