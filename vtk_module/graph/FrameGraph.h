// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The frame graph: passes declare by name what they read, write and modify; the graph culls what
 * nobody needs, orders the rest and knows how long each texture lives. It touches no GPU.
 */
#pragma once

#include "gpu/Commands.h"
#include "gpu/ResourcePool.h"

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <variant>
#include <vector>

namespace penumbra
{
class FrameContext;

/// How a pass draws one triangle over the viewport.
struct Drawing
{
  bool CoveredOnly = false; ///< only where resource::Depth, which it reads, has something
  int Stride = 1;           ///< pixels that one of the target stands for, across and down
  /// What the first target is cleared to before, if at all, by its type.
  std::variant<std::monostate, glm::vec4, glm::uvec4> Clear;
};

/// A pass as declared. The kinds of access:
/// - Read: the resource must have a writer, else the frame is in error.
/// - ReadIfPresent: as Read, but the pass also runs without it.
/// - Write: makes the resource. One pass only may write a resource.
/// - Modify: reads one version and writes the next; modifiers run by rising order, all of them
///   before any reader. ModifyIfPresent does nothing where the resource has no writer, and the
///   pass is dropped with it.
/// - DrawOver: as Modify, but the next version is drawn over the one before, in its texture, which
///   the pass cannot read. Not for what may be VTK's own: the picture and its depth.
/// - Histories, which a view keeps from frame to frame, are read and written in the order in which
///   passes are declared; a pass that writes one is needed where a later one that reads it is.
///
/// sampler, image: the name that the pass's shaders have for it; "" takes the shared one of
/// resource::SamplerOf(), if there is one.
class PassDeclaration
{
public:
  explicit PassDeclaration(std::string name)
    : Name(std::move(name))
  {
  }
  PassDeclaration& Read(const std::string& resource, const std::string& sampler = {});
  /// define: is 1 in the pass's shaders where the resource is present.
  PassDeclaration& ReadIfPresent(const std::string& resource, const std::string& define = {},
    const std::string& sampler = {});
  PassDeclaration& Write(
    const std::string& resource, const TextureDesc& desc, const std::string& image = {});
  PassDeclaration& Modify(
    const std::string& resource, int order, const std::string& sampler = {});
  PassDeclaration& ModifyIfPresent(
    const std::string& resource, int order, const std::string& sampler = {});
  PassDeclaration& DrawOver(const std::string& resource, int order);

  PassDeclaration& ReadHistory(History& history, const std::string& sampler);
  /// The pass writes all of it that is read later. image: "" where it draws to it or fills it.
  PassDeclaration& WriteHistory(History& history, const std::string& image = {});
  /// The pass goes on with what is there.
  PassDeclaration& UpdateHistory(History& history, const std::string& image = {});

  /// The pass is needed although nobody reads what it writes.
  PassDeclaration& SideEffect();
  /// Offer to the pass's shaders what some of them take.
  PassDeclaration& Offer(const Arguments& arguments);

  /// What the pass does: run a compute shader,
  PassDeclaration& Compute(const std::string& shader, const Defines& variant,
    const Arguments& given, const Work& work);
  /// draw to its outputs, in the order in which they were declared, by a fragment shader,
  PassDeclaration& Draw(const std::string& shader, const Defines& variant, const Arguments& given,
    const Drawing& drawing = {});
  /// or anything else.
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
    std::string Argument; ///< of shaders
    std::string Define;
  };
  struct HistoryUse
  {
    History* Kept;
    ShaderAccess Access;
    std::string Argument;
  };
  std::string Name;
  std::vector<Access> Accesses;
  std::vector<HistoryUse> Histories;
  Arguments Offered;
  bool HasSideEffect = false;
  std::function<void(FrameContext&)> Action;
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
    std::vector<std::string> OutputOrder;             ///< as declared
    std::map<std::string, std::string> InputSamplers; ///< the shaders' names, by resource
    std::map<std::string, std::string> OutputImages;
    Defines Variant;   ///< of the resources that are present
    Arguments Offered; ///< histories, and what else does not change
    std::vector<History*> Written;
    const std::function<void(FrameContext&)>* Action;
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
  void LinkHistories(Links& links) const;
  Step MakeStep(const PassDeclaration& pass, const Links& links, int number) const;
  std::vector<bool> Needed(const Links& links) const;
  std::vector<int> Order(const Links& links, const std::vector<bool>& needed) const;

  std::vector<std::unique_ptr<PassDeclaration>> Passes;
  std::vector<Version> Table;
  std::vector<Step> Ordered;
};
}
