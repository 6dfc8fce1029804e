// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/problem_commands.h"

#include "document/shell_words.h"

#include <QClipboard>
#include <QCoreApplication>
#include <QGuiApplication>

#include <algorithm>

namespace loopmend {
namespace {

bool has_patches(const Document& document, int scan) {
  return std::any_of(document.patches().begin(), document.patches().end(),
                     [scan](const OpenPatch& patch) { return patch.scan == scan; });
}

/// Adds a scan's file, and what has to be done before there is one.
void add_input(ProblemWords& words, const Document& document, int index) {
  const OpenedScan& scan = *document.scan(index);
  const QString made = words.inputs.isEmpty() ? QStringLiteral("surface.ply")
                                              : QStringLiteral("surface-%1.ply").arg(words.inputs.size() + 1);
  const bool patched = has_patches(document, index);
  if (scan.from == ScanOrigin::sample && !patched) words.before << QStringLiteral("loopmend sample -o sample.ply");
  if (patched)
    words.remarks << QCoreApplication::translate(
                         "loopmend", "%1 has patches: export it by itself as %2 before you use the command.")
                         .arg(scan.name, made);
  else if (scan.from == ScanOrigin::made)
    words.remarks << QCoreApplication::translate(
                         "loopmend", "%1 was made in the window: export it by itself as %2 before you use the command.")
                         .arg(scan.name, made);
  words.inputs << (patched ? made : shell::file_of(scan, made));
}

/// A command that writes these numbers, and the file's name.
QString write_numbers(ProblemWords& words, const std::vector<int>& numbers, const char* ending) {
  constexpr std::size_t in_a_line = 16;
  const QString file = shell::beside(words.inputs.first(), QLatin1String(ending));
  QStringList lines;
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    if (k % in_a_line == 0) lines << QString();
    if (k % in_a_line != 0) lines.last() += QLatin1Char(' ');
    lines.last() += QString::number(numbers[k]);
  }
  words.before << shell::writing(file, lines);
  return shell::quoted(file);
}

QString density_words(double density) {
  return density == 1 ? QString() : QStringLiteral(" --density ") + shell::exact(density);
}

QString step_words(const EvolutionOptions& options) {
  return options.mode == EvolutionMode::steps ? QStringLiteral(" --mode steps --sigma ") + shell::exact(options.sigma)
                                              : QString();
}

CommandLine command(const ProblemWords& problem, const QString& verb, const QString& ending, const QString& options) {
  QStringList files;
  for (const QString& file : problem.inputs) files << shell::quoted(file);
  CommandLine result;
  result.remarks = problem.remarks;
  const QString output = shell::quoted(shell::beside(problem.inputs.first(), ending));
  QStringList lines = problem.before;
  lines << QStringLiteral("loopmend %1 ").arg(verb) + files.join(QLatin1Char(' ')) + QStringLiteral(" -o ") + output +
               problem.options + options;
  result.text = lines.join(QLatin1Char('\n'));
  return result;
}

}  // namespace

ProblemWords region_words(const Document& document, int scan, const std::vector<int>& vertices) {
  ProblemWords words;
  words.verb = QStringLiteral("evolve");
  words.ending = QStringLiteral("-fair.ply");
  add_input(words, document, scan);
  words.options = QStringLiteral(" --region ") + write_numbers(words, vertices, "-region.txt");
  return words;
}

ProblemWords points_words(const Document& document, int scan, const SubdivisionOptions& options) {
  ProblemWords words;
  words.verb = QStringLiteral("interpolate");
  words.ending = QStringLiteral("-smooth.ply");
  add_input(words, document, scan);
  words.options = QStringLiteral(" --subdivide ") + QString::number(options.subdivisions);
  if (!options.fixed.empty())
    words.options += QStringLiteral(" --fixed ") + write_numbers(words, options.fixed, "-fixed.txt");
  if (options.boundary == PolyhedronBoundary::smooth) words.options += QStringLiteral(" --open");
  return words;
}

ProblemWords blend_words(const Document& document, const std::vector<int>& loops, double density) {
  ProblemWords words;
  words.verb = QStringLiteral("blend");
  words.ending = QStringLiteral("-joined.ply");
  std::vector<int> scans;
  QStringList names;
  for (int loop : loops) {
    const int scan = document.scan_of(loop);
    auto at = std::find(scans.begin(), scans.end(), scan);
    if (at == scans.end()) {
      add_input(words, document, scan);
      if (has_patches(document, scan))
        words.remarks << QCoreApplication::translate(
            "loopmend", "Its boundary loops have other numbers then: 'loopmend info' prints them.");
      at = scans.insert(scans.end(), scan);
    }
    names << QStringLiteral("%1:%2").arg(at - scans.begin() + 1).arg(loop - document.first_loop_of(scan) + 1);
  }
  words.options = QStringLiteral(" --loops ") + names.join(QLatin1Char(',')) + density_words(density);
  return words;
}

ProblemWords holes_words(const Document& document, const std::set<int>& loops, double density) {
  ProblemWords words;
  const int scan = document.scan_of(*loops.begin());
  const OpenedScan& opened = *document.scan(scan);
  if (opened.from == ScanOrigin::sample) words.before << QStringLiteral("loopmend sample -o sample.ply");
  if (opened.from == ScanOrigin::made)
    words.remarks << QCoreApplication::translate(
                         "loopmend",
                         "%1 was made in the window: export it as surface.ply, without patches, before you use the "
                         "command.")
                         .arg(opened.name);
  words.inputs << shell::file_of(opened);
  words.options = density_words(density);
  for (int loop = document.first_loop_of(scan); loop < document.loop_count() && document.scan_of(loop) == scan; ++loop)
    if (loops.contains(loop) != (document.loop(loop).kind == LoopKind::hole)) {
      words.remarks << QCoreApplication::translate(
          "loopmend", "The command compares on all holes of the file, and on nothing else.");
      break;
    }
  return words;
}

CommandLine solving_command(const ProblemWords& problem, const EvolutionOptions& options) {
  return command(problem, problem.verb, problem.ending,
                 QStringLiteral(" --flow ") + shell::word(options.flow) + step_words(options) +
                     shell::boundary_options(options.boundary, options.continuity));
}

CommandLine comparing_command(const ProblemWords& problem, const EvolutionOptions& options,
                              const std::vector<FlowKind>& flows) {
  constexpr std::size_t all = 4;
  CommandLine result = command(problem, QStringLiteral("compare"), QStringLiteral("-flows"), step_words(options));
  if (flows.size() < all) result.remarks << QCoreApplication::translate("loopmend", "The command runs all four flows.");
  return result;
}

QString copy_to_clipboard(const CommandLine& command) {
  QGuiApplication::clipboard()->setText(command.text);
  return (QStringList(QCoreApplication::translate("loopmend", "The command line is in the clipboard.")) +
          command.remarks)
      .join(QLatin1Char(' '));
}

}  // namespace loopmend
