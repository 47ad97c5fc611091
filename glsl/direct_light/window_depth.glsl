// The window's depth of a surface: that between the camera's own clipping planes.
uniform vec2 depthWindow; // depths of these planes

float giWindowDepth(float depth)
{
  return clamp((depth - depthWindow.x) / (depthWindow.y - depthWindow.x), 0.0, 1.0);
}
