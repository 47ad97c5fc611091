// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graph/FrameGraph.h"

#include <algorithm>
#include <stdexcept>

namespace penumbra
{
PassDeclaration& PassDeclaration::Read(const std::string& resource)
{
  this->Accesses.push_back({ resource, Kind::Read, {}, 0 });
  return *this;
}

PassDeclaration& PassDeclaration::ReadIfPresent(const std::string& resource)
{
  this->Accesses.push_back({ resource, Kind::ReadIfPresent, {}, 0 });
  return *this;
}

PassDeclaration& PassDeclaration::Write(const std::string& resource, const TextureDesc& desc)
{
  this->Accesses.push_back({ resource, Kind::Write, desc, 0 });
  return *this;
}

PassDeclaration& PassDeclaration::Modify(const std::string& resource, int order)
{
  this->Accesses.push_back({ resource, Kind::Modify, {}, order });
  return *this;
}

PassDeclaration& PassDeclaration::ModifyIfPresent(const std::string& resource, int order)
{
  this->Accesses.push_back({ resource, Kind::ModifyIfPresent, {}, order });
  return *this;
}

PassDeclaration& PassDeclaration::DrawOver(const std::string& resource, int order)
{
  this->Accesses.push_back({ resource, Kind::DrawOver, {}, order });
  return *this;
}

PassDeclaration& PassDeclaration::SideEffect()
{
  this->HasSideEffect = true;
  return *this;
}

PassDeclaration& PassDeclaration::Execute(std::function<void(FrameContext&)> work)
{
  this->Work = std::move(work);
  return *this;
}

PassDeclaration& FrameGraph::AddPass(const std::string& name)
{
  this->Passes.push_back(std::make_unique<PassDeclaration>(name));
  return *this->Passes.back();
}

struct FrameGraph::Links
{
  std::vector<int> Maker;                                  ///< by version
  std::vector<std::map<std::string, int>> Inputs, Outputs; ///< by pass
};

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
    links.Maker.push_back(pass);
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
    Kind How;
  };
  std::vector<Modifier> modifiers;
  const int count = static_cast<int>(this->Passes.size());
  for (int pass = 0; pass < count; ++pass)
  {
    for (const auto& access : this->Passes[pass]->Accesses)
    {
      if (access.How == Kind::Modify || access.How == Kind::ModifyIfPresent ||
        access.How == Kind::DrawOver)
      {
        modifiers.push_back({ access.Order, pass, access.Resource, access.How });
      }
      if (access.How != Kind::Write)
      {
        continue;
      }
      const auto other = latest.find(access.Resource);
      if (other != latest.end())
      {
        throw std::logic_error("frame graph: the passes '" +
          this->Passes[links.Maker[other->second]]->Name + "' and '" + this->Passes[pass]->Name +
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
      if (modifier.How == Kind::ModifyIfPresent)
      {
        continue;
      }
      throw missing(modifier.Pass, modifier.Resource);
    }
    links.Inputs[modifier.Pass][modifier.Resource] = found->second;
    const int before = found->second;
    const TextureDesc desc = this->Table[before].Desc;
    addVersion(modifier.Resource, desc, modifier.Pass);
    this->Table.back().Over = modifier.How == Kind::DrawOver ? before : None;
  }
  for (const auto& last : latest)
  {
    this->Table[last.second].IsFinal = true;
  }
  for (int pass = 0; pass < count; ++pass)
  {
    for (const auto& access : this->Passes[pass]->Accesses)
    {
      if (access.How != Kind::Read && access.How != Kind::ReadIfPresent)
      {
        continue;
      }
      const auto found = latest.find(access.Resource);
      if (found != latest.end())
      {
        links.Inputs[pass][access.Resource] = found->second;
      }
      else if (access.How == Kind::Read)
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
      pending.push_back(links.Maker[input.second]);
    }
  }
  return needed;
}

std::vector<int> FrameGraph::Order(const Links& links, const std::vector<bool>& needed) const
{
  const int count = static_cast<int>(this->Passes.size());
  std::vector<int> order;
  std::vector<bool> done(count, false);
  // Few passes: repeated scans keep the declared order among passes that are free to run.
  for (bool progress = true; progress;)
  {
    progress = false;
    for (int pass = 0; pass < count && !progress; ++pass)
    {
      if (done[pass] || !needed[pass])
      {
        continue;
      }
      const bool ready = std::all_of(links.Inputs[pass].begin(), links.Inputs[pass].end(),
        [&](const auto& input) { return done[links.Maker[input.second]]; });
      if (ready)
      {
        done[pass] = true;
        order.push_back(pass);
        progress = true;
      }
    }
  }
  for (int pass = 0; pass < count; ++pass)
  {
    if (needed[pass] && !done[pass])
    {
      throw std::logic_error("frame graph: the pass '" + this->Passes[pass]->Name +
        "' waits for a pass that waits for it");
    }
  }
  return order;
}

void FrameGraph::Compile()
{
  this->Table.clear();
  this->Ordered.clear();
  const Links links = this->Resolve();
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
    this->Ordered.push_back({ this->Passes[pass]->Name, links.Inputs[pass], links.Outputs[pass],
      &this->Passes[pass]->Work });
  }
}
}
