// The pixels of a block of stride x stride take turns: in each frame rays go from one of them. Needs shared/view.h.
uniform int stride; // 1, 2 or 4

// Which of a square of four comes in a turn of four: opposite corners first.
ivec2 turnQuarter(int turn)
{
  return ivec2(turn & 1, (turn ^ turn >> 1) & 1);
}

// The pixel of each block from which rays go in this frame.
ivec2 turnPlace()
{
  ivec2 place = ivec2(0);
  int turn = view.Frame.x;
  for (int size = stride / 2; size > 0; size /= 2)
  {
    place += size * turnQuarter(turn & 3);
    turn >>= 2;
  }
  return place;
}

// Number of earlier frames in which rays went from that pixel.
int turnNumber()
{
  return view.Frame.x / (stride * stride);
}
