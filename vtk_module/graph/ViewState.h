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

class vtkRenderer;

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

  /// The same, or nullptr where it was never asked for.
  template <typename T>
  const T* Find(const void* owner) const
  {
    const auto found = this->States.find({ owner, std::type_index(typeid(T)) });
    return found == this->States.end() ? nullptr : static_cast<const T*>(found->second.get());
  }

private:
  std::map<std::pair<const void*, std::type_index>, std::shared_ptr<void>> States;
};

/// Finds views between frames, for those who ask a technique about a renderer.
class ViewDirectory
{
public:
  virtual ~ViewDirectory() = default;
  /// The state of a renderer's view, of its first eye; nullptr where it was never drawn.
  virtual const ViewState* FindView(vtkRenderer* renderer) const = 0;
};
}
