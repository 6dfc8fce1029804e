// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

namespace loopmend {

namespace {

constexpr double width = 760, height = 420, left = 76, right = 130, top = 44, bottom = 56;
/// Okabe and Ito's colours: distinct for every kind of colour vision.
constexpr std::array<const char*, 6> colors{"#D55E00", "#0072B2", "#009E73", "#111111", "#CC79A7", "#E69F00"};

std::string number(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", std::abs(x) < 1e-12 ? 0.0 : x);
  return text;
}

std::string fixed(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f", x);
  return text;
}

/// Distance between ticks so that there are about five.
double tick_step(double span) {
  const double raw = span / 5, power = std::pow(10, std::floor(std::log10(raw)));
  for (double factor : {1.0, 2.0, 5.0})
    if (raw <= factor * power) return factor * power;
  return 10 * power;
}

struct Range {
  double low = std::numeric_limits<double>::max(), high = std::numeric_limits<double>::lowest();
  void take(double x) {
    if (!std::isfinite(x)) return;
    low = std::min(low, x);
    high = std::max(high, x);
  }
  void widen(double share) {
    if (low > high) low = 0, high = 1;
    const double margin = high > low ? share * (high - low) : 1;
    low -= margin;
    high += margin;
  }
  double span() const { return high - low; }
};

std::string text_at(double x, double y, const std::string& anchor, const std::string& words, const char* more = "") {
  return std::string("<text x='") + fixed(x) + "' y='" + fixed(y) + "' text-anchor='" + anchor + "' " + more + ">" +
         words + "</text>\n";
}

std::string line_between(double x1, double y1, double x2, double y2, const char* look) {
  return std::string("<line x1='") + fixed(x1) + "' y1='" + fixed(y1) + "' x2='" + fixed(x2) + "' y2='" + fixed(y2) +
         "' " + look + "/>\n";
}

}  // namespace

std::string to_svg(const LinePlot& plot) {
  Range xs, ys;
  for (const PlotLine& line : plot.lines)
    for (const auto& [x, y] : line.points) xs.take(x), ys.take(y);
  xs.widen(0);
  ys.widen(0.08);
  if (plot.y_limits.first < plot.y_limits.second) {
    ys.low = plot.y_limits.first;
    ys.high = plot.y_limits.second;
  }
  const double w = width - left - right, h = height - top - bottom;
  const auto px = [&](double x) { return left + w * (x - xs.low) / xs.span(); };
  const auto py = [&](double y) { return top + h * (ys.high - std::clamp(y, ys.low, ys.high)) / ys.span(); };
  std::string svg =
      "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 760 420' width='760' height='420' "
      "font-family='sans-serif' font-size='13' fill='#222'>\n"
      "<rect width='760' height='420' fill='white'/>\n";
  svg += text_at(left, 26, "start", plot.title, "font-weight='bold' font-size='15'");
  const double dx = tick_step(xs.span()), dy = tick_step(ys.span());
  for (double x = std::ceil(xs.low / dx) * dx; x <= xs.high + 1e-9 * dx; x += dx)
    svg += line_between(px(x), top, px(x), top + h, "stroke='#e4e4e4'") +
           text_at(px(x), top + h + 20, "middle", number(x));
  for (double y = std::ceil(ys.low / dy) * dy; y <= ys.high + 1e-9 * dy; y += dy)
    svg +=
        line_between(left, py(y), left + w, py(y), "stroke='#e4e4e4'") + text_at(left - 8, py(y) + 4, "end", number(y));
  if (xs.low < 0 && xs.high > 0)
    svg += line_between(px(0), top, px(0), top + h, "stroke='#888' stroke-dasharray='5 4'");
  svg += text_at(left + w / 2, height - 12, "middle", plot.x_label);
  svg += text_at(16, top + h / 2, "middle", plot.y_label,
                 (std::string("transform='rotate(-90 16 ") + fixed(top + h / 2) + ")'").c_str());
  for (std::size_t k = 0; k < plot.lines.size(); ++k) {
    const std::string color = colors[k % colors.size()];
    std::string path;
    bool open = false;
    for (const auto& [x, y] : plot.lines[k].points) {
      if (!std::isfinite(x) || !std::isfinite(y)) {
        open = false;
        continue;
      }
      path += std::string(open ? "L" : "M") + fixed(px(x)) + " " + fixed(py(y)) + " ";
      open = true;
    }
    svg += std::string("<path d='") + path + "' fill='none' stroke-width='2' stroke='" + color + "'/>\n";
    const double y = top + 14 + 22 * static_cast<double>(k);
    svg += line_between(left + w + 12, y - 4, left + w + 34, y - 4,
                        (std::string("stroke-width='3' stroke='") + color + "'").c_str());
    svg += text_at(left + w + 40, y, "start", plot.lines[k].name);
  }
  return svg + "</svg>\n";
}

}  // namespace loopmend
