// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// For programs whose tests listen to VTK's messages themselves, or draw nothing.
#include "Skips.h"

#include <gtest/gtest.h>

int main(int argc, char** argv)
{
  testing::InitGoogleTest(&argc, argv);
  return penumbra_test::RunTests();
}
