// History of a pixel's surface, packed in four floats. Needs lib/octahedral.glsl.
struct GiSurfaceRecord
{
  vec3 normal;  // in view coordinates
  float depth;  // view-space z, negative in front of the eye
  int object;
  float frames; // number of consecutive frames in which it was visible
};

vec4 giPackSurface(GiSurfaceRecord surface)
{
  vec2 e = floor(giEncodeOctahedral(surface.normal) * 4095.0 + 0.5);
  return vec4(e.x * 4096.0 + e.y, surface.depth, float(surface.object), surface.frames);
}

GiSurfaceRecord giUnpackSurface(vec4 stored)
{
  float high = floor(stored.x / 4096.0);
  return GiSurfaceRecord(giDecodeOctahedral(vec2(high, stored.x - high * 4096.0) / 4095.0), stored.y,
    int(stored.z), stored.w);
}
