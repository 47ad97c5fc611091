// A translucent occluder is drawn in a share of the shadow map's texels equal to its alpha: in those where its alpha
// exceeds a threshold (hashed alpha testing: Wyman and McGuire 2017; thresholds by an additive recurrence
// over the plane, whose values are evenly distributed over any few neighbours: Roberts 2018, The Unreasonable
// Effectiveness of Quasirandom Sequences). Different props, and the front and back of one prop, use different
// thresholds, so that layers behind each other transmit the product of their transmittances.
uniform int giCasts;    // whether this draws the depth of an occluder
uniform ivec2 giAnchor; // texel in which the pattern of thresholds starts
uniform int giLayer;    // index of the occluder

// Steps of the recurrence in x and y. The first pair is by Roberts. A search found the others: each of them, and the
// product of any two, is even after a filter of 2.5 texels.
const vec2 GiSteps[8] = vec2[8](vec2(0.75487767, 0.56984029), vec2(0.56984029, 0.75487767),
  vec2(0.60507747, 0.45038666), vec2(0.69534107, 0.19934775), vec2(0.84522939, 0.40044350),
  vec2(0.90670314, 0.61051475), vec2(0.61897838, 0.89648935), vec2(0.40882836, 0.69535490));

float giLeastCover()
{
  if (giCasts == 0)
  {
    return 0.0;
  }
  vec2 place = vec2((ivec2(gl_FragCoord.xy) - giAnchor) & 4095);
  int pattern = 2 * giLayer + (gl_FrontFacing ? 0 : 1);
  return fract(dot(place, GiSteps[pattern & 7]) + 0.61803399 * float(pattern >> 3));
}
