// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// A test with a window whose context is current; skipped where the backend is not available.
#pragma once

#include "Stage.h"

#include "vtkHeadlessRenderWindow.h"

#include <gtest/gtest.h>

namespace penumbra_test
{
class WindowTest : public testing::Test
{
protected:
  void SetUp() override
  {
    if (!HasBackend())
    {
      GTEST_SKIP() << "the backend is not available";
    }
    this->Window = vtkSmartPointer<vtkHeadlessRenderWindow>::New();
    this->Window->Initialize();
    this->Window->MakeCurrent();
  }

  vtkSmartPointer<vtkHeadlessRenderWindow> Window;
};
}
