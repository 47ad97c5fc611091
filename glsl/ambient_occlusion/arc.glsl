// The light of an arc in a slice, by the cosine to the surface and the measure of directions around
// the view: Jimenez et al. 2016, equation 7, to one side. n: cosine and sine of the angle by which
// the normal leans to that side from the view direction.
const float GI_ARC_PI = 3.14159265358979;

// The angle whose cosine is c, in [-1, 1], to 7e-5: Abramowitz and Stegun 1964, 4.4.45.
float giArcAngle(float c)
{
  float x = abs(c);
  float a = sqrt(max(1.0 - x, 0.0)) *
    (1.5707288 + x * (-0.2121144 + x * (0.0742610 - x * 0.0187293)));
  return c < 0.0 ? GI_ARC_PI - a : a;
}

// From the view direction to one of cosine c and sine s, both above the tangent plane.
float giArc(float c, float s, vec2 n)
{
  return 0.5 * (n.x * s * s + n.y * (giArcAngle(c) - s * c));
}

// From the view direction to the tangent plane.
float giWholeArc(vec2 n)
{
  return giArc(-n.y, n.x, n);
}
