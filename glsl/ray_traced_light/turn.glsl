// The pixels of a block take turns: in each frame rays go from one of them. Needs shared/view.h.
uniform ivec2 stride; // width and height of blocks: 1x1, 2x1 as on a checkerboard, 2x2 or 4x4

// Which of a square of four comes in a turn of four: opposite corners first.
ivec2 turnQuarter(int turn)
{
  return ivec2(turn & 1, (turn ^ turn >> 1) & 1);
}

bool turnIsCheckerboard()
{
  return stride.x > stride.y;
}

// The pixel from which rays go in this frame, in a block of a row of blocks.
ivec2 turnPlace(int row)
{
  if (turnIsCheckerboard())
  {
    return ivec2((view.Frame.x + row) & 1, 0);
  }
  ivec2 place = ivec2(0);
  int turn = view.Frame.x;
  for (int size = stride.x / 2; size > 0; size /= 2)
  {
    place += size * turnQuarter(turn & 3);
    turn >>= 2;
  }
  return place;
}

// Number of earlier frames in which rays went from that pixel.
int turnNumber()
{
  return view.Frame.x / (stride.x * stride.y);
}
