#include "forward/head.glsl"
// Stands in for VTK's templates, to find out whether these parts compile.
in vec4 vertexVC;
in vec3 normalVCVSOutput;
out vec4 fragOutput0;
#include "shadow_maps/forward.glsl"
#include "forward/lights.glsl"

void main()
{
#include "forward/surface.glsl"
  giArriveAt(vertexVC);
  fragOutput0 = vec4(giArrives[0]);
}
