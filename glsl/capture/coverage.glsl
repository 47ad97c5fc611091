// What covers a texel in part casts its shadow by as many of the texels as it covers: where its alpha
// exceeds a threshold (hashed alpha testing: Wyman and McGuire 2017; thresholds by an additive recurrence
// over the plane, of which every few neighbours hold an even spread: Roberts 2018, The Unreasonable
// Effectiveness of Quasirandom Sequences). Layers that one prop puts behind another, or its back behind its
// front, have thresholds of their own, so that they let through the product of what each lets through.
uniform int giCasts;    // whether a caster's depth is drawn
uniform ivec2 giAnchor; // the texel in which the thresholds' pattern starts
uniform int giLayer;    // of the casters, which

// Steps of the recurrence in x and y. The first pair is Roberts', the others were searched for: each alone
// and any two multiplied are even after a filter of 2.5 texels.
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
