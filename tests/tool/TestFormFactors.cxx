// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Form factors against analytic ones: Howell, Mengüç, Daun, Siegel 2020, "Thermal Radiation Heat
// Transfer", appendix C.
#include "RadiosityScenes.h"

#include <glm/gtc/constants.hpp>
#include <gtest/gtest.h>

#include <cstdio>

using namespace penumbra::radiosity;
using namespace penumbra_test;

namespace
{
constexpr double Pi = glm::pi<double>();

/// Elements of a mesh in groups by their surface, and the factors between them.
struct Exchange
{
  PatchMesh Mesh;
  std::vector<Element> Elements;
  Factors Traced;

  void Trace(double size, int rays)
  {
    Cut(this->Mesh, size);
    this->Elements = MakeElements(this->Mesh);
    const PatchRays world(this->Elements);
    this->Traced = TraceFactors(this->Elements, world, rays);
  }
  std::uint32_t SurfaceOf(std::size_t element) const
  {
    return this->Mesh.Faces()[element / 2].Surface;
  }
  double Area(std::uint32_t surface) const
  {
    double area = 0.0;
    for (const Face& face : this->Mesh.Faces())
    {
      area += face.Surface == surface ? this->Mesh.Area(face) : 0.0;
    }
    return area;
  }
  /// From the fronts of one surface to another.
  double Factor(std::uint32_t from, std::uint32_t to) const
  {
    double power = 0.0;
    for (std::size_t i = 0; i < this->Elements.size(); i += 2)
    {
      if (this->SurfaceOf(i) == from)
      {
        this->Traced.Matrix.ForEachIn(i, [&](std::size_t j, double factor) {
          power += this->SurfaceOf(j) == to ? factor * this->Elements[i].Area : 0.0;
        });
      }
    }
    return power / this->Area(from);
  }
};

/// Both ways within 0.1 % and, made reciprocal, within 0.05 %.
void Expect(const char* name, Exchange& exchange, double expected)
{
  const double there = exchange.Factor(0, 1);
  const double back = exchange.Factor(1, 0);
  MakeReciprocal(exchange.Traced.Matrix, exchange.Elements, exchange.Traced.Escaped);
  const double both = exchange.Factor(0, 1);
  std::printf("%s: %.6f; traced %.6f (%+.3f %%), back %.6f (%+.3f %%), combined %.6f (%+.3f %%)\n",
    name, expected, there, 100.0 * (there / expected - 1.0), back, 100.0 * (back / expected - 1.0),
    both, 100.0 * (both / expected - 1.0));
  EXPECT_NEAR(there / expected, 1.0, 0.001) << name;
  EXPECT_NEAR(back / expected, 1.0, 0.001) << name;
  EXPECT_NEAR(both / expected, 1.0, 0.0005) << name;
}

const double Parallel = 2.0 / Pi *
  (std::log(std::sqrt(4.0 / 3.0)) + 2.0 * std::sqrt(2.0) * std::atan(1.0 / std::sqrt(2.0)) -
    0.5 * Pi);

double Away(double sum)
{
  return std::abs(sum - 1.0);
}
}

TEST(FormFactors, UnitSquaresParallelAtDistance1)
{
  Exchange e;
  AddQuad(e.Mesh, { { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } } },
    AddMatte(e.Mesh, Color(0.5)));
  AddQuad(e.Mesh, { { { 0, 0, 1 }, { 0, 1, 1 }, { 1, 1, 1 }, { 1, 0, 1 } } },
    AddMatte(e.Mesh, Color(0.5)));
  e.Trace(0.15, 4096);
  Expect("parallel unit squares", e, Parallel);
}

TEST(FormFactors, UnitSquaresPerpendicularSharingAnEdge)
{
  Exchange e;
  AddQuad(e.Mesh, { { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } } },
    AddMatte(e.Mesh, Color(0.5)));
  AddQuad(e.Mesh, { { { 0, 0, 0 }, { 0, 1, 0 }, { 0, 1, 1 }, { 0, 0, 1 } } },
    AddMatte(e.Mesh, Color(0.5)));
  e.Trace(0.15, 4096);
  Expect("perpendicular unit squares", e, (1.0 - Parallel) / 4.0);
}

TEST(FormFactors, CoaxialDiscs)
{
  Exchange e;
  AddDisc(e.Mesh, 1.0, 0.0, true, AddMatte(e.Mesh, Color(0.5)));
  AddDisc(e.Mesh, 1.0, 1.0, false, AddMatte(e.Mesh, Color(0.5)));
  e.Trace(0.3, 1024);
  Expect("coaxial discs, r = h = 1", e, 0.5 * (3.0 - std::sqrt(5.0)));
}

