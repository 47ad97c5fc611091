// The light of an arc of a slice, by the cosine to the surface and the measure of directions around
// the view: Jimenez et al. 2016, equation 7.
const float GI_ARC_PI = 3.14159265358979;

// From the view direction to an angle h, for a normal tilted by `tilt`, n: its cosine and sine.
float giArc(float h, float tilt, vec2 n)
{
  return 0.25 * (n.x - cos(2.0 * h - tilt) + 2.0 * h * n.y);
}

// The same from horizon to horizon where nothing rises.
float giOpenArc(float tilt, vec2 n)
{
  return n.x + tilt * n.y;
}

// Nothing below the tangent plane counts.
float giClampArc(float h, float tilt)
{
  return tilt + clamp(h - tilt, -0.5 * GI_ARC_PI, 0.5 * GI_ARC_PI);
}
