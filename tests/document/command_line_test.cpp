// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/command_line.h"

#include "document/sheet.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace loopmend::test {
namespace {

PatchStatePtr made_by(double density, std::vector<RunRecipe> runs) {
  auto state = state_at(runs.empty() ? PatchStatus::filled : PatchStatus::ready);
  state->recipe = {density, PatchRecipe::Start::holes, std::move(runs)};
  return state;
}

RunRecipe steady(FlowKind flow) {
  RunRecipe run;
  run.flow = flow;
  run.mode = EvolutionMode::steady;
  return run;
}

RunRecipe stepped(double sigma, int steps) {
  RunRecipe run;
  run.sigma = sigma;
  run.steps = steps;
  return run;
}

TEST(CommandLine, IsEmptyWithoutPatches) {
  SheetDocument document;
  EXPECT_TRUE(command_line(document, {}).text.isEmpty());
  EXPECT_TRUE(command_line(document, {17}).text.isEmpty()) << "no such patch";
}

TEST(CommandLine, NamesTheLoopsUnlessItIsAllHoles) {
  SheetDocument document;
  const int first = add_patch(document, {diamond}, made_by(1, {}));
  EXPECT_EQ(command_line(document, {first}).text,
            QStringLiteral("loopmend fill /scans/sheet.ply -o /scans/sheet-filled.ply --loops 3 --flow none"));
  const int second = add_patch(document, {square}, made_by(1, {}));
  EXPECT_EQ(command_line(document, {first, second}).text,
            QStringLiteral("loopmend fill /scans/sheet.ply -o /scans/sheet-filled.ply --flow none"));
}

TEST(CommandLine, NamesFlowStepsAndDensity) {
  SheetDocument document;
  const auto options_of = [&](const PatchStatePtr& state) {
    const int id = add_patch(document, {square}, state);
    const CommandLine line = command_line(document, {id});
    document.replace({id}, {});
    EXPECT_TRUE(line.remarks.isEmpty());
    return line.text.mid(line.text.indexOf(QStringLiteral("--loops 2")) + 10);
  };
  EXPECT_EQ(options_of(made_by(1, {steady(FlowKind::mmcvf)})), QStringLiteral("--flow mmcvf"));
  EXPECT_EQ(options_of(made_by(1.5, {steady(FlowKind::wf)})), QStringLiteral("--density 1.5 --flow wf"));
  EXPECT_EQ(options_of(made_by(1, {stepped(0.1, 3)})),
            QStringLiteral("--flow mmcvf --mode steps --sigma 0.1 --steps 3"));
  RunRecipe robust = steady(FlowKind::mmcvf);
  robust.boundary = BoundaryTrust::robust;
  robust.end = RunRecipe::End::after_steps;
  robust.steps = 2;
  EXPECT_EQ(options_of(made_by(1, {robust})), QStringLiteral("--flow mmcvf --boundary robust --steps 2"));
}

/// Numbers of loops change when others are filled, so the second command names a vertex that is on its loop alone.
TEST(CommandLine, DifferentRecipesAreFilledOneAfterTheOther) {
  SheetDocument document;
  const int first = add_patch(document, {square}, made_by(1, {steady(FlowKind::mmcvf)}));
  const int second = add_patch(document, {diamond}, made_by(1, {}));
  const QStringList lines = command_line(document, {first, second}).text.split(QLatin1Char('\n'));
  ASSERT_EQ(lines.size(), 2);
  EXPECT_EQ(lines[0],
            QStringLiteral("loopmend fill /scans/sheet.ply -o /scans/sheet-filled-1.ply --loops 2 --flow mmcvf"));
  const QString head =
      QStringLiteral("loopmend fill /scans/sheet-filled-1.ply -o /scans/sheet-filled.ply --at-vertex ");
  ASSERT_TRUE(lines[1].startsWith(head)) << lines[1].toStdString();
  const int vertex = lines[1].mid(head.size()).section(QLatin1Char(' '), 0, 0).toInt();
  const auto& on_loop = document.loop(diamond).vertices;
  const auto& soup_vertex = document.scan(0)->model->soup_vertex;
  EXPECT_TRUE(std::any_of(on_loop.begin(), on_loop.end(), [&](int v) { return soup_vertex[v] == vertex; }));
  EXPECT_TRUE(lines[1].endsWith(QStringLiteral(" --flow none")));
}

/// One command names the shape of each loop; where other options differ, each shape is a step of its own.
TEST(CommandLine, NamesTheShapeOfEachLoop) {
  SheetDocument document;
  RunRecipe flat = steady(FlowKind::mmcvf);
  flat.continuity = SeamContinuity::position;
  const int first = add_patch(document, {square}, made_by(1, {flat}));
  const QString head = QStringLiteral("loopmend fill /scans/sheet.ply -o /scans/sheet-filled.ply");
  EXPECT_EQ(command_line(document, {first}).text, head + QStringLiteral(" --loops 2:flat --flow mmcvf"));
  const int smooth = add_patch(document, {diamond}, made_by(1, {steady(FlowKind::mmcvf)}));
  EXPECT_EQ(command_line(document, {first, smooth}).text, head + QStringLiteral(" --loops 2:flat,3 --flow mmcvf"));
  document.replace({smooth}, {});
  const int also_flat = add_patch(document, {diamond}, made_by(1, {flat}));
  EXPECT_EQ(command_line(document, {first, also_flat}).text,
            head + QStringLiteral(" --continuity position --flow mmcvf"));
  document.replace({also_flat}, {});
  const int dense = add_patch(document, {diamond}, made_by(2, {flat}));
  const QStringList lines = command_line(document, {first, dense}).text.split(QLatin1Char('\n'));
  ASSERT_EQ(lines.size(), 2);
  for (const QString& line : lines) EXPECT_TRUE(line.contains(QStringLiteral("--continuity position")));
}

TEST(CommandLine, MakesTheSampleFirst) {
  Document document;
  document.add_scan(scan_from({}, ScanOrigin::sample));
  const int id = add_patch(document, {square, diamond}, made_by(1, {}));
  EXPECT_EQ(command_line(document, {id}).text,
            QStringLiteral("loopmend sample -o sample.ply\nloopmend fill sample.ply -o sample-filled.ply --flow none"));
}

TEST(CommandLine, SaysWhatItDoesNotRepeat) {
  SheetDocument document;
  const int twice = add_patch(document, {square}, made_by(1, {stepped(10, 2), stepped(1, 5)}));
  const CommandLine line = command_line(document, {twice});
  ASSERT_EQ(line.remarks.size(), 1);
  EXPECT_TRUE(line.remarks[0].contains(QStringLiteral("several runs"))) << line.remarks[0].toStdString();
  EXPECT_TRUE(line.text.endsWith(QStringLiteral("--sigma 1 --steps 5"))) << "the last run";

  auto cutting = std::make_shared<PatchState>(*made_by(1, {}));
  cutting->status = PatchStatus::invalid;
  const int bad = add_patch(document, {diamond}, cutting);
  EXPECT_EQ(command_line(document, {bad}).remarks.size(), 1);

  Document made;
  made.add_scan(scan_from({}, ScanOrigin::made));
  EXPECT_EQ(command_line(made, {add_patch(made, {square}, made_by(1, {}))}).remarks.size(), 1)
      << "it is in no file yet";
}

}  // namespace
}  // namespace loopmend::test
