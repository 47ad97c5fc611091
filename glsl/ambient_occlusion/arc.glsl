// Light from an arc of directions in a slice, weighted by the cosine at the surface and by the solid angle around
// the view direction: Jimenez et al. 2016, equation 7, for one side. n: cosine and sine of the angle by which
// the normal leans to that side from the view direction.
const float GI_ARC_PI = 3.14159265358979;

// Angle from 0 to pi with cosine c and sine s, to within 0.002. A least-squares fit of the ratio of angle to sine.
float giArcAngle(float c, float s)
{
  float x = abs(c);
  float a = s * (1.56924 + x * (-0.96331 + x * (0.57752 - x * 0.18576)));
  return c < 0.0 ? GI_ARC_PI - a : a;
}

// Light of the arc from the view direction to the angle with cosine c and sine s, both above the tangent plane.
float giArc(float c, float s, vec2 n)
{
  return 0.5 * (n.x * s * s + n.y * (giArcAngle(c, s) - s * c));
}

// Mean direction of that light times the light. x: across the view; y: toward the eye.
vec2 giArcMoment(float c, float s, vec2 n)
{
  float c3 = c * c * c;
  float s3 = s * s * s;
  return vec2(n.x * s3 + n.y * (2.0 - 3.0 * c + c3), n.x * (1.0 - c3) + n.y * s3) / 3.0;
}

// Light of the arc from the view direction to the tangent plane.
float giWholeArc(vec2 n)
{
  return giArc(-n.y, n.x, n);
}
