// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Hardware selection and picking give the same results with the pass as without.
#include "Scenes.h"

#include "vtkAssemblyNode.h"
#include "vtkAssemblyPath.h"
#include "vtkDataObject.h"
#include "vtkHardwareSelector.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkPropCollection.h"
#include "vtkPropPicker.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"
#include "vtkWorldPointPicker.h"

namespace penumbra_test
{
namespace
{
using Selected = std::map<int, std::vector<vtkIdType>>;

int IndexOf(const Scene& scene, vtkObjectBase* prop)
{
  return prop == scene.Ball ? 1 : prop == scene.Box ? 2 : prop == scene.Glass ? 3 : 0;
}

int IndexOf(const Scene& scene, vtkAssemblyPath* path)
{
  return path ? IndexOf(scene, path->GetLastNode()->GetViewProp()) : 0;
}

Selected Select(Scene& scene, int association)
{
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(scene.Renderer);
  selector->SetFieldAssociation(association);
  selector->SetArea(20, 30, 300, 200);
  vtkSmartPointer<vtkSelection> selection;
  selection.TakeReference(selector->Select());
  Selected found;
  for (unsigned int i = 0; selection && i < selection->GetNumberOfNodes(); ++i)
  {
    vtkSelectionNode* node = selection->GetNode(i);
    auto& ids = found[IndexOf(scene, node->GetProperties()->Get(vtkSelectionNode::PROP()))];
    auto* list = vtkIdTypeArray::SafeDownCast(node->GetSelectionList());
    ids.assign(list->GetPointer(0), list->GetPointer(0) + list->GetNumberOfValues());
    std::sort(ids.begin(), ids.end());
  }
  return found;
}

TEST(Selection, OfCellsAndPointsEqualsStock)
{
  for (const int association :
    { vtkDataObject::FIELD_ASSOCIATION_CELLS, vtkDataObject::FIELD_ASSOCIATION_POINTS })
  {
    Scene scene;
    scene.Window->Render();
    const Selected stock = Select(scene, association);
    ASSERT_EQ(stock.size(), 3u);
    vtkGIPass* pass = scene.SetPass();
    scene.Window->Render();
    EXPECT_EQ(Select(scene, association), stock);
    pass->SetPreset("balanced");
    scene.Window->Render();
    EXPECT_EQ(Select(scene, association), stock);
    EXPECT_EQ(Select(scene, association), stock) << "the second time";
  }
}

TEST(Selection, LeavesThePictureUnchanged)
{
  Scene scene;
  scene.SetPass();
  const Picture before = Shoot(scene.Window);
  Select(scene, vtkDataObject::FIELD_ASSOCIATION_CELLS);
  ExpectSame(before, Shoot(scene.Window), 1.0);
}

std::vector<int> PickGrid(Scene& scene)
{
  std::vector<int> picked;
  for (int y = 20; y < 240; y += 40)
  {
    for (int x = 20; x < 320; x += 40)
    {
      picked.push_back(IndexOf(scene, scene.Renderer->PickProp(x, y)));
    }
  }
  return picked;
}

TEST(Selection, OfPropsByPickingEqualsStock)
{
  Scene scene(false);
  scene.Window->Render();
  const std::vector<int> stock = PickGrid(scene);
  EXPECT_GT(std::count(stock.begin(), stock.end(), 1), 0);
  EXPECT_GT(std::count(stock.begin(), stock.end(), 2), 0);
  scene.SetPass();
  scene.Window->Render();
  EXPECT_EQ(PickGrid(scene), stock);
}

TEST(Selection, OfPropsFromAListEqualsStock)
{
  const auto pick = [](bool withPass) {
    Scene scene(false);
    if (withPass)
    {
      scene.SetPass();
    }
    scene.Window->Render();
    vtkNew<vtkPropCollection> list;
    list->AddItem(scene.Box);
    std::vector<int> picked;
    for (int x = 10; x < 320; x += 10)
    {
      picked.push_back(IndexOf(scene, scene.Renderer->PickPropFrom(x, 120, list)));
    }
    return picked;
  };
  const std::vector<int> stock = pick(false);
  EXPECT_GT(std::count(stock.begin(), stock.end(), 2), 0);
  EXPECT_EQ(std::count(stock.begin(), stock.end(), 1), 0);
  EXPECT_EQ(pick(true), stock);
}

TEST(Selection, OfPositionsByPickersEqualsStock)
{
  const auto pick = [](bool withPass) {
    Scene scene;
    if (withPass)
    {
      scene.SetPass()->SetPreset("balanced");
    }
    scene.Window->Render();
    std::vector<double> found;
    vtkNew<vtkPropPicker> props;
    vtkNew<vtkWorldPointPicker> points;
    for (int x = 60; x < 300; x += 30)
    {
      props->Pick(x, 120, 0, scene.Renderer);
      points->Pick(x, 120, 0, scene.Renderer);
      found.insert(found.end(), props->GetPickPosition(), props->GetPickPosition() + 3);
      found.insert(found.end(), points->GetPickPosition(), points->GetPickPosition() + 3);
    }
    return found;
  };
  const std::vector<double> stock = pick(false);
  const std::vector<double> ours = pick(true);
  ASSERT_EQ(stock.size(), ours.size());
  for (std::size_t i = 0; i < stock.size(); ++i)
  {
    EXPECT_NEAR(stock[i], ours[i], 1e-4);
  }
}
}
}
