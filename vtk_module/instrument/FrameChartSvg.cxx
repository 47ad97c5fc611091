// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "instrument/FrameChartSvg.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace penumbra
{
namespace
{
std::string Escape(const std::string& text)
{
  std::string escaped;
  for (const char character : text)
  {
    switch (character)
    {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      default:
        // XML has no control characters.
        escaped += static_cast<unsigned char>(character) < 32 ? ' ' : character;
    }
  }
  return escaped;
}

/// Hundredths of a pixel, independent of the locale.
std::string Number(double number)
{
  const auto hundredths = std::llround(number * 100.0);
  const auto size = std::llabs(hundredths);
  std::string text = (hundredths < 0 ? "-" : "") + std::to_string(size / 100);
  if (const auto rest = size % 100)
  {
    text += rest < 10 ? ".0" : ".";
    text += std::to_string(rest % 10 ? rest : rest / 10);
  }
  return text;
}

std::string Attribute(const char* name, double number)
{
  return std::string(" ") + name + "=\"" + Number(number) + "\"";
}

std::string Paint(const char* name, const ChartColor& color)
{
  const auto byte = [](double value) {
    return static_cast<unsigned>(std::lround(255.0 * std::clamp(value, 0.0, 1.0)));
  };
  char text[16];
  std::snprintf(
    text, sizeof(text), "#%02x%02x%02x", byte(color.Red), byte(color.Green), byte(color.Blue));
  std::string attribute = std::string(" ") + name + "=\"" + text + "\"";
  if (color.Alpha < 1.0)
  {
    attribute += Attribute((std::string(name) + "-opacity").c_str(), color.Alpha);
  }
  return attribute;
}

std::string Element(const ChartShape& shape, double height)
{
  const ChartBox& box = shape.Box;
  // Of the usual fonts, as a share of the size.
  constexpr double descent = 0.25;
  const std::string tip = shape.Text.empty() ? "" : "<title>" + Escape(shape.Text) + "</title>";
  const auto close = [&tip](const char* name) {
    return tip.empty() ? std::string("/>\n") : ">" + tip + "</" + name + ">\n";
  };
  switch (shape.Kind)
  {
    case ChartKind::Rectangle:
      return "<rect" + Attribute("x", box.Left) + Attribute("y", height - box.Top) +
        Attribute("width", box.Width()) + Attribute("height", box.Height()) +
        Paint("fill", shape.Color) + close("rect");
    case ChartKind::Line:
      return "<line" + Attribute("x1", box.Left) + Attribute("y1", height - box.Bottom) +
        Attribute("x2", box.Right) + Attribute("y2", height - box.Top) +
        Paint("stroke", shape.Color) + Attribute("stroke-width", shape.Size) + close("line");
    case ChartKind::Disc:
      return "<circle" + Attribute("cx", 0.5 * (box.Left + box.Right)) +
        Attribute("cy", height - 0.5 * (box.Bottom + box.Top)) + Attribute("r", 0.5 * box.Width()) +
        Paint("fill", shape.Color) + close("circle");
    case ChartKind::Text:
      return "<text" + Attribute("x", box.Left) +
        Attribute("y", height - box.Bottom - descent * shape.Size) + Paint("fill", shape.Color) +
        Attribute("font-size", shape.Size) + ">" + Escape(shape.Text) + "</text>\n";
  }
  return "";
}
}

std::string FrameChartSvg(const std::vector<ChartShape>& shapes, int width, int height)
{
  const std::string w = std::to_string(width);
  const std::string h = std::to_string(height);
  std::string document = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + w + "\" height=\"" +
    h + "\" viewBox=\"0 0 " + w + " " + h + "\" font-family=\"Helvetica, Arial, sans-serif\">\n";
  for (const ChartShape& shape : shapes)
  {
    document += Element(shape, height);
  }
  return document + "</svg>\n";
}
}
