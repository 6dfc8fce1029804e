// SPDX-License-Identifier: GPL-3.0-or-later
// A line plot as SVG text, for reports that open in any browser.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace loopmend {

struct PlotLine {
  std::string name;
  std::vector<std::pair<double, double>> points;  ///< by rising x; points that are not finite break the line
};

/// Axes with round numbers, a vertical line at x = 0, a legend. Values beyond `y_limits` are cut off.
struct LinePlot {
  std::string title, x_label, y_label;
  std::vector<PlotLine> lines;
  std::pair<double, double> y_limits{0, 0};  ///< equal: from the values
};

std::string to_svg(const LinePlot& plot);

}  // namespace loopmend
