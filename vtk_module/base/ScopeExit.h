// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Calls a function when a scope ends, however it ends.
 */
#pragma once

#include <utility>

namespace penumbra
{
template <typename Action>
class ScopeExit
{
public:
  explicit ScopeExit(Action undo)
    : Undo(std::move(undo))
  {
  }
  ~ScopeExit() { this->Undo(); }
  ScopeExit(const ScopeExit&) = delete;
  ScopeExit& operator=(const ScopeExit&) = delete;

private:
  Action Undo;
};
}
