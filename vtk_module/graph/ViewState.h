// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What techniques remember of one view from frame to frame. It goes with the view.
 */
#pragma once

#include <map>
#include <memory>
#include <typeindex>
#include <utility>

namespace penumbra
{
class ViewState
{
public:
  /// The state of one owner, default-constructed when first asked for.
  /// T: the kind of state. An owner has one of each kind.
  template <typename T>
  T& Of(const void* owner)
  {
    std::shared_ptr<void>& state = this->States[{ owner, std::type_index(typeid(T)) }];
    if (!state)
    {
      state = std::make_shared<T>();
    }
    return *static_cast<T*>(state.get());
  }

private:
  std::map<std::pair<const void*, std::type_index>, std::shared_ptr<void>> States;
};
}
