// SPDX-License-Identifier: GPL-3.0-or-later
#include "vertex_selection.h"

#include "cli/commands.h"

#include "analysis/curvature_field.h"
#include "io/text_cursor.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <fstream>
#include <optional>
#include <sstream>

namespace loopmend {

namespace {

struct Condition {
  std::string name, op;
  double limit = 0;
};

Condition parse(const std::string& words) {
  Condition condition;
  std::string text = words;
  text.erase(std::remove_if(text.begin(), text.end(), [](unsigned char c) { return std::isspace(c); }), text.end());
  const std::size_t at = text.find_first_of("<>");
  const UsageError wrong("--where takes conditions such as z>0.725 or x>0,H<-0.5 over x, y, z, H and K, not '" + words +
                         "'");
  if (at == std::string::npos) throw wrong;
  condition.name = text.substr(0, at);
  condition.op = text.substr(at, at + 1 < text.size() && text[at + 1] == '=' ? 2 : 1);
  const std::string number = text.substr(at + condition.op.size());
  const std::optional<double> limit = parse_double(number);
  const bool known = condition.name == "x" || condition.name == "y" || condition.name == "z" || condition.name == "H" ||
                     condition.name == "K";
  if (!known || !limit) throw wrong;
  condition.limit = *limit;
  return condition;
}

bool holds(double value, const Condition& condition) {
  if (condition.op == "<") return value < condition.limit;
  if (condition.op == "<=") return value <= condition.limit;
  if (condition.op == ">") return value > condition.limit;
  return value >= condition.limit;
}

/// The value that a condition speaks of, at each view vertex.
std::vector<double> values_of(const SurfaceModel& model, const std::string& name) {
  if (name == "H") return curvature_field(model.mesh).H;
  if (name == "K") return curvature_field(model.mesh).K;
  std::vector<double> values;
  for (const auto v : model.mesh.vertices()) values.push_back(model.mesh.point(v)[name[0] - 'x']);
  return values;
}

}  // namespace

std::vector<int> read_vertex_numbers(const std::filesystem::path& path) {
  std::ifstream file(path);
  if (!file) throw ReadError(path, say("cannot be opened"), {}, say("Check the name."));
  std::vector<int> numbers;
  std::string line;
  for (int row = 1; std::getline(file, line); ++row) {
    line = line.substr(0, line.find('#'));
    std::replace_if(
        line.begin(), line.end(), [](unsigned char c) { return c == ',' || std::isspace(c); }, ' ');
    std::istringstream words(line);
    for (std::string word; words >> word;) {
      int value = 0;
      const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
      if (error != std::errc() || end != word.data() + word.size() || value < 0)
        throw ReadError(path, say("'%1' is no vertex number", word.substr(0, 40)), say("line %1", row),
                        say("Vertex numbers are whole and count from 0."));
      numbers.push_back(value);
    }
  }
  if (numbers.empty())
    throw ReadError(path, say("holds no vertex number"), {}, say("Write one or more, parted by blanks."));
  return numbers;
}

std::vector<int> vertices_where(const SurfaceModel& model, const std::string& condition) {
  std::vector<char> chosen(model.mesh.n_vertices(), 1);
  std::istringstream words(condition);
  for (std::string word; std::getline(words, word, ',');) {
    const Condition one = parse(word);
    const std::vector<double> values = values_of(model, one.name);
    for (std::size_t i = 0; i < values.size(); ++i) chosen[i] = chosen[i] && holds(values[i], one);
  }
  std::vector<int> points;
  for (std::size_t i = 0; i < chosen.size(); ++i)
    if (chosen[i]) points.push_back(model.soup_vertex[i]);
  if (points.empty()) throw UsageError("--where " + condition + ": no vertex is so");
  return points;
}

}  // namespace loopmend
