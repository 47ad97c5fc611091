// Maps of distances. Needs ddgi/field.glsl and an image2D distances.

// A probe that knows nothing yet.
void fieldSeeNothing(int probe)
{
  const int side = GI_FIELD_DISTANCE + 2;
  for (int i = 0; i < side * side; ++i)
  {
    // Surfaces right before it, on all sides.
    imageStore(distances, fieldTile(probe) * side + ivec2(i % side, i / side), vec4(0.0));
  }
}
