// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The frame graph: passes declare by name what they read, write and modify; the graph culls what
 * nobody needs, orders the rest and knows how long each texture lives. It touches no GPU.
 */
#pragma once

#include "gpu/GLObjects.h"

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace penumbra
{
class FrameContext;

/// A pass as declared. The four kinds of access:
/// - Read: the resource must have a writer, else the frame is in error.
/// - ReadIfPresent: as Read, but the pass also runs without it.
/// - Write: makes the resource. One pass only may write a resource.
/// - Modify: reads one version and writes the next; modifiers run by rising order, all of them
///   before any reader. ModifyIfPresent does nothing where the resource has no writer, and the
///   pass is dropped with it.
/// - DrawOver: as Modify, but the next version is drawn over the one before, in its texture, which
///   the pass cannot read. Not for what may be VTK's own: the picture and its depth.
class PassDeclaration
{
public:
  explicit PassDeclaration(std::string name)
    : Name(std::move(name))
  {
  }
  PassDeclaration& Read(const std::string& resource);
  PassDeclaration& ReadIfPresent(const std::string& resource);
  PassDeclaration& Write(const std::string& resource, const TextureDesc& desc);
  PassDeclaration& Modify(const std::string& resource, int order);
  PassDeclaration& ModifyIfPresent(const std::string& resource, int order);
  PassDeclaration& DrawOver(const std::string& resource, int order);
  /// The pass is needed although nobody reads what it writes.
  PassDeclaration& SideEffect();
  PassDeclaration& Execute(std::function<void(FrameContext&)> work);

private:
  friend class FrameGraph;
  enum class Kind
  {
    Read,
    ReadIfPresent,
    Write,
    Modify,
    ModifyIfPresent,
    DrawOver
  };
  struct Access
  {
    std::string Resource;
    Kind How;
    TextureDesc Desc;
    int Order;
  };
  std::string Name;
  std::vector<Access> Accesses;
  bool HasSideEffect = false;
  std::function<void(FrameContext&)> Work;
};

class FrameGraph
{
public:
  static constexpr int None = -1;

  /// One version of one resource, and the ordered passes that first and last touch it.
  struct Version
  {
    std::string Resource;
    TextureDesc Desc;
    int First = None;
    int Last = None;
    bool IsFinal = false; ///< no later version of the resource exists
    int Over = None;      ///< the version in whose texture this one is drawn
  };

  /// A pass in order, with the versions that its names mean.
  struct Step
  {
    std::string Name;
    std::map<std::string, int> Inputs;
    std::map<std::string, int> Outputs;
    const std::function<void(FrameContext&)>* Work;
  };

  PassDeclaration& AddPass(const std::string& name);

  /// Order the passes. Throws std::logic_error, naming passes and resource, where a resource has
  /// two writers, a needed one has none, or passes wait for each other.
  void Compile();

  const std::vector<Step>& Steps() const { return this->Ordered; }
  const std::vector<Version>& Versions() const { return this->Table; }

private:
  struct Links; // which passes make and use which version
  Links Resolve();
  std::vector<bool> Needed(const Links& links) const;
  std::vector<int> Order(const Links& links, const std::vector<bool>& needed) const;

  std::vector<std::unique_ptr<PassDeclaration>> Passes;
  std::vector<Version> Table;
  std::vector<Step> Ordered;
};
}
