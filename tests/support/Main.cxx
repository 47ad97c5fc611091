// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Messages.h"
#include "Skips.h"

int main(int argc, char** argv)
{
  testing::InitGoogleTest(&argc, argv);
  penumbra_test::WatchMessages();
  return penumbra_test::RunTests();
}
