// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bake/radiosity/SolutionFile.h"

#include "common/Failure.h"
#include "common/WholeFile.h"

#include <glm/gtc/constants.hpp>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnsignedCharArray.h>
#include <vtkXMLPolyDataWriter.h>

#include <algorithm>
#include <cmath>

namespace penumbra::radiosity
{
namespace
{
/// Adds an array of colours for elements or points.
template <typename ColorOf>
void AddColors(vtkFieldData* fields, const char* name, std::size_t count, const ColorOf& colorOf)
{
  vtkNew<vtkFloatArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(3);
  for (std::size_t i = 0; i < count; ++i)
  {
    const Color color = colorOf(i);
    array->InsertNextTuple(&color[0]);
  }
  fields->AddArray(array);
}

void AddField(vtkPolyData* data, const char* name, const std::vector<double>& values)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  for (const double value : values)
  {
    array->InsertNextValue(value);
  }
  data->GetFieldData()->AddArray(array);
}

void AddFields(vtkPolyData* data, const Solution& solution)
{
  const auto history = [data](const std::string& name, const Reflected& solved) {
    std::vector<double> work;
    std::vector<double> residual;
    for (const SolverStep& step : solved.History)
    {
      work.push_back(step.Work);
      residual.push_back(step.Residual);
    }
    if (!work.empty())
    {
      AddField(data, (name + " work").c_str(), work);
      AddField(data, (name + " residual").c_str(), residual);
    }
  };
  history("gathering", solution.Gathered);
  history("shooting", solution.Shot);
  AddField(data, "rays", { double(solution.Matrix.Rays) });
  AddField(data, "form factor error", { solution.FactorError });
  AddField(data, "patch size", { solution.PatchSize });
}

/// Adds points and their data, with mean reflectance and emission of the patches around them.
void AddPoints(vtkPolyData* data, const Solution& solution)
{
  const SmoothPoints& smooth = solution.Points;
  const std::size_t count = solution.Elements.size();
  std::vector<Color> reflectance(count);
  std::vector<Color> emission(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    reflectance[i] = solution.Elements[i].Reflectance;
    emission[i] = solution.Elements[i].Emission;
  }
  reflectance = MeanAround(smooth, solution.Elements, reflectance);
  emission = MeanAround(smooth, solution.Elements, emission);
  const auto radiosity = [&](std::size_t i) {
    return emission[i] + reflectance[i] * smooth.Irradiance[i];
  };
  AddColors(data->GetPointData(), "radiosity", smooth.Points.size(), radiosity);
  AddColors(data->GetPointData(), "irradiance", smooth.Points.size(),
    [&](std::size_t i) { return smooth.Irradiance[i]; });
  vtkNew<vtkUnsignedCharArray> shown;
  shown->SetName("color");
  shown->SetNumberOfComponents(3);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (std::size_t i = 0; i < smooth.Points.size(); ++i)
  {
    points->InsertNextPoint(&smooth.Points[i][0]);
    const Color light = radiosity(i);
    for (int k = 0; k < 3; ++k)
    {
      constexpr double white = 255.0;
      shown->InsertNextValue(static_cast<unsigned char>(
        std::lround(white * DisplayValue(light[k] / glm::pi<double>()))));
    }
  }
  data->SetPoints(points);
  data->GetPointData()->SetScalars(shown);
}
}

double DisplayValue(double radiance)
{
  constexpr double exponent = 1.0 / 2.2;
  return std::pow(std::clamp(radiance, 0.0, 1.0), exponent);
}

vtkSmartPointer<vtkPolyData> MakePolyData(const Solution& solution)
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  AddPoints(data, solution);
  vtkNew<vtkCellArray> cells;
  std::vector<std::size_t> lit;
  for (std::size_t i = 0; i < solution.Elements.size(); ++i)
  {
    if (solution.Irradiance[i] != Color(0.0) || solution.Elements[i].Emission != Color(0.0))
    {
      lit.push_back(i);
      cells->InsertNextCell({ solution.Points.OfElement[i][0], solution.Points.OfElement[i][1],
        solution.Points.OfElement[i][2] });
    }
  }
  data->SetPolys(cells);
  const auto add = [&](const char* name, const auto& colorOf) {
    AddColors(
      data->GetCellData(), name, lit.size(), [&](std::size_t i) { return colorOf(lit[i]); });
  };
  add("radiosity", [&](std::size_t i) { return solution.Radiosity[i]; });
  add("irradiance", [&](std::size_t i) { return solution.Irradiance[i]; });
  add("albedo", [&](std::size_t i) { return solution.Elements[i].Reflectance; });
  add("emission", [&](std::size_t i) { return solution.Elements[i].Emission / glm::pi<double>(); });
  add("error", [&](std::size_t i) { return solution.Error[i]; });
  AddFields(data, solution);
  return data;
}

void WriteSolution(const std::string& file, const Solution& solution)
{
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(MakePolyData(solution));
  // VTK before 9.3.1 cannot read appended data with newer versions of Expat.
  writer->SetDataModeToBinary();
  if (!tool::WriteWhole(writer, file))
  {
    tool::Fail(
      "'{}' cannot be written: make room on the disk, or choose another file with -o", file);
  }
}
}
