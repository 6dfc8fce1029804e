// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/session.h"

#include "analysis/curvature_field.h"
#include "core/error.h"
#include "document/sheet.h"
#include "filling/loop_patch.h"
#include "jobs/state_making.h"

#include <gtest/gtest.h>

#include <QDir>
#include <QFile>
#include <QTemporaryDir>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>

namespace loopmend::test {
namespace {

/// The square hole, filled, with a word or a number of its own in every field that a session keeps.
PatchStatePtr whole_state(const OpenedScan& scan) {
  const BoundaryLoop& loop = scan.loops[square];
  auto state = std::make_shared<PatchState>();
  state->patch = make_patch(*scan.model, {loop}, {*fill_loop(*scan.model, loop, {}, {}).patch});
  state->status = PatchStatus::faired;
  state->message = joined(say("a text of %1", 3), "; ", verbatim("an umlaut: \xc3\xa4")).with_code("code");
  RunRecipe run;
  run.flow = FlowKind::wf;
  run.mode = EvolutionMode::steady;
  run.sigma = 0.1;
  run.boundary = BoundaryTrust::robust;
  run.continuity = SeamContinuity::tangent;
  run.mirror = RunRecipe::Mirror::found;
  run.relief = {ReliefChoice::Kind::continued, 12};
  run.steps = 3;
  run.end = RunRecipe::End::after_steps;
  state->recipe = {1.25, PatchRecipe::Start::bridge, {run, RunRecipe{}}};
  state->patch.grading.density = 1.25;
  state->flow = FlowKind::sdf;
  state->steps = 4;
  state->last_step.step = 5;
  state->energy.final = 1.0 / 3;
  state->last_step.sigma = 6;
  state->last_step.tau = 7e-9;
  state->last_step.max_move = 8;
  state->energy.initial = 9;
  state->seconds.total = 10;
  SeamReport seam;
  seam.g1_rms_deg = 11;
  seam.g1_max_deg = 12;
  seam.h_jump_rms = 13;
  seam.h_jump_max = 14;
  seam.h_jump_rms_times_diameter = 15;
  state->seams = {seam};
  seam.g1_rms_deg = 16;
  state->seams_before = {seam};
  Verdict verdict;
  verdict.grade = Grade::look;
  verdict.findings = {{NoticeCode::crease, {50, 12}}};
  verdict.crease_deg = 51;
  verdict.height = 0.25;
  verdict.folds = 2;
  state->verdicts = {verdict};
  state->deviation.loops = {{0.1, 0.2, 0.3, 0.04}};
  for (int v = 0; v < state->patch.free_count; ++v) state->deviation.vertices.push_back(0.01 * v);
  BoundarySummary around;
  around.split.relief = 17;
  around.split.noise_height = 18;
  around.noise_per_edge = 19;
  around.gradient_sigma = 20;
  around.fitted = 21;
  state->neighborhood = {around};
  return state;
}

SessionView some_view() {
  SessionView view;
  view.from = {Vec3(1, 2, 3), Vec3(4, 5, 6), Vec3::UnitX()};
  view.look.shading = Shading::isophotes;
  view.look.edges = Edges::shown;
  view.look.seams = Seams::hidden;
  view.look.map = ColorMap::grey;
  view.look.H = {ColorRange::Rule::own, 60, 0.25};
  view.look.K.percent = 75;
  view.look.stripes = 12;
  view.look.up = UpAxis::minus_x;
  return view;
}

void expect_same(const PatchState& a, const PatchState& b) {
  EXPECT_EQ(a.deviation.vertices, b.deviation.vertices);
  EXPECT_EQ(a.patch.free_count, b.patch.free_count);
  EXPECT_EQ(a.patch.positions, b.patch.positions);
  EXPECT_EQ(a.patch.triangles, b.patch.triangles);
  EXPECT_EQ(a.patch.patch_triangles, b.patch.patch_triangles);
  EXPECT_EQ(a.patch.ring, b.patch.ring);
  EXPECT_EQ(a.patch.view_vertex, b.patch.view_vertex);
  EXPECT_EQ(a.patch.loops, b.patch.loops);
  EXPECT_EQ(a.patch.loop_numbers, b.patch.loop_numbers);
  EXPECT_EQ(a.patch.center, b.patch.center);
  EXPECT_EQ(a.patch.scale, b.patch.scale);
  EXPECT_EQ(a.patch.grading.density, b.patch.grading.density);
  EXPECT_EQ(a.status, b.status);
  EXPECT_EQ(a.message, b.message);
  EXPECT_EQ(a.recipe, b.recipe);
  EXPECT_EQ(a.flow, b.flow);
  EXPECT_EQ(a.steps, b.steps);
  EXPECT_EQ(a.last_step.step, b.last_step.step);
  EXPECT_EQ(a.energy.final, b.energy.final);
  EXPECT_EQ(a.last_step.sigma, b.last_step.sigma);
  EXPECT_EQ(a.last_step.tau, b.last_step.tau);
  EXPECT_EQ(a.last_step.max_move, b.last_step.max_move);
  EXPECT_EQ(a.energy.initial, b.energy.initial);
  EXPECT_EQ(a.seconds.total, b.seconds.total);
  EXPECT_EQ(a.seams, b.seams);
  EXPECT_EQ(a.seams_before, b.seams_before);
  EXPECT_EQ(a.verdicts, b.verdicts);
  ASSERT_EQ(a.neighborhood.size(), b.neighborhood.size());
  for (std::size_t k = 0; k < a.neighborhood.size(); ++k) {
    const BoundarySummary &of_a = a.neighborhood[k], &of_b = b.neighborhood[k];
    EXPECT_EQ(of_a.split.relief, of_b.split.relief);
    EXPECT_EQ(of_a.split.noise_height, of_b.split.noise_height);
    EXPECT_EQ(of_a.noise_per_edge, of_b.noise_per_edge);
    EXPECT_EQ(of_a.gradient_sigma, of_b.gradient_sigma);
    EXPECT_EQ(of_a.fitted, of_b.fitted);
  }
}

struct SessionTest : testing::Test {
  QString path(const char* name) const { return folder.filePath(QLatin1String(name)); }
  static QByteArray bytes_of(const QString& file) {
    QFile in(file);
    EXPECT_TRUE(in.open(QIODevice::ReadOnly));
    return in.readAll();
  }
  Session read(const QByteArray& bytes) const {
    QFile out(path("read.loopmend"));
    EXPECT_TRUE(out.open(QIODevice::WriteOnly));
    out.write(bytes);
    out.close();
    return session_from_file(path("read.loopmend"));
  }
  /// A scan in a file, a surface that was made, and a patch in each; that of the first has two other states: one of the same
  /// mesh, one of another.
  Session whole_session() {
    document.add_scan(scan_from(path("scan.ply")));
    document.add_scan(scan_from({}, ScanOrigin::made));
    add_patch(document, {square}, whole_state(*document.scan(0)), Acceptance::accepted);
    add_patch(document, {3 + square}, whole_state(*document.scan(1)));
    OpenPatch patch = document.patches().front();
    const auto moved = std::make_shared<PatchState>(*patch.state), other = std::make_shared<PatchState>(*patch.state);
    for (int v = 0; v < moved->patch.free_count; ++v) moved->patch.positions[v].z() += 0.125;
    moved->steps = 2;
    std::rotate(other->patch.triangles.begin(), other->patch.triangles.begin() + 1,
                other->patch.triangles.begin() + other->patch.patch_triangles);
    other->steps = 1;
    patch.timeline = std::make_shared<const Timeline>(Timeline{other, moved, patch.state});
    document.replace({patch.id}, {patch});
    Session session = session_of(document, some_view);
    std::sort(session.patches.begin(), session.patches.end(),
              [](const SessionPatch& a, const SessionPatch& b) { return a.scan < b.scan; });
    return session;
  }
  QTemporaryDir folder;
  Document document;
};

TEST_F(SessionTest, ComesBackWithEveryFieldAsItWas) {
  Session out = whole_session();
  out.scans[0].shapes = {{2, SeamContinuity::position}, {3, SeamContinuity::tangent}};
  write_session(out, path("all.loopmend"));
  const Session in = session_from_file(path("all.loopmend"));
  ASSERT_EQ(in.scans.size(), 2u);
  EXPECT_EQ(in.scans[0].path, path("scan.ply"));
  EXPECT_EQ(in.scans[0].fingerprint, document.scan(0)->fingerprint);
  EXPECT_EQ(in.scans[0].made, nullptr);
  EXPECT_EQ(in.scans[0].shapes, out.scans[0].shapes);
  EXPECT_EQ(in.scans[1].path, QString());
  EXPECT_EQ(in.scans[1].name, QStringLiteral("sheet"));
  ASSERT_NE(in.scans[1].made, nullptr);
  EXPECT_EQ(in.scans[1].made->points, document.scan(1)->model->soup.points);
  EXPECT_EQ(in.scans[1].made->triangles, document.scan(1)->model->soup.triangles);
  ASSERT_EQ(in.patches.size(), 2u);
  for (int i : {0, 1}) {
    EXPECT_EQ(in.patches[i].scan, i);
    EXPECT_EQ(in.patches[i].loop_numbers, std::vector<int>{2});
    EXPECT_EQ(in.patches[i].acceptance, i == 0 ? Acceptance::accepted : Acceptance::pending);
    expect_same(*in.patches[i].state, *out.patches[i].state);
  }
  ASSERT_EQ(in.patches[0].timeline.size(), 3u);
  for (std::size_t k : {0u, 1u, 2u}) expect_same(*in.patches[0].timeline[k], *out.patches[0].timeline[k]);
  EXPECT_EQ(in.patches[0].timeline[2], in.patches[0].state);
  EXPECT_TRUE(in.patches[1].timeline.empty());
  ASSERT_TRUE(in.view);
  EXPECT_EQ(in.view->from, some_view().from);
  EXPECT_EQ(in.view->look, some_view().look);
}

/// A hundred states within a bound: every second one goes until they fit; the first, the present and the last stay.
TEST_F(SessionTest, RecordedStatesStayWithinTheirBound) {
  whole_session();
  OpenPatch patch = document.patches().front();
  Timeline timeline;
  for (int k = 0; k < 100; ++k) {
    auto state = std::make_shared<PatchState>(*patch.state);
    state->steps = k;
    timeline.push_back(state);
  }
  patch.state = timeline[37];
  patch.timeline = std::make_shared<const Timeline>(timeline);
  document.replace({patch.id}, {patch});
  const auto kept = [&](std::size_t bound) {
    const Session session = session_of(document, {}, bound);
    const auto with = std::max_element(
        session.patches.begin(), session.patches.end(),
        [](const SessionPatch& a, const SessionPatch& b) { return a.timeline.size() < b.timeline.size(); });
    return *with;
  };
  EXPECT_EQ(kept(most_recorded).timeline.size(), 100u);
  const Session whole = session_of(document, {});
  const auto all = static_cast<std::size_t>(to_bytes(whole, folder.path()).size());
  const SessionPatch fewer = kept(all / 3);
  EXPECT_LT(fewer.timeline.size(), 60u);
  EXPECT_GT(fewer.timeline.size(), 10u);
  EXPECT_EQ(fewer.timeline.front(), timeline.front());
  EXPECT_EQ(fewer.timeline.back(), timeline.back());
  EXPECT_EQ(std::count(fewer.timeline.begin(), fewer.timeline.end(), timeline[37]), 1);
  EXPECT_TRUE(kept(0).timeline.empty());
}

/// A hundred states of a patch with a large neighborhood take little room in a file, and more in memory.
TEST_F(SessionTest, RecordedStatesThatDoNotBelongTogetherAreRefused) {
  const Session whole = whole_session();
  const auto refused = [&](const char* words, const Timeline& timeline) {
    Session session = whole;
    session.patches[0].timeline = timeline;
    try {
      read(to_bytes(session, folder.path()));
      ADD_FAILURE() << "was read: " << words;
    } catch (const ReadError& error) {
      EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    }
  };
  const Timeline& timeline = whole.patches[0].timeline;
  refused("not complete", {timeline[0], timeline[1]});
  refused("not complete", {timeline[2], timeline[2]});
  auto of_other_loops = std::make_shared<PatchState>(*timeline[0]);
  of_other_loops->patch.loop_numbers = {7};
  refused("not of the loops", {of_other_loops, timeline[2]});
  Timeline many(10001, timeline[1]);
  many.push_back(timeline[2]);
  refused("more recorded states", many);
}

TEST_F(SessionTest, IndicesSkipAScanThatWasTakenAway) {
  document.add_scan(scan_from(path("gone.ply")));
  document.add_scan(scan_from(path("stays.ply")));
  document.take_scan(0);
  add_patch(document, {3 + square}, whole_state(*document.scan(1)));
  const Session session = session_of(document, {});
  ASSERT_EQ(session.scans.size(), 1u);
  EXPECT_EQ(session.scans[0].path, path("stays.ply"));
  EXPECT_EQ(session.patches[0].scan, 0);
  EXPECT_FALSE(read(to_bytes(session, folder.path())).view);
}

TEST_F(SessionTest, FindsItsScanWhereBothHaveMoved) {
  QDir dir(folder.path());
  ASSERT_TRUE(dir.mkpath(QStringLiteral("old/scans")) && dir.mkpath(QStringLiteral("new/scans")));
  QFile scan(path("old/scans/a.ply"));
  ASSERT_TRUE(scan.open(QIODevice::WriteOnly));
  scan.close();
  document.add_scan(scan_from(scan.fileName()));
  write_session(session_of(document, {}), path("old/s.loopmend"));
  ASSERT_TRUE(QFile::rename(path("old/scans/a.ply"), path("new/scans/a.ply")));
  ASSERT_TRUE(QFile::rename(path("old/s.loopmend"), path("new/s.loopmend")));
  EXPECT_EQ(session_from_file(path("new/s.loopmend")).scans[0].path, path("new/scans/a.ply"));
  // Where it is nowhere, the message can name the place where it was.
  ASSERT_TRUE(QFile::remove(path("new/scans/a.ply")));
  EXPECT_EQ(session_from_file(path("new/s.loopmend")).scans[0].path, path("old/scans/a.ply"));
}

TEST_F(SessionTest, EveryFileThatEndsTooEarlyIsRefused) {
  const QByteArray bytes = to_bytes(whole_session(), folder.path());
  EXPECT_EQ(read(bytes).patches.size(), 2u);
  for (int size = 0; size < bytes.size(); size += size < 200 ? 1 : 37)
    EXPECT_THROW(read(bytes.left(size)), ReadError) << size;
  EXPECT_THROW(read(bytes.left(bytes.size() - 1)), ReadError);
  EXPECT_THROW(read(bytes + '\0'), ReadError) << "one byte too many";
}

/// A count that is so large that its bytes overflow 64 bits.
TEST_F(SessionTest, AbsurdCountsAreRefused) {
  const QByteArray bytes = to_bytes(whole_session(), folder.path());
  const auto points = static_cast<quint64>(document.scan(1)->model->soup.points.size());
  const QByteArray count(reinterpret_cast<const char*>(&points), sizeof points);
  const int at = bytes.indexOf(count);
  ASSERT_GT(at, 0);
  for (const quint64 absurd : {points + (quint64{1} << 32U), quint64{1} << 61U, ~quint64{0}}) {
    QByteArray broken = bytes;
    std::memcpy(broken.data() + at, &absurd, sizeof absurd);
    EXPECT_THROW(read(broken), ReadError) << absurd;
  }
}

/// What the window does first with a patch that it has read.
void use(const Session& session) {
  for (const SessionPatch& patch : session.patches) {
    curvature_field(patch.state->patch);
    seam_reports(patch.state->patch);
    curvature_uncertainty(patch.state->patch);
    patch_geometry(patch.state->patch);
  }
}

TEST_F(SessionTest, EveryByteChangedIsRefusedOrASessionThatCanBeUsed) {
  const QByteArray bytes = to_bytes(whole_session(), folder.path());
  const int stride =
      qEnvironmentVariableIntValue("LOOPMEND_AT_LENGTH") == 1 ? 1 : 7;  // each bit of a byte has its turn
  int read_well = 0, refused = 0;
  for (int at = 0; at < bytes.size(); at += at < 400 ? 1 : stride) {
    QByteArray changed = bytes;
    changed[at] = static_cast<char>(changed[at] ^ (1 << (at % 8)));
    try {
      const Session session = read(changed);
      if (read_well++ % 100 == 0) use(session);
    } catch (const ReadError& error) {
      ++refused;
      ASSERT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
    }
  }
  EXPECT_GT(read_well * stride, 1000) << "coordinates may have any value";
  EXPECT_GT(refused * stride, 1000) << "indices may not";
}

TEST_F(SessionTest, HugeNumbersInAnyPlaceAreRefusedOrASession) {
  const QByteArray bytes = to_bytes(whole_session(), folder.path());
  int refused = 0;
  for (int at = 0; at + 8 <= bytes.size(); at += at < 400 ? 1 : 12)
    for (const quint64 huge : {quint64{1} << 31U, quint64{1} << 61U, ~quint64{0}}) {
      QByteArray changed = bytes;
      std::memcpy(changed.data() + at, &huge, sizeof huge);
      try {
        read(changed);
      } catch (const ReadError&) {
        ++refused;
      }
    }
  EXPECT_GT(refused, 1000);
}

/// Indices that are in range, and yet would lead the engine astray.
TEST_F(SessionTest, PatchesThatDoNotHangTogetherAreRefused) {
  const Session whole = whole_session();
  const auto refused = [&](const char* words, const std::function<void(PatchState&)>& spoil) {
    Session session = whole;
    auto state = std::make_shared<PatchState>(*session.patches[0].state);
    spoil(*state);
    session.patches[0].state = state;
    try {
      read(to_bytes(session, folder.path()));
      ADD_FAILURE() << "was read: " << words;
    } catch (const ReadError& error) {
      EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    }
  };
  const double infinite = std::numeric_limits<double>::infinity();
  const auto fixed = static_cast<std::size_t>(whole.patches[0].state->patch.free_count);
  refused("mixed up", [](PatchState& s) { s.patch.ring.front() = 1; });
  refused("mixed up", [](PatchState& s) { s.patch.ring.back() = -3; });
  refused("mixed up", [](PatchState& s) { s.patch.view_vertex.front() = 0; });
  refused("mixed up", [&](PatchState& s) { s.patch.view_vertex[fixed] = -1; });
  refused("mixed up", [](PatchState& s) { s.patch.free_count += 1; });
  refused("names a vertex twice", [](PatchState& s) { s.patch.triangles[0][1] = s.patch.triangles[0][0]; });
  refused("do not fit", [](PatchState& s) { s.patch.triangles.back() = s.patch.triangles.front(); });
  refused("not the boundary", [&](PatchState& s) { s.patch.loops[0][0] = s.patch.vertex_count() - 1; });
  refused("does not exist", [](PatchState& s) { s.patch.loops[0].clear(); });
  refused("disagree", [](PatchState& s) { s.patch.loops.clear(); });
  refused("frame", [&](PatchState& s) { s.patch.scale = infinite; });
  refused("frame", [](PatchState& s) { s.patch.center.x() = std::nan(""); });
  refused("density", [](PatchState& s) { s.recipe.density = std::nan(""); });
  refused("density", [](PatchState& s) { s.recipe.density = 0; });
}

TEST_F(SessionTest, OtherFilesAndVersionsAreRefused) {
  const QByteArray bytes = to_bytes(whole_session(), folder.path());
  EXPECT_THROW(read("ply\nformat ascii 1.0\n"), ReadError);
  EXPECT_THROW(session_from_file(path("absent.loopmend")), ReadError);
  const int version = static_cast<int>(std::strlen("Loopmend session\n"));
  for (const char change : {-1, 1, 89}) {
    QByteArray other = bytes;
    other[version] = static_cast<char>(other[version] + change);
    try {
      read(other);
      ADD_FAILURE() << "was read: " << static_cast<int>(change);
    } catch (const ReadError& error) {
      EXPECT_NE(std::string(error.what()).find("this session is of another version of Loopmend"), std::string::npos);
    }
  }
}

TEST_F(SessionTest, AMessageWithoutEndIsRefused) {
  Session session = whole_session();
  auto state = std::make_shared<PatchState>(*session.patches[0].state);
  for (int depth = 0; depth < 1000; ++depth) state->message = say("%1", state->message);
  session.patches[0].state = state;
  EXPECT_THROW(read(to_bytes(session, folder.path())), ReadError);
}

TEST_F(SessionTest, AreToldByTheirEnding) {
  EXPECT_TRUE(is_session_path(QStringLiteral("/a/b.loopmend")));
  EXPECT_TRUE(is_session_path(QStringLiteral("B.LOOPMEND")));
  EXPECT_FALSE(is_session_path(QStringLiteral("loopmend")));
  EXPECT_FALSE(is_session_path(QStringLiteral("a.loopmend.ply")));
}

}  // namespace
}  // namespace loopmend::test
