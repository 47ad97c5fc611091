// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Main function of programs whose tests check VTK's messages themselves, or draw nothing.
#include "Skips.h"

#include <gtest/gtest.h>

int main(int argc, char** argv)
{
  testing::InitGoogleTest(&argc, argv);
  return penumbra_test::RunTests();
}
