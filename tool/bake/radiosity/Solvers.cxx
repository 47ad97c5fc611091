// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bake/radiosity/Solvers.h"

#include <algorithm>
#include <cmath>

namespace penumbra::radiosity
{
namespace
{
constexpr int MaximumSweeps = 1000;

double Power(const Color& exitance, const Element& element)
{
  return (std::abs(exitance.x) + std::abs(exitance.y) + std::abs(exitance.z)) * element.Area;
}

/// The first reflection of arriving light.
std::vector<Color> FirstReflection(const LightBalance& balance)
{
  std::vector<Color> light(balance.Elements.size());
  for (std::size_t i = 0; i < light.size(); ++i)
  {
    light[i] = balance.Elements[i].Reflectance * balance.Arriving[i];
  }
  return light;
}

double TotalPower(const std::vector<Color>& light, const LightBalance& balance)
{
  double power = 0.0;
  for (std::size_t i = 0; i < light.size(); ++i)
  {
    power += Power(light[i], balance.Elements[i]);
  }
  return power;
}

Color Gathered(const FactorMatrix& factors, std::size_t row, const std::vector<Color>& light)
{
  Color sum(0.0);
  factors.ForEachIn(row, [&](std::size_t j, double factor) { sum += factor * light[j]; });
  return sum;
}

/// The progress of a residual that decreases exponentially.
double FractionDone(double residual, double tolerance)
{
  return residual > 0.0 ? std::clamp(std::log(residual) / std::log(tolerance), 0.0, 1.0) : 1.0;
}
}

double GreatestReflectance(const std::vector<Element>& elements)
{
  double greatest = 0.0;
  for (const Element& element : elements)
  {
    const Color& r = element.Reflectance;
    greatest = std::max({ greatest, r.x, r.y, r.z });
  }
  return greatest;
}

Reflected GatherLight(const LightBalance& balance, double tolerance, const tool::Progress& advance)
{
  const std::vector<Color> first = FirstReflection(balance);
  const double initial = TotalPower(first, balance);
  Reflected result;
  result.Light = first;
  result.Converged = initial == 0.0;
  for (int sweep = 0; sweep < MaximumSweeps && !result.Converged; ++sweep)
  {
    double change = 0.0;
    for (std::size_t i = 0; i < first.size(); ++i)
    {
      const Element& element = balance.Elements[i];
      const Color next =
        first[i] + element.Reflectance * Gathered(balance.Factors, i, result.Light);
      change += Power(next - result.Light[i], element);
      result.Light[i] = next;
    }
    result.History.push_back({ sweep + 1.0, change / initial });
    result.Converged = change / initial <= tolerance;
    if (advance)
    {
      advance(FractionDone(change / initial, tolerance));
    }
  }
  return result;
}

Reflected ShootLight(const LightBalance& balance, double tolerance, const tool::Progress& advance)
{
  // Column i of F holds what the others get of i's power; by reciprocity A_j F_ji = A_i F_ij.
  const FactorMatrix columns = Transpose(balance.Factors);
  const double whole = std::max<double>(1.0, double(columns.Entries.size()));
  Reflected result;
  result.Light = FirstReflection(balance);
  std::vector<Color> unshot = result.Light;
  const double initial = TotalPower(unshot, balance);
  result.Converged = initial == 0.0;
  double work = 0.0;
  while (!result.Converged && work < MaximumSweeps)
  {
    double most = 0.0;
    for (std::size_t i = 0; i < unshot.size(); ++i)
    {
      most = std::max(most, Power(unshot[i], balance.Elements[i]));
    }
    for (std::size_t i = 0; i < unshot.size(); ++i)
    {
      if (Power(unshot[i], balance.Elements[i]) < 0.5 * most)
      {
        continue;
      }
      const Color shot = unshot[i];
      unshot[i] = Color(0.0);
      columns.ForEachIn(i, [&](std::size_t j, double factor) {
        const Color more = balance.Elements[j].Reflectance * (factor * shot);
        result.Light[j] += more;
        unshot[j] += more;
      });
      work += double(columns.Begin[i + 1] - columns.Begin[i]) / whole;
    }
    const double residual = TotalPower(unshot, balance) / initial;
    result.History.push_back({ work, residual });
    result.Converged = residual <= tolerance;
    if (advance)
    {
      advance(FractionDone(residual, tolerance));
    }
  }
  return result;
}

std::vector<Color> TotalIrradiance(const LightBalance& balance, const std::vector<Color>& reflected)
{
  std::vector<Color> irradiance = balance.Arriving;
  for (std::size_t i = 0; i < irradiance.size(); ++i)
  {
    irradiance[i] += Gathered(balance.Factors, i, reflected);
  }
  return irradiance;
}
}
