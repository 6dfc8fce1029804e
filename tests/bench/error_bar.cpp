// SPDX-License-Identifier: GPL-3.0-or-later
// loopmend_error_bar: fits the calibration of ExpectedDeviation to the holes of one run of loopmend_cut_models, and tests it on
// those of another.
#include "table.h"

#include "core/error.h"
#include "core/quantile.h"
#include "pipeline/expected_deviation.h"

#include <CLI/CLI.hpp>
#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <map>
#include <numeric>
#include <sstream>

namespace {

using namespace loopmend;
using namespace loopmend::bench;

struct Hole {
  std::string model;
  double distance = 0;  ///< of the new vertices from what was there, rms, loop diameters
  DeviationPredictors predictors;
};

/// Rows of `auto` whose error bar is known. @throws InvalidArgument where the file cannot be read or has none.
std::vector<Hole> read_holes(const std::string& path) {
  std::ifstream in(path);
  std::vector<Hole> holes;
  std::map<std::string, std::size_t> column;
  for (std::string line; std::getline(in, line);) {
    std::vector<std::string> cells;
    std::istringstream row(line);
    for (std::string cell; std::getline(row, cell, ',');) cells.push_back(cell);
    if (column.empty()) {
      for (std::size_t k = 0; k < cells.size(); ++k) column[cells[k]] = k;
      continue;
    }
    const auto number = [&](const char* name) {
      const std::size_t k = column.at(name);
      return k < cells.size() ? std::strtod(cells[k].c_str(), nullptr) : 0;
    };
    if (cells[column.at("method")] != "auto" || !(number("seam_deg") > 0)) continue;
    holes.push_back({cells[column.at("model")],
                     number("d_vertices") / 1000,
                     {number("second_order"), number("area"), number("seam_deg"), number("initial_seam_deg")}});
  }
  if (holes.empty()) throw InvalidArgument(verbatim("no hole with an error bar in " + path));
  return holes;
}

double logarithm(double value) { return std::log(std::max(value, 1e-5)); }

/// The constants of engine/pipeline/expected_deviation.cpp.
void fit(const std::vector<Hole>& holes) {
  const auto n = static_cast<Eigen::Index>(holes.size());
  constexpr auto columns = static_cast<Eigen::Index>(std::tuple_size_v<decltype(regressors({}))>);
  Eigen::Matrix<double, Eigen::Dynamic, columns> X(n, columns);
  Eigen::VectorXd y(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const std::array row = regressors(holes[i].predictors);
    X.row(i) = Eigen::Map<const Eigen::Matrix<double, 1, columns>>(row.data());
    y[i] = logarithm(holes[i].distance);
  }
  const Eigen::Vector<double, columns> coefficients = X.colPivHouseholderQr().solve(y);
  const Eigen::VectorXd left = y - X * coefficients;
  const std::vector<double> residuals(left.begin(), left.end());
  std::printf("coefficients");
  for (double coefficient : coefficients) std::printf(" %.3f", coefficient);
  std::printf("; quantiles of the residual: 50 %% %.3f, 80 %% %.3f, 90 %% %.3f\n", quantile(residuals, 0.5),
              quantile(residuals, 0.8), quantile(residuals, 0.9));
}

std::vector<double> ranks(const std::vector<double>& values) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return values[i] < values[j]; });
  std::vector<double> rank(values.size());
  for (std::size_t k = 0; k < order.size(); ++k) rank[order[k]] = static_cast<double>(k);
  return rank;
}

double rank_correlation(const std::vector<double>& x, const std::vector<double>& y) {
  const std::vector<double> a = ranks(x), b = ranks(y);
  const double middle = (static_cast<double>(a.size()) - 1) / 2;
  double ab = 0, aa = 0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    ab += (a[k] - middle) * (b[k] - middle);
    aa += (a[k] - middle) * (a[k] - middle);
  }
  return ab / aa;
}

/// How often the engine's bounds hold.
std::vector<std::string> coverage(const std::string& name, const std::vector<const Hole*>& holes) {
  int half = 0, likely = 0, most = 0, near = 0;
  std::vector<double> bounds, distances;
  for (const Hole* hole : holes) {
    const ExpectedDeviation bar = expected_deviation(hole->predictors);
    half += hole->distance <= bar.half;
    likely += hole->distance <= bar.likely;
    most += hole->distance <= bar.most;
    near += std::abs(std::log(hole->distance / bar.half)) <= std::log(2);
    bounds.push_back(bar.half);
    distances.push_back(hole->distance);
  }
  const auto percent = [&](int count) { return number(100.0 * count / static_cast<double>(holes.size())); };
  return {name,          number(static_cast<int>(holes.size())),     percent(half), percent(likely), percent(most),
          percent(near), number(rank_correlation(bounds, distances))};
}

std::string tables(const std::vector<Hole>& holes) {
  const std::vector<std::string> head{
      "holes", "number", "within the 50 % bound", "80 %", "90 %", "within a factor of 2", "rank correlation"};
  Table table(head);
  std::map<std::string, std::vector<const Hole*>> by_model;
  std::vector<const Hole*> all;
  for (const Hole& hole : holes) {
    all.push_back(&hole);
    by_model[hole.model].push_back(&hole);
  }
  table.add(coverage("all", all));
  for (const auto& [model, chosen] : by_model) table.add(coverage(model, chosen));
  return table.markdown();
}

}  // namespace

int main(int argc, char** argv) try {
  std::string tuning, test, markdown;
  CLI::App app("The calibration of the error bar", "loopmend_error_bar");
  app.add_option("tuning", tuning, "CSV of loopmend_cut_models to fit")->required();
  app.add_option("test", test, "CSV of another run, on which the engine's bounds are tested");
  app.add_option("--markdown", markdown, "Write the table of the test to this file");
  CLI11_PARSE(app, argc, argv);
  const std::vector<Hole> fitted = read_holes(tuning);
  std::printf("%zu holes to fit: ", fitted.size());
  fit(fitted);
  std::printf("\nThe engine's bounds on these:\n\n%s", tables(fitted).c_str());
  if (test.empty()) return 0;
  const std::string text = tables(read_holes(test));
  std::printf("\nThe engine's bounds on %s:\n\n%s", test.c_str(), text.c_str());
  write_text(markdown, text);
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "loopmend_error_bar: %s\n", error.what());
  return 1;
}
