  giDisplacement = giDeforms != 0
    ? giPropToView * texelFetch(giPointDisplacements, gl_VertexID).xyz
    : vec3(0.0);
