// Resets distance maps. Needs ddgi/field.glsl and an image2D distances.

// Makes a probe see nothing, so that it has no weight.
void fieldSeeNothing(int probe)
{
  const int side = GI_FIELD_DISTANCE + 2;
  for (int i = 0; i < side * side; ++i)
  {
    // A distance of zero in all directions.
    imageStore(distances, fieldTile(probe) * side + ivec2(i % side, i / side), vec4(0.0));
  }
}
