// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Messages.h"

int main(int argc, char** argv)
{
  testing::InitGoogleTest(&argc, argv);
  penumbra_test::WatchMessages();
  return RUN_ALL_TESTS();
}
