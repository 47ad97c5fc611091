// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * State that techniques keep for a view from frame to frame. It is deleted with the view.
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
  /// The state of an owner, default-constructed at first use. An owner has one state of each type T.
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

  /// An existing state, or nullptr.
  template <typename T>
  const T* Find(const void* owner) const
  {
    const auto found = this->States.find({ owner, std::type_index(typeid(T)) });
    return found == this->States.end() ? nullptr : static_cast<const T*>(found->second.get());
  }

private:
  std::map<std::pair<const void*, std::type_index>, std::shared_ptr<void>> States;
};

/// Finds views between frames, for queries to a technique about a renderer.
class ViewDirectory
{
public:
  virtual ~ViewDirectory() = default;
  /// State of a renderer's view, for its first eye; nullptr if the renderer was never drawn.
  virtual const ViewState* FindView(vtkRenderer* renderer) const = 0;
};
}
