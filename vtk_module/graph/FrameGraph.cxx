// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graph/FrameGraph.h"

#include "graph/FrameContext.h"

#include <algorithm>
#include <queue>
#include <stdexcept>

namespace penumbra
{
PassDeclaration& PassDeclaration::Read(const std::string& resource, const std::string& sampler)
{
  this->Accesses.push_back({ resource, Kind::Read, {}, 0, sampler, {} });
  return *this;
}

PassDeclaration& PassDeclaration::ReadIfPresent(
  const std::string& resource, const std::string& define, const std::string& sampler)
{
  this->Accesses.push_back({ resource, Kind::ReadIfPresent, {}, 0, sampler, define });
  return *this;
}

PassDeclaration& PassDeclaration::Write(
  const std::string& resource, const TextureDesc& desc, const std::string& image)
{
  this->Accesses.push_back({ resource, Kind::Write, desc, 0, image, {} });
  return *this;
}

PassDeclaration& PassDeclaration::Modify(
  const std::string& resource, int order, const std::string& sampler)
{
  this->Accesses.push_back({ resource, Kind::Modify, {}, order, sampler, {} });
  return *this;
}

PassDeclaration& PassDeclaration::ModifyIfPresent(
  const std::string& resource, int order, const std::string& sampler)
{
  this->Accesses.push_back({ resource, Kind::ModifyIfPresent, {}, order, sampler, {} });
  return *this;
}

PassDeclaration& PassDeclaration::DrawOver(const std::string& resource, int order)
{
  this->Accesses.push_back({ resource, Kind::DrawOver, {}, order, {}, {} });
  return *this;
}

PassDeclaration& PassDeclaration::DrawOverIfPresent(const std::string& resource, int order)
{
  this->Accesses.push_back({ resource, Kind::DrawOverIfPresent, {}, order, {}, {} });
  return *this;
}

PassDeclaration& PassDeclaration::ReadHistory(History& history, const std::string& sampler)
{
  this->Histories.push_back({ &history, ShaderAccess::Read, sampler });
  return *this;
}

PassDeclaration& PassDeclaration::WriteHistory(History& history, const std::string& image)
{
  this->Histories.push_back({ &history, ShaderAccess::Write, image });
  return *this;
}

PassDeclaration& PassDeclaration::UpdateHistory(History& history, const std::string& image)
{
  this->Histories.push_back({ &history, ShaderAccess::ReadWrite, image });
  return *this;
}

PassDeclaration& PassDeclaration::SideEffect()
{
  this->HasSideEffect = true;
  return *this;
}

PassDeclaration& PassDeclaration::OwnedBy(const std::string& technique)
{
  this->Owner = technique;
  return *this;
}

PassDeclaration& PassDeclaration::Offer(const Arguments& arguments)
{
  this->Offered.Add(arguments);
  return *this;
}

PassDeclaration& PassDeclaration::Compute(
  const std::string& shader, const Defines& variant, const Arguments& given, const Work& work)
{
  return this->Execute([shader, variant, given, work](FrameContext& context) {
    context.Dispatch(shader, variant, given, work);
  });
}

PassDeclaration& PassDeclaration::Draw(
  const std::string& shader, const Defines& variant, const Arguments& given, const Drawing& drawing)
{
  return this->Execute([shader, variant, given, drawing](
                         FrameContext& context) { context.Draw(shader, variant, given, drawing); });
}

PassDeclaration& PassDeclaration::Execute(std::function<void(FrameContext&)> work)
{
  this->Action = std::move(work);
  return *this;
}

PassDeclaration& FrameGraph::AddPass(const std::string& name)
{
  this->Passes.push_back(std::make_unique<PassDeclaration>(name));
  return *this->Passes.back();
}

bool FrameGraph::IsWritten(const std::string& resource) const
{
  return std::any_of(this->Passes.begin(), this->Passes.end(), [&](const auto& pass) {
    return std::any_of(pass->Accesses.begin(), pass->Accesses.end(), [&](const auto& access) {
      return access.Resource == resource && access.AccessKind == PassDeclaration::Kind::Write;
    });
  });
}

struct FrameGraph::Links
{
  std::vector<int> Writer;                                 ///< by version: the pass that writes it
  std::vector<std::map<std::string, int>> Inputs, Outputs; ///< by pass
  std::vector<std::vector<int>>
    HistoryWriters; ///< by pass: the writers of the histories that it reads
  std::vector<std::vector<int>>
    Predecessors; ///< by pass: users of histories before it overwrites them
};

void FrameGraph::LinkHistories(Links& links) const
{
  struct Last
  {
    int Writer = None;
    std::vector<int> Readers; ///< since that writer
  };
  std::map<const History*, Last> histories;
  links.HistoryWriters.resize(this->Passes.size());
  links.Predecessors.resize(this->Passes.size());
  for (int pass = 0; pass < static_cast<int>(this->Passes.size()); ++pass)
  {
    for (const auto& use : this->Passes[pass]->Histories)
    {
      Last& last = histories[use.Target];
      if (last.Writer == pass)
      {
        continue; // the pass has declared another use of this history
      }
      if (use.Access != ShaderAccess::Write && last.Writer != None)
      {
        links.HistoryWriters[pass].push_back(last.Writer);
      }
      if (use.Access == ShaderAccess::Read)
      {
        last.Readers.push_back(pass);
        continue;
      }
      auto& earlier = links.Predecessors[pass];
      std::copy_if(last.Readers.begin(), last.Readers.end(), std::back_inserter(earlier),
        [pass](int reader) { return reader != pass; });
      if (last.Writer != None)
      {
        earlier.push_back(last.Writer);
      }
      last = { pass, {} };
    }
  }
}

FrameGraph::Links FrameGraph::Resolve()
{
  using Kind = PassDeclaration::Kind;
  Links links;
  links.Inputs.resize(this->Passes.size());
  links.Outputs.resize(this->Passes.size());
  std::map<std::string, int> latest;
  const auto addVersion = [&](const std::string& resource, const TextureDesc& desc, int pass) {
    latest[resource] = static_cast<int>(this->Table.size());
    links.Outputs[pass][resource] = latest[resource];
    links.Writer.push_back(pass);
    Version version;
    version.Resource = resource;
    version.Desc = desc;
    this->Table.push_back(version);
  };

  struct Modifier
  {
    int Order;
    int Pass;
    std::string Resource;
    Kind AccessKind;
  };
  std::vector<Modifier> modifiers;
  const int count = static_cast<int>(this->Passes.size());
  for (int pass = 0; pass < count; ++pass)
  {
    for (const auto& access : this->Passes[pass]->Accesses)
    {
      if (PassDeclaration::IsModifier(access.AccessKind))
      {
        modifiers.push_back({ access.Order, pass, access.Resource, access.AccessKind });
      }
      if (access.AccessKind != Kind::Write)
      {
        continue;
      }
      const auto other = latest.find(access.Resource);
      if (other != latest.end())
      {
        throw std::logic_error("frame graph: the passes '" +
          this->Passes[links.Writer[other->second]]->Name + "' and '" + this->Passes[pass]->Name +
          "' both write '" + access.Resource + "'");
      }
      addVersion(access.Resource, access.Desc, pass);
    }
  }
  std::stable_sort(modifiers.begin(), modifiers.end(),
    [](const Modifier& a, const Modifier& b) { return a.Order < b.Order; });
  const auto missing = [this](int pass, const std::string& resource) {
    return std::logic_error("frame graph: the pass '" + this->Passes[pass]->Name + "' needs '" +
      resource + "', which no pass writes");
  };
  for (const auto& modifier : modifiers)
  {
    const auto found = latest.find(modifier.Resource);
    if (found == latest.end())
    {
      if (PassDeclaration::IsOptional(modifier.AccessKind))
      {
        continue;
      }
      throw missing(modifier.Pass, modifier.Resource);
    }
    links.Inputs[modifier.Pass][modifier.Resource] = found->second;
    const int before = found->second;
    const TextureDesc desc = this->Table[before].Desc;
    addVersion(modifier.Resource, desc, modifier.Pass);
    this->Table.back().Over = PassDeclaration::IsOver(modifier.AccessKind) ? before : None;
  }
  for (const auto& last : latest)
  {
    for (int version = last.second; version != None; version = this->Table[version].Over)
    {
      this->Table[version].IsFinal = true;
    }
  }
  for (int pass = 0; pass < count; ++pass)
  {
    for (const auto& access : this->Passes[pass]->Accesses)
    {
      if (access.AccessKind != Kind::Read && access.AccessKind != Kind::ReadIfPresent)
      {
        continue;
      }
      const auto found = latest.find(access.Resource);
      if (found != latest.end())
      {
        links.Inputs[pass][access.Resource] = found->second;
      }
      else if (access.AccessKind == Kind::Read)
      {
        throw missing(pass, access.Resource);
      }
    }
  }
  return links;
}

std::vector<bool> FrameGraph::Needed(const Links& links) const
{
  std::vector<bool> needed(this->Passes.size(), false);
  std::vector<int> pending;
  for (int pass = 0; pass < static_cast<int>(this->Passes.size()); ++pass)
  {
    if (this->Passes[pass]->HasSideEffect)
    {
      pending.push_back(pass);
    }
  }
  while (!pending.empty())
  {
    const int pass = pending.back();
    pending.pop_back();
    if (needed[pass])
    {
      continue;
    }
    needed[pass] = true;
    for (const auto& input : links.Inputs[pass])
    {
      pending.push_back(links.Writer[input.second]);
    }
    pending.insert(
      pending.end(), links.HistoryWriters[pass].begin(), links.HistoryWriters[pass].end());
  }
  return needed;
}

std::vector<int> FrameGraph::Order(const Links& links, const std::vector<bool>& needed) const
{
  const int count = static_cast<int>(this->Passes.size());
  std::vector<std::vector<int>> successors(count);
  std::vector<int> waits(count, 0);
  const auto wait = [&](int pass, int other) {
    if (needed[other])
    {
      successors[other].push_back(pass);
      ++waits[pass];
    }
  };
  // Of the passes that are ready, the one declared first runs next.
  std::priority_queue<int, std::vector<int>, std::greater<>> ready;
  for (int pass = 0; pass < count; ++pass)
  {
    if (!needed[pass])
    {
      continue;
    }
    for (const auto& input : links.Inputs[pass])
    {
      wait(pass, links.Writer[input.second]);
    }
    for (const auto* others : { &links.HistoryWriters[pass], &links.Predecessors[pass] })
    {
      std::for_each(others->begin(), others->end(), [&](int other) { wait(pass, other); });
    }
    if (waits[pass] == 0)
    {
      ready.push(pass);
    }
  }
  std::vector<int> order;
  while (!ready.empty())
  {
    order.push_back(ready.top());
    ready.pop();
    for (const int pass : successors[order.back()])
    {
      if (--waits[pass] == 0)
      {
        ready.push(pass);
      }
    }
  }
  for (int pass = 0; pass < count; ++pass)
  {
    if (waits[pass] > 0)
    {
      throw std::logic_error("frame graph: the pass '" + this->Passes[pass]->Name +
        "' waits for a pass that waits for it");
    }
  }
  return order;
}

FrameGraph::Step FrameGraph::MakeStep(
  const PassDeclaration& pass, const Links& links, int number) const
{
  using Kind = PassDeclaration::Kind;
  Step step;
  step.Name = pass.Name;
  step.Inputs = links.Inputs[number];
  step.Outputs = links.Outputs[number];
  step.Owner = pass.Owner;
  step.Offered = pass.Offered;
  step.Action = &pass.Action;
  for (const auto& access : pass.Accesses)
  {
    if (access.AccessKind != Kind::Read && access.AccessKind != Kind::ReadIfPresent &&
      step.Outputs.count(access.Resource) > 0)
    {
      step.OutputOrder.push_back(access.Resource);
    }
    if (access.AccessKind == Kind::Write && !access.Argument.empty())
    {
      step.OutputImages[access.Resource] = access.Argument;
    }
    const bool read = access.AccessKind != Kind::Write &&
      !PassDeclaration::IsOver(access.AccessKind) &&
      step.Inputs.count(access.Resource) > 0;
    if (read)
    {
      step.InputSamplers[access.Resource] =
        access.Argument.empty() ? resource::SamplerOf(access.Resource) : access.Argument;
    }
    if (read && !access.Define.empty())
    {
      step.Variant[access.Define] = "1";
    }
  }
  for (const auto& use : pass.Histories)
  {
    if (use.Access != ShaderAccess::Read)
    {
      step.Written.push_back(use.Target);
    }
    if (use.Argument.empty())
    {
      continue;
    }
    if (use.Access == ShaderAccess::Read)
    {
      step.Offered.Sample(use.Argument, &use.Target->Storage);
    }
    else
    {
      step.Offered.Image(use.Argument, use.Target->Storage, use.Access);
    }
  }
  return step;
}

void FrameGraph::Compile()
{
  this->Table.clear();
  this->Ordered.clear();
  Links links = this->Resolve();
  this->LinkHistories(links);
  const std::vector<int> order = this->Order(links, this->Needed(links));
  for (int position = 0; position < static_cast<int>(order.size()); ++position)
  {
    const int pass = order[position];
    for (const auto* side : { &links.Inputs[pass], &links.Outputs[pass] })
    {
      for (const auto& used : *side)
      {
        Version& version = this->Table[used.second];
        version.First = version.First == None ? position : version.First;
        version.Last = position;
      }
    }
    this->Ordered.push_back(this->MakeStep(*this->Passes[pass], links, pass));
  }
}
}
