// Into a mapper's vertex shader (GLSL 1.50): how far each point was from here, one frame ago.
uniform int giDeforms;
uniform samplerBuffer giPointDisplacements; // in the prop's coordinates, by the point's number
uniform mat3 giPropToView;
out vec3 giDisplacement;
