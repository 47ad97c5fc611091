// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The object factory that lets vtkRenderWindow::New() return a vtkHeadlessRenderWindow if there is
 * no display.
 */
#pragma once

namespace penumbra
{
/// Register the factory before all others, or unregister it. Repeated calls change nothing.
void SetHeadlessFactory(bool registered);
bool HasHeadlessFactory();
}
