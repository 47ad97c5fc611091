#version 430 core
// Draws a baked triangle at its position in the picture. Variants: GI_LIGHTMAP_DIRECTIONAL.
layout(location = 0) in vec3 position; // relative to the map's origin
layout(location = 1) in vec3 normal;   // in world coordinates
layout(location = 2) in vec2 place;    // texture coordinates in the map

uniform mat4 mapToClip;

#ifdef GI_LIGHTMAP_DIRECTIONAL
out vec3 normalWC;
#endif
out vec2 mapPlace;

void main()
{
#ifdef GI_LIGHTMAP_DIRECTIONAL
  normalWC = normal;
#endif
  mapPlace = place;
  gl_Position = mapToClip * vec4(position, 1.0);
}
