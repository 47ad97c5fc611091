// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// Rejects a scene with too many triangles as soon as their number is known.
#pragma once

#include "common/Failure.h"

#include <vtkType.h>

#include <string>

namespace penumbra::tool
{
class TriangleBudget
{
public:
  explicit TriangleBudget(vtkIdType limit)
    : Limit(limit)
  {
  }

  /// Throws a Failure if an object's triangles would exceed the limit. what: the object's name.
  void Require(vtkIdType triangles, const std::string& what) const
  {
    const vtkIdType all = this->Spent + triangles;
    if (all > this->Limit)
    {
      Fail("{} brings the scene to {} triangles and the limit is {}: simplify it, or give "
           "--max-triangles {}",
        what, all, this->Limit, all);
    }
  }

  void Spend(vtkIdType triangles, const std::string& what)
  {
    this->Require(triangles, what);
    this->Spent += triangles;
  }

  vtkIdType GetSpent() const { return this->Spent; }

private:
  vtkIdType Limit;
  vtkIdType Spent = 0;
};
}
