// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The frame graph: passes declare by name what they read, write and modify. The graph culls passes whose results
 * are not needed, orders the others and computes the lifetime of each texture. It does not use the GPU.
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

/// Triangles whose corners a vertex shader computes from gl_VertexID.
struct Shape
{
  std::string Shader; ///< "" for one triangle that covers the viewport, at the far plane
  int Vertices = 3;
};

/// Options for drawing one triangle over the viewport.
struct Drawing
{
  bool CoveredOnly = false; ///< draw only where resource::Depth, a required input, has a surface
  int Stride = 1;           ///< width in pixels of the block that a pixel of the target represents
  /// Value to which the first target is cleared before, of the target's type; none by default.
  std::variant<std::monostate, glm::vec4, glm::uvec4> Clear;
};

/// Declaration of a pass. The kinds of access:
/// - Read: the resource must have a writer, else compiling the graph fails.
/// - ReadIfPresent: as Read, but the pass also runs without the resource.
/// - Write: creates the resource. Only one pass may write a resource.
/// - Modify: reads one version and writes the next. Modifiers run in ascending order, all of them
///   before any reader. ModifyIfPresent does nothing if the resource has no writer; the
///   pass is then culled unless it has another use. DrawOverIfPresent likewise.
/// - DrawOver: as Modify, but the new version is drawn over the previous one, in the same texture, which
///   the pass cannot read. Not for the depth, whose texture may be VTK's own.
/// - Histories, which outlive the frame, are read and written in the order in which
///   passes are declared. A pass that writes a history is needed if a later pass that reads it is needed.
///
/// sampler, image: name of the texture in the pass's shaders; "" means the shared name of
/// resource::SamplerOf(), if there is one.
class PassDeclaration
{
public:
  explicit PassDeclaration(std::string name)
    : Name(std::move(name))
  {
  }
  PassDeclaration& Read(const std::string& resource, const std::string& sampler = {});
  /// define: macro that is 1 in the pass's shaders if the resource is present.
  PassDeclaration& ReadIfPresent(
    const std::string& resource, const std::string& define = {}, const std::string& sampler = {});
  PassDeclaration& Write(
    const std::string& resource, const TextureDesc& desc, const std::string& image = {});
  PassDeclaration& Modify(const std::string& resource, int order, const std::string& sampler = {});
  PassDeclaration& ModifyIfPresent(
    const std::string& resource, int order, const std::string& sampler = {});
  PassDeclaration& DrawOver(const std::string& resource, int order);
  PassDeclaration& DrawOverIfPresent(const std::string& resource, int order);

  PassDeclaration& ReadHistory(History& history, const std::string& sampler);
  /// The pass overwrites everything in the history that is read later. image: "" if it draws to the history or clears
  /// it.
  PassDeclaration& WriteHistory(History& history, const std::string& image = {});
  /// The pass reads the history and writes it in place.
  PassDeclaration& UpdateHistory(History& history, const std::string& image = {});

  /// The pass is needed even if nobody reads its outputs.
  PassDeclaration& SideEffect();
  /// Offer arguments that only some of the pass's shaders use.
  PassDeclaration& Offer(const Arguments& arguments);
  /// The technique that the pass belongs to, for statistics.
  PassDeclaration& OwnedBy(const std::string& technique);

  /// Set the pass's action: run a compute shader,
  PassDeclaration& Compute(
    const std::string& shader, const Defines& variant, const Arguments& given, const Work& work);
  /// draw to its outputs, in the order of their declaration, with a fragment shader,
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
    DrawOver,
    DrawOverIfPresent
  };
  static bool IsModifier(Kind kind) { return kind >= Kind::Modify; }
  static bool IsOptional(Kind kind)
  {
    return kind == Kind::ModifyIfPresent || kind == Kind::DrawOverIfPresent;
  }
  static bool IsOver(Kind kind)
  {
    return kind == Kind::DrawOver || kind == Kind::DrawOverIfPresent;
  }
  struct Access
  {
    std::string Resource;
    Kind AccessKind;
    TextureDesc Desc;
    int Order;
    std::string Argument; ///< name in the shaders
    std::string Define;
  };
  struct HistoryUse
  {
    History* Target;
    ShaderAccess Access;
    std::string Argument;
  };
  std::string Name;
  std::string Owner;
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

  /// A version of a resource, and the positions of the steps that use it first and last.
  struct Version
  {
    std::string Resource;
    TextureDesc Desc;
    int First = None;
    int Last = None;
    bool IsFinal = false; ///< whether the last version of the resource is this one or drawn over it
    int Over = None;      ///< the version over which, in its texture, this one is drawn
  };

  /// A pass in execution order, with the versions of the resources that it names.
  struct Step
  {
    std::string Name;
    std::string Owner; ///< a technique, or ""
    std::map<std::string, int> Inputs;
    std::map<std::string, int> Outputs;
    std::vector<std::string> OutputOrder;             ///< as declared
    std::map<std::string, std::string> InputSamplers; ///< names in the shaders, by resource
    std::map<std::string, std::string> OutputImages;
    Defines Variant;   ///< defines of the resources that are present
    Arguments Offered; ///< histories and other arguments that are known when the graph is compiled
    std::vector<History*> Written;
    const std::function<void(FrameContext&)>* Action;
  };

  PassDeclaration& AddPass(const std::string& name);
  /// Whether a pass that was added writes this resource.
  bool IsWritten(const std::string& resource) const;

  /// Order the passes. Throws std::logic_error, naming passes and resource, if a resource has
  /// two writers, a required one has none, or passes wait for each other.
  void Compile();

  const std::vector<Step>& Steps() const { return this->Ordered; }
  const std::vector<Version>& Versions() const { return this->Table; }

private:
  struct Links; // the passes' relations through versions and histories
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
