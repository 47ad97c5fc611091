// By how much of the depth buffer's range surfaces are drawn nearer than they are.
const float GI_LIGHTMAP_NEARER = 1e-3;
