#version 430 core
// Draws the ground into the G-buffer, as the square of ground/square.vert. See SceneCapture::AddSurface() and
// capture/declarations.glsl. Variants: GI_EXTENDED, and the requested targets GI_SURROUNDINGS, GI_DISPLACEMENT and
// GI_FACET.
#include "shared/view.h"
#include "lib/octahedral.glsl"
#include "lib/reconstruct.glsl"
#include "ground/plane.glsl"

layout(binding = 0) uniform sampler2D depthTexture;

uniform bool hides;    // whether the ground hides props below it
uniform vec3 color;
uniform int material;

layout(location = 0) out vec4 albedo;
layout(location = 1) out vec4 normal;
layout(location = 2) out vec4 ambient;
#ifdef GI_EXTENDED
layout(location = 3) out vec4 surface;
layout(location = 4) out vec4 emission;
#endif
// Requested targets follow, in this order.
#ifdef GI_EXTENDED
#define FIRST 5
#define SECOND 6
#define THIRD 7
#else
#define FIRST 3
#define SECOND 4
#define THIRD 5
#endif
#ifdef GI_SURROUNDINGS
layout(location = FIRST) out vec4 surroundings;
#endif
#ifdef GI_DISPLACEMENT
#ifdef GI_SURROUNDINGS
layout(location = SECOND) out vec4 displacement;
#else
layout(location = FIRST) out vec4 displacement;
#endif
#endif
#ifdef GI_FACET
#if defined(GI_SURROUNDINGS) && defined(GI_DISPLACEMENT)
layout(location = THIRD) out vec4 facet;
#elif defined(GI_SURROUNDINGS) || defined(GI_DISPLACEMENT)
layout(location = SECOND) out vec4 facet;
#else
layout(location = FIRST) out vec4 facet;
#endif
#endif

void main()
{
  GiGround ground = giGroundAt(gl_FragCoord.xy);
  if (ground.opacity <= 0.0 || (!hides && texelFetch(depthTexture, ivec2(gl_FragCoord.xy), 0).r < 1.0))
  {
    discard;
  }
  albedo = vec4(color, 1.0);
  normal = vec4(giEncodeOctahedral(plane.xyz), float(material) / 65535.0, 1.0);
  ambient = vec4(0.0);
#ifdef GI_EXTENDED
  surface = vec4(1.0);
  emission = vec4(0.0, 0.0, 0.0, 1.0);
#endif
#ifdef GI_SURROUNDINGS
  surroundings = vec4(0.0, 0.0, 0.0, 1.0);
#endif
#ifdef GI_DISPLACEMENT
  displacement = vec4(0.0, 0.0, 0.0, 1.0);
#endif
#ifdef GI_FACET
  facet = vec4(normal.xy, 0.0, 1.0);
#endif
}
