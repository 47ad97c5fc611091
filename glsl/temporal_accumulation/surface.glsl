// What is remembered of a pixel's surface, in four floats. Needs lib/octahedral.glsl.
struct GiSeenSurface
{
  vec3 normal;  // in view coordinates
  float depth;  // along the view's z axis, negative before the eye
  int object;
  float frames; // that it was seen on end
};

vec4 giPackSurface(GiSeenSurface seen)
{
  vec2 e = floor(giEncodeOctahedral(seen.normal) * 4095.0 + 0.5);
  return vec4(e.x * 4096.0 + e.y, seen.depth, float(seen.object), seen.frames);
}

GiSeenSurface giUnpackSurface(vec4 stored)
{
  float high = floor(stored.x / 4096.0);
  return GiSeenSurface(giDecodeOctahedral(vec2(high, stored.x - high * 4096.0) / 4095.0), stored.y,
    int(stored.z), stored.w);
}
