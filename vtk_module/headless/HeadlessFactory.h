// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The object factory that lets vtkRenderWindow::New() give a vtkHeadlessRenderWindow where there is
 * no display.
 */
#pragma once

namespace penumbra
{
/// Registers the factory before all others, or takes it away; repeating changes nothing.
void SetHeadlessFactory(bool registered);
bool HasHeadlessFactory();
}
