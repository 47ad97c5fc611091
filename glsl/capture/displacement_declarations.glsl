// Inserted into a mapper's vertex shader (GLSL 1.50): the vector from each point to its position in the previous frame.
uniform int giDeforms;
uniform samplerBuffer giPointDisplacements; // in the prop's coordinates, by point index
uniform mat3 giPropToView;
out vec3 giDisplacement;
