// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bake/radiosity/SolutionFile.h"

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
#include <filesystem>
#include <stdexcept>

namespace penumbra::radiosity
{
namespace
{
vtkSmartPointer<vtkFloatArray> Colors(const char* name)
{
  auto array = vtkSmartPointer<vtkFloatArray>::New();
  array->SetName(name);
  array->SetNumberOfComponents(3);
  return array;
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

/// What the points of the elements get; reflectance and emission are those of the patches around.
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
  auto radiosity = Colors("radiosity");
  auto irradiance = Colors("irradiance");
  vtkNew<vtkUnsignedCharArray> shown;
  shown->SetName("color");
  shown->SetNumberOfComponents(3);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (std::size_t i = 0; i < smooth.Points.size(); ++i)
  {
    points->InsertNextPoint(&smooth.Points[i][0]);
    const Color light = emission[i] + reflectance[i] * smooth.Irradiance[i];
    radiosity->InsertNextTuple(&light[0]);
    irradiance->InsertNextTuple(&smooth.Irradiance[i][0]);
    for (int k = 0; k < 3; ++k)
    {
      constexpr double white = 255.0;
      shown->InsertNextValue(
        static_cast<unsigned char>(std::lround(white * Display(light[k] / glm::pi<double>()))));
    }
  }
  data->SetPoints(points);
  data->GetPointData()->AddArray(radiosity);
  data->GetPointData()->AddArray(irradiance);
  data->GetPointData()->SetScalars(shown);
}
}

double Display(double radiance)
{
  constexpr double exponent = 1.0 / 2.2;
  return std::pow(std::clamp(radiance, 0.0, 1.0), exponent);
}

vtkSmartPointer<vtkPolyData> MakePolyData(const Solution& solution)
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  AddPoints(data, solution);
  vtkNew<vtkCellArray> cells;
  auto radiosity = Colors("radiosity");
  auto irradiance = Colors("irradiance");
  auto albedo = Colors("albedo");
  auto emission = Colors("emission");
  auto error = Colors("error");
  for (std::size_t i = 0; i < solution.Elements.size(); ++i)
  {
    const Element& element = solution.Elements[i];
    if (solution.Irradiance[i] == Color(0.0) && element.Emission == Color(0.0))
    {
      continue;
    }
    cells->InsertNextCell(3);
    for (const std::uint32_t corner : solution.Points.OfElement[i])
    {
      cells->InsertCellPoint(corner);
    }
    const Color radiance = element.Emission / glm::pi<double>();
    radiosity->InsertNextTuple(&solution.Radiosity[i][0]);
    irradiance->InsertNextTuple(&solution.Irradiance[i][0]);
    albedo->InsertNextTuple(&element.Reflectance[0]);
    emission->InsertNextTuple(&radiance[0]);
    error->InsertNextTuple(&solution.Error[i][0]);
  }
  data->SetPolys(cells);
  for (vtkFloatArray* array :
    { radiosity.Get(), irradiance.Get(), albedo.Get(), emission.Get(), error.Get() })
  {
    data->GetCellData()->AddArray(array);
  }
  AddFields(data, solution);
  return data;
}

void WriteSolution(const std::string& file, const Solution& solution)
{
  const std::string partial = file + ".part";
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetFileName(partial.c_str());
  writer->SetInputData(MakePolyData(solution));
  // Debian 12 stumbles over appended data: VTK before 9.3.1 with newer versions of Expat.
  writer->SetDataModeToBinary();
  std::error_code error;
  if (writer->Write() == 0)
  {
    std::filesystem::remove(partial, error);
    throw std::runtime_error(
      "'" + file + "' cannot be written: make room on the disk, or choose another file with -o");
  }
  std::filesystem::rename(partial, file, error);
  if (error)
  {
    throw std::runtime_error("'" + file + "' cannot be written: " + error.message());
  }
}
}
