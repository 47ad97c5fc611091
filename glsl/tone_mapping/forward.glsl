// Tone mapping of translucent surfaces and volumes, which VTK draws itself. Variant: GI_AUTO, see exposure.glsl.
#include "lib/tone.glsl"
#include "tone_mapping/exposure.glsl"
uniform int curve;
uniform bool giMapsTones; // false in programs of mappers that set no uniforms

vec3 giDisplayed(vec3 color, bool encoded)
{
  return giMapsTones ? giTone(curve, exposureScale() * color, encoded) : color;
}