TEST(FormFactors, SmallAreaUnderAUnitSquare)
{
  const double a = 0.5 / std::sqrt(1.25);
  const double expected = 4.0 / (2.0 * Pi) * 2.0 * a * std::atan(a);
  const Point origin(0.0);
  const Point up(0.0, 0.0, 1.0);
  const double exact =
    PointFactor(origin, up, { { { -0.5, -0.5, 1 }, { -0.5, 0.5, 1 }, { 0.5, 0.5, 1 } } }) +
    PointFactor(origin, up, { { { -0.5, -0.5, 1 }, { 0.5, 0.5, 1 }, { 0.5, -0.5, 1 } } });
  Exchange e;
  constexpr double h = 0.001;
  AddQuad(e.Mesh, { { { -h, -h, 0 }, { h, -h, 0 }, { h, h, 0 }, { -h, h, 0 } } },
    AddMatte(e.Mesh, Color(0.5)));
  AddQuad(e.Mesh, { { { -0.5, -0.5, 1 }, { -0.5, 0.5, 1 }, { 0.5, 0.5, 1 }, { 0.5, -0.5, 1 } } },
    AddMatte(e.Mesh, Color(0.5)));
  e.Trace(10.0, 90000);
  const double traced = e.Factor(0, 1);
  std::printf("small area under a unit square: %.6f; traced %.6f (%+.3f %%), analytic part of the "
              "solver %.6f\n",
    expected, traced, 100.0 * (traced / expected - 1.0), exact);
  EXPECT_NEAR(traced / expected, 1.0, 0.00015);
  EXPECT_NEAR(exact, expected, 1e-9);
}

TEST(FormFactors, BelowTheHorizonNothingIsSeen)
{
  const Point origin(0.0);
  // A vertical wall from -1 to 1 shows the half of it that is above.
  const std::array<Point, 3> whole = { { { 1, -1, -1 }, { 1, 1, -1 }, { 1, 0, 1 } } };
  const std::array<Point, 3> above = { { { 1, -0.5, 0 }, { 1, 0.5, 0 }, { 1, 0, 1 } } };
  EXPECT_NEAR(
    PointFactor(origin, { 0, 0, 1 }, whole), PointFactor(origin, { 0, 0, 1 }, above), 1e-12);
  EXPECT_EQ(PointFactor(origin, { -1, 0, 0 }, whole), 0.0);
}

TEST(FormFactors, RowsOfAClosedSceneSumTo1AndAreReciprocal)
{
  Exchange e;
  const std::uint32_t room = AddMatte(e.Mesh, Color(0.5));
  const std::uint32_t block = AddMatte(e.Mesh, Color(0.5));
  AddBox(e.Mesh, Point(-1.0), Point(1.0), room, true);
  AddBox(e.Mesh, { -0.5, -0.6, -0.9 }, { 0.3, 0.2, 0.4 }, block, false);
  e.Trace(0.25, 1024);
  const double there = e.Area(room) * e.Factor(room, block);
  const double back = e.Area(block) * e.Factor(block, room);
  double worst = 0.0;
  const auto check = [&] {
    worst = 0.0;
    for (std::size_t i = 0; i < e.Elements.size(); ++i)
    {
      // The back of the room sees nothing, the back of the block itself.
      const double sum = e.Traced.Matrix.RowSum(i);
      const bool outside = e.SurfaceOf(i) == room && i % 2 == 1;
      worst = std::max(worst, outside ? std::abs(sum) : Away(sum));
    }
    return worst;
  };
  const double traced = check();
  MakeReciprocal(e.Traced.Matrix, e.Elements, e.Traced.Escaped);
  const double balanced = check();
  const FactorMatrix other = Transpose(e.Traced.Matrix);
  double apart = 0.0;
  for (std::size_t i = 0; i < other.Size(); ++i)
  {
    for (std::size_t k = other.Begin[i]; k < other.Begin[i + 1]; ++k)
    {
      const auto& a = e.Traced.Matrix.Entries[k];
      const auto& b = other.Entries[k];
      ASSERT_EQ(a.Column, b.Column);
      const double one = e.Elements[i].Area * a.Value;
      const double two = e.Elements[a.Column].Area * b.Value;
      apart = std::max(apart, std::abs(one / two - 1.0));
    }
  }
  std::printf(
    "closed scene: rows sum to 1 within %.2e as traced, %.2e combined; A F there %.5f, back "
    "%.5f (%+.3f %%) as traced, every pair within %.2e combined\n",
    traced, balanced, there, back, 100.0 * (back / there - 1.0), apart);
  EXPECT_LT(traced, 1.5e-5);
  EXPECT_LT(balanced, 1.5e-5);
  EXPECT_NEAR(back / there, 1.0, 0.001);
  EXPECT_LT(apart, 3e-7);
}

TEST(FormFactors, ACulledSideLetsLightPass)
{
  Exchange e;
  const std::uint32_t floor = AddMatte(e.Mesh, Color(0.5));
  const std::uint32_t lid = AddMatte(e.Mesh, Color(0.5));
  Surface oneSided;
  oneSided.Sides[1].Present = false;
  const std::uint32_t between = e.Mesh.AddSurface(oneSided);
  AddQuad(e.Mesh, { { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } } }, floor);
  AddQuad(e.Mesh, { { { 0, 0, 1 }, { 0, 1, 1 }, { 1, 1, 1 }, { 1, 0, 1 } } }, lid);
  // Its front looks up, to the lid.
  AddQuad(e.Mesh, { { { -9, -9, 0.5 }, { 9, -9, 0.5 }, { 9, 9, 0.5 }, { -9, 9, 0.5 } } }, between);
  e.Trace(30.0, 40000);
  std::printf("through the side that is not there: %.4f of %.4f; onto the other: %.4f\n",
    e.Factor(floor, lid), Parallel, e.Factor(lid, floor));
  EXPECT_NEAR(e.Factor(floor, lid) / Parallel, 1.0, 0.01);
  EXPECT_EQ(e.Factor(lid, floor), 0.0);
}
