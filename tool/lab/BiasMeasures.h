// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// How far the mask of a shadow map is from the true one: acne, and light that leaks in at edges.
#ifndef penumbra_tool_BiasMeasures_h
#define penumbra_tool_BiasMeasures_h

#include <array>
#include <cstddef>
#include <vector>

namespace penumbra::tool
{
/// One light in one view, pixel by pixel, first row at the top.
struct LitView
{
  using Vector = std::array<double, 3>;

  int Width = 0;
  int Height = 0;
  std::vector<unsigned char> Surface;  ///< 1 where there is any
  std::vector<unsigned char> Receiver; ///< 1 where it is turned to the light
  std::vector<float> Light;   ///< how bright the light makes it, 0 to 1: errors weigh as much
  std::vector<float> Truth;   ///< share of the light that arrives, 0 or 1, by rays
  std::vector<Vector> Place;  ///< world coordinates; read where Surface is 1
  std::vector<Vector> Across; ///< place across the light, in texels of its map

  std::size_t PixelCount() const { return std::size_t(this->Width) * this->Height; }
};

/// A length in both units: across the light in texels, and along the surface in world units.
struct EdgeGap
{
  double Texels = 0;
  double World = 0;
};

/// Width of a pixel in texels, the median over neighbouring receivers; 0 without any.
double MedianPixelWidth(const LitView& view);

struct BiasErrors
{
  /// Share of the light on what is truly lit that the map takes, edges left out.
  double Acne = 0;
  /// Share of the light on what is truly dark that the map lets through, edges left out.
  double Leak = 0;
  /// Peter-panning: how far from where a thing stands on a surface its shadow begins; 95th percentile
  /// over the points of contact, each as important as the light there is bright.
  EdgeGap Contact;
  /// How far within a shadow's true outline it begins; the same over the outlines' points.
  EdgeGap Outline;

  /// The greater of the two, in texels.
  double Gap() const
  {
    return this->Contact.Texels > this->Outline.Texels ? this->Contact.Texels
                                                       : this->Outline.Texels;
  }
};

/// Finds the true shadow's edges once, then measures any number of masks against it.
class BiasJudge
{
public:
  /// Nearer to an edge than this, in texels, a map of squares cannot be right; a filter adds its radius.
  static constexpr double EdgeBand = 1.5;

  /// unbiased: the mask without any bias; what it lights of the true shadow, no map of its resolution
  /// shows, and counts for nothing. band: what is nearer to an edge, in texels, or touches it in the
  /// picture, counts neither as acne nor as a leak.
  BiasJudge(LitView view, const std::vector<float>& unbiased, double band);

  /// mask: share of the light that arrives by the map. Only receivers are read.
  BiasErrors Measure(const std::vector<float>& mask) const;

  const LitView& View() const { return this->Seen; }
  /// The light that a mask wrongly takes from a pixel (positive: acne) or gives to it (negative: a
  /// leak); 0 near edges, and where there is no receiver.
  double Error(const std::vector<float>& mask, std::size_t pixel) const;
  /// Lit pixels that count, truly dark pixels that count, and points of either kind of edge.
  std::size_t LitPixels() const { return this->Lit; }
  std::size_t DarkPixels() const { return this->Dark; }
  /// Share of the true shadow's pixels that no map of this resolution shows.
  double Lost() const { return this->LostShare; }
  std::size_t ContactPoints() const { return this->Contacts; }
  std::size_t OutlinePoints() const { return this->Edges.size() - this->Contacts; }

private:
  struct Edge
  {
    LitView::Vector Place;
    LitView::Vector Across;
    std::size_t DarkPixel; ///< next to it
    bool Contact;
  };
  class Leaks;

  bool IsDark(std::size_t pixel) const { return this->Shadow[pixel] != 0; }
  void FindShadow(const std::vector<float>& unbiased);
  void FindEdges(std::vector<std::size_t>& bordering);
  void LeaveOutEdges(const std::vector<std::size_t>& bordering, double band);

  LitView Seen;
  std::vector<Edge> Edges;
  std::vector<unsigned char> Shadow; ///< truly dark receivers that a map of this resolution shows
  std::vector<unsigned char> Counts; ///< receivers away from edges
  std::size_t Lit = 0;
  std::size_t Dark = 0;
  double LightOnLit = 0; ///< sums
  double LightOnDark = 0;
  std::size_t Contacts = 0;
  double LostShare = 0;
};
}

#endif
