// Rules of reflection of what VTK draws itself, see rays/SurfaceRules.h. Where a mapper sets no uniforms, they change
// nothing.
#include "lib/compensation.glsl"
#include "lib/data_colors.glsl"
uniform float giAbsorbed; // 1 minus the factor of all diffuse reflectances and base colours
