// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Rays see the blocks of composite mappers as VTK draws them.
#include "Agreement.h"
#include "CompositeMapper.h"

#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkCompositePolyDataMapper.h"
#include "vtkDataSetMapper.h"
#include "vtkElevationFilter.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkRTAnalyticSource.h"
#include "vtkSphereSource.h"
#include "vtkThreshold.h"
#include "vtkLookupTable.h"

using namespace penumbra_test;

namespace
{
vtkSmartPointer<vtkPolyData> Block(double x, double y, bool scalars)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(x, y, 0.0);
  sphere->SetThetaResolution(48);
  sphere->SetPhiResolution(48);
  vtkNew<vtkElevationFilter> elevation;
  elevation->SetInputConnection(sphere->GetOutputPort());
  elevation->SetLowPoint(0.0, -0.5, 0.0);
  elevation->SetHighPoint(0.0, 0.5, 0.0);
  elevation->Update();
  vtkSmartPointer<vtkPolyData> data = vtkPolyData::SafeDownCast(elevation->GetOutput());
  if (!scalars)
  {
    data->GetPointData()->SetScalars(nullptr);
  }
  return data;
}

// Flat indices: 1 and 2 are blocks, 3 is a branch of 4 and 5.
vtkSmartPointer<vtkMultiBlockDataSet> Tree(bool scalars)
{
  vtkNew<vtkMultiBlockDataSet> branch;
  branch->SetBlock(0, Block(0.0, 1.2, scalars));
  branch->SetBlock(1, Block(1.2, 1.2, scalars));
  auto tree = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  tree->SetBlock(0, Block(0.0, 0.0, scalars));
  tree->SetBlock(1, Block(1.2, 0.0, false));
  tree->SetBlock(2, branch);
  return tree;
}

vtkSmartPointer<CompositeMapper> AddTree(Stage& stage, bool scalars)
{
  auto mapper = vtkSmartPointer<CompositeMapper>::New();
  mapper->SetInputDataObject(Tree(scalars));
  vtkNew<vtkCompositeDataDisplayAttributes> attributes;
  mapper->SetCompositeDataDisplayAttributes(attributes);
  stage.Add(mapper)->GetProperty()->SetSpecular(0.2);
  return mapper;
}
}

TEST(PathsComposite, Blocks)
{
  Stage stage;
  AddTree(stage, false);
  LightFromCamera(stage);
  ExpectAgreement(stage, "blocks");
}

TEST(PathsComposite, ScalarColoursAndBlocksWithoutScalars)
{
  Stage stage;
  AddTree(stage, true);
  LightFromCamera(stage);
  ExpectAgreement(stage, "blocks-scalars");
}

TEST(PathsComposite, MissingScalarsHaveTheNaNColour)
{
  Stage stage;
  auto mapper = AddTree(stage, true);
  vtkNew<vtkLookupTable> table;
  table->SetNanColor(0.1, 0.9, 0.2, 1.0);
  mapper->SetLookupTable(table);
  mapper->ColorMissingArraysWithNanColorOn();
  LightFromCamera(stage);
  ExpectAgreement(stage, "blocks-nan");
}

TEST(PathsComposite, ColoursAndVisibilityAreInherited)
{
  Stage stage;
  auto mapper = AddTree(stage, true);
  LightFromCamera(stage);
  mapper->SetBlockColor(1, 0.9, 0.1, 0.2);
  mapper->SetBlockColor(3, 0.1, 0.2, 0.9);
  mapper->SetBlockColor(5, 0.1, 0.8, 0.1);
  mapper->SetBlockVisibility(2, false);
  ExpectAgreement(stage, "blocks-colours");
}

TEST(PathsComposite, AHiddenBranchMayHaveAVisibleLeaf)
{
  Stage stage;
  auto mapper = AddTree(stage, false);
  LightFromCamera(stage);
  mapper->SetBlockVisibility(3, false);
  mapper->SetBlockVisibility(5, true);
  ExpectAgreement(stage, "blocks-visibility");
}

TEST(PathsComposite, PlainMappersAndPlainData)
{
  Stage stage;
  vtkNew<vtkCompositePolyDataMapper> tree;
  tree->SetInputDataObject(Tree(true));
  stage.Add(tree);
  vtkNew<CompositeMapper> plain;
  plain->SetInputDataObject(Block(0.6, 2.4, false));
  stage.Add(plain);
  LightFromCamera(stage);
  ExpectAgreement(stage, "blocks-plain-mapper");
}

TEST(PathsComposite, RaysPassTranslucentBlocks)
{
  Stage stage;
  auto mapper = AddTree(stage, false);
  LightFromCamera(stage);
  mapper->SetBlockOpacity(3, 0.5);
  Agreement found = CompareWithRaster(stage);
  // Rays pass by chance, so only means are compared: 16 rays of standard deviation 1/2 in each of thousands of pixels.
  // VTK blends front and back in any order, which is close to what a ray through both gives.
  const Picture& rays = found.Rays;
  const Picture& raster = found.Raster;
  const double a = rays.MeanGrey(0, raster.Height / 2, raster.Width, raster.Height);
  const double b = raster.MeanGrey(0, raster.Height / 2, raster.Width, raster.Height);
  EXPECT_NEAR(a, b, 0.1 * b);
}

TEST(PathsDataSet, IsVisibleInTheFirstFrame)
{
  Stage stage;
  vtkNew<vtkRTAnalyticSource> wavelet;
  wavelet->SetWholeExtent(-4, 4, -4, 4, -4, 4);
  vtkNew<vtkThreshold> threshold;
  threshold->SetInputConnection(wavelet->GetOutputPort());
  threshold->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "RTData");
  threshold->SetUpperThreshold(150.0);
  threshold->SetThresholdFunction(vtkThreshold::THRESHOLD_UPPER);
  vtkNew<vtkDataSetMapper> mapper;
  mapper->SetInputConnection(threshold->GetOutputPort());
  mapper->SetScalarRange(100.0, 260.0);
  stage.Add(mapper);
  LightFromCamera(stage);
  ExpectAgreement(stage, "data-set-mapper");
}
