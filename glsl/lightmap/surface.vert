#version 430 core
// A baked triangle, where the picture shows it.
layout(location = 0) in vec3 position; // relative to the map's origin
layout(location = 1) in vec3 normal;   // world
layout(location = 2) in vec2 place;    // in the map

uniform mat4 mapToView;
uniform mat4 mapToClip;

out vec3 positionVC;
out vec3 normalWC;
out vec2 mapPlace;

void main()
{
  positionVC = (mapToView * vec4(position, 1.0)).xyz;
  normalWC = normal;
  mapPlace = place;
  gl_Position = mapToClip * vec4(position, 1.0);
}
