// SPDX-License-Identifier: GPL-3.0-or-later
// Random cycles of work on small random scans: after each step the scan is as it was in every bit, undo and redo lead to
// equal states, and a session comes back as it was saved.
#include "document/session.h"
#include "document/timeline.h"
#include "io/write_mesh.h"
#include "jobs/fill_controller.h"
#include "samples/analytic_surfaces.h"
#include "surfaces/roughen.h"

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QFile>
#include <QTemporaryDir>
#include <QThread>
#include <QTimer>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <map>
#include <random>
#include <string>
#include <utility>

namespace loopmend::test {
namespace {

/// How many cycles, and the first of them: LOOPMEND_CYCLES and LOOPMEND_FIRST_CYCLE set others.
int number_from(const char* name, int otherwise) {
  const char* asked = std::getenv(name);
  return asked ? std::max(0, std::atoi(asked)) : otherwise;
}
int cycles() { return number_from("LOOPMEND_CYCLES", 15); }

constexpr int actions_per_cycle = 12;

class Dice {
 public:
  explicit Dice(unsigned seed) : engine_(seed) {}
  /// 0 .. count − 1
  int below(int count) { return static_cast<int>(engine_() % static_cast<std::uint64_t>(count)); }
  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_() >> 11) * 0x1p-53;
  }

 private:
  std::mt19937_64 engine_;
};

/// A sphere, torus, tube or wavy sheet of irregular triangles with a little noise, and one to three holes at random places.
TriangleSoup small_scan(Dice& dice) {
  const int kind = dice.below(4);
  TriangleSoup soup;
  if (kind == 0)
    soup = roughen(make_icosphere(2), 0.2, 0.2, static_cast<unsigned>(dice.below(1000)),
                   [](const Vec3& p) { return Vec3(p.normalized()); });
  if (kind == 1) soup = make_torus(2, 0.8, 20, 10);
  if (kind == 2) soup = make_cylinder(3, 18);
  const double wave = dice.between(0.5, 2);
  if (kind == 3) soup = make_graph([&](double x, double y) { return 0.2 * std::sin(wave * x) * y; }, 2, 14);
  const double noise = dice.below(2) == 0 ? 0 : dice.between(0, 0.02);
  for (Vec3& p : soup.points)
    for (double& x : p) x += dice.between(-noise, noise);
  for (int holes = 1 + dice.below(3); holes > 0; --holes) {
    const Vec3 middle = soup.points[dice.below(static_cast<int>(soup.points.size()))];
    const double radius = dice.between(0.2, 0.6);
    soup = cut(soup, [&](const Vec3& p) { return (p - middle).norm() < radius; });
  }
  return trim_boundaries(soup);
}

void add_bits(std::vector<std::uint64_t>& bits, const Points& points) {
  for (const Vec3& p : points)
    for (const double x : p) bits.push_back(std::bit_cast<std::uint64_t>(x));
}

/// What a person sees of a patch, by value.
struct PatchCopy {
  std::vector<int> loops;
  Acceptance acceptance{};
  PatchStatus status{};
  int steps = 0, free_count = 0;
  std::size_t runs = 0;
  std::string message;
  Triangles triangles;
  std::vector<std::uint64_t>
      bits;  ///< of positions, frame, energies, the last step (sessions have no energy of its own) and seams
  auto operator<=>(const PatchCopy&) const = default;
};

struct SceneCopy {
  std::vector<PatchCopy> patches;  ///< in the order of their loops
  /// Likewise the place in the timeline, and its length; sessions do not keep them.
  std::vector<std::pair<std::size_t, std::size_t>> timelines;
  bool same_patches(const SceneCopy& other) const { return patches == other.patches; }
  bool operator==(const SceneCopy&) const = default;
};

SceneCopy copy_of(const Document& document) {
  std::vector<const OpenPatch*> open;
  for (const OpenPatch& patch : document.patches()) open.push_back(&patch);
  std::sort(open.begin(), open.end(), [](const OpenPatch* a, const OpenPatch* b) { return a->loops < b->loops; });
  SceneCopy scene;
  for (const OpenPatch* patch : open) {
    const PatchState& state = *patch->state;
    PatchCopy copy{patch->loops,
                   patch->acceptance,
                   state.status,
                   state.steps,
                   state.patch.free_count,
                   state.recipe.runs.size(),
                   state.message.english(),
                   state.patch.triangles,
                   {}};
    add_bits(copy.bits, state.patch.positions);
    add_bits(copy.bits, {state.patch.center, Vec3(state.patch.scale, state.energy.initial, state.energy.final)});
    const StepRecord& step = state.last_step;
    add_bits(copy.bits, {Vec3(static_cast<double>(state.flow), step.step, 0), Vec3(step.sigma, step.tau, step.max_move),
                         Vec3(state.seconds.total, 0, 0)});
    for (const SeamReport& seam : state.seams)
      add_bits(copy.bits, {Vec3(seam.g1_rms_deg, seam.g1_max_deg, seam.h_jump_rms)});
    scene.patches.push_back(std::move(copy));
    scene.timelines.emplace_back(place_in(*patch->timeline, patch->state), patch->timeline->size());
  }
  return scene;
}

QByteArray bytes_of(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// One scan, opened and worked on as by a person, with what the scene must be.
class Cycle {
 public:
  Cycle(unsigned seed, std::map<std::string, int>& counts)
      : dice_(seed),
        counts_(counts),
        original_(small_scan(dice_)) {
    heartbeat_.start(20);
    scan_ = folder_.filePath(QStringLiteral("scan.ply"));
    session_ = folder_.filePath(QStringLiteral("scan.loopmend"));
    write_mesh(scan_.toStdString(), original_);
    scan_bytes_ = bytes_of(scan_);
    QObject::connect(&controller_, &FillController::failed, [this](const QString& words) { failure_ = words; });
    QObject::connect(&document_, &Document::opened, [this] { opened_ = true; });
    controller_.open({scan_}, OpenMode::replace);
    finish("open");
  }

  void run() {
    fill();
    for (int k = 1; k < actions_per_cycle && !::testing::Test::HasFailure(); ++k) act();
    go_through_history();
    EXPECT_TRUE(controller_.shut_down(std::chrono::minutes(4))) << "every worker ends";
    EXPECT_EQ(bytes_of(scan_), scan_bytes_) << "the file of the scan";
    if (::testing::Test::HasFailure()) std::cout << "  so far: " << story_ << '\n';
  }

 private:
  // -- What a person does --------------------------------------------------------------------------------------------

  void act() {
    switch (dice_.below(12)) {
      case 0:
      case 1: return fill();
      case 2: return flow(Pace::time_step);
      case 3: return flow(Pace::steady);
      case 4: return fill_and_smooth();
      case 5: return accept_or_discard();
      case 6: return go_back_in_time();
      case 7: return save();
      case 8: return reopen();
      case 9: return export_scene();
      default: return undo_and_redo();
    }
  }

  void fill() {
    controller_.fill(some_loops(), {dice_.between(0.8, 1.3), FillOptions::Islands::join});
    finish_or_cancel("fill");
  }

  EvolutionOptions options() {
    EvolutionOptions options;
    options.flow = std::array{FlowKind::mcf, FlowKind::sdf, FlowKind::wf, FlowKind::mmcvf}.at(
        static_cast<std::size_t>(dice_.below(4)));
    return options;
  }

  void flow(Pace pace) {
    controller_.evolve(some_patches(), options(), pace);
    finish_or_cancel(pace == Pace::time_step ? "step" : "steady");
  }

  void fill_and_smooth() {
    controller_.fill_and_smooth(some_loops(), some_patches(), {}, options());
    finish_or_cancel("fill and smooth");
  }

  void accept_or_discard() {
    const int which = dice_.below(3);
    if (which == 0)
      controller_.reject(some_patches());
    else
      controller_.set_acceptance(some_patches(), which == 1 ? Acceptance::accepted : Acceptance::pending);
    finish(which == 0 ? "discard" : "accept");
  }

  void go_back_in_time() {
    const std::set<int> patches = some_patches();
    for (int k = dice_.below(4); k >= 0; --k) controller_.scrub_to(patches, static_cast<std::size_t>(dice_.below(5)));
    controller_.end_scrub();
    finish("timeline");
  }

  void undo_and_redo() {
    for (int k = 1 + dice_.below(6); k > 0; --k) dice_.below(5) < 3 ? undo_one() : redo_one();
  }

  /// To the beginning, and back to the end.
  void go_through_history() {
    while (now_ > 0 && !::testing::Test::HasFailure()) undo_one();
    while (now_ + 1 < past_.size() && !::testing::Test::HasFailure()) redo_one();
  }

  void undo_one() {
    if (now_ == 0) return;
    undo_.undo();
    --now_;
    expect_place("undo");
  }

  void redo_one() {
    if (now_ + 1 == past_.size()) return;
    undo_.redo();
    ++now_;
    expect_place("redo");
  }

  void expect_place(const char* how) {
    count(how);
    EXPECT_TRUE(copy_of(document_) == past_[now_])
        << how << " leads to another state, " << now_ << " of " << past_.size();
    check(how);
  }

  /// On the disk is what was saved last, also while another is written; after a cancel one of the two.
  void save() {
    controller_.save_session(session_);
    const bool whole = finish_or_cancel("save");
    if (whole) on_disk_.clear();
    on_disk_.push_back(past_[now_]);
    EXPECT_TRUE(copy_of(document_) == past_[now_]) << "saving changes something";
    EXPECT_TRUE(undo_.is_saved() || !whole);
  }

  void reopen() {
    if (!QFile::exists(session_)) return;
    opened_ = false;
    controller_.open_session({session_, {}, {}});
    const bool whole = wait_or_cancel("reopen");
    const SceneCopy now = copy_of(document_);
    EXPECT_TRUE(opened_ || !whole) << failure_.toStdString();
    if (opened_) {
      EXPECT_TRUE(std::any_of(on_disk_.begin(), on_disk_.end(), [&](const auto& one) { return one.same_patches(now); }))
          << "the scene is the one that was saved";
      past_ = {now};
      now_ = 0;
    } else {
      EXPECT_TRUE(now == past_[now_]) << "a session that was not opened changes something";
    }
    check("reopen");
  }

  void export_scene() {
    const QString path = folder_.filePath(QStringLiteral("out.ply"));
    controller_.export_to(path);
    if (finish_or_cancel("export")) {
      const TriangleSoup written = read_mesh(path.toStdString()).soup;
      expect_exterior(written);
    }
    QFile::remove(path);
  }

  // -- What must hold ------------------------------------------------------------------------------------------------

  /// @returns whether it came to its end.
  bool wait_or_cancel(const char* what) {
    const bool is_cancelled = dice_.below(4) == 0 && controller_.busy();
    if (is_cancelled) {
      QThread::usleep(static_cast<unsigned long>(dice_.below(dice_.below(2) == 0 ? 1000 : 30000)));
      if (dice_.below(2) == 0) QCoreApplication::processEvents();
      controller_.cancel();
      count("cancel");
      EXPECT_FALSE(controller_.busy());
    }
    while (controller_.busy()) QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    count(what);
    story_ += is_cancelled ? " (cancelled)" : "";
    return !is_cancelled;
  }

  bool finish_or_cancel(const char* what) {
    const bool whole = wait_or_cancel(what);
    finish(nullptr);
    return whole;
  }

  /// Whatever changed is one change that can be undone, but for the first.
  void finish(const char* what) {
    if (what) wait_for(what);
    SceneCopy scene = copy_of(document_);
    if (past_.empty()) {
      past_.push_back(std::move(scene));
    } else if (scene != past_[now_]) {
      past_.resize(now_ + 1);
      past_.push_back(std::move(scene));
      ++now_;
    }
    check(what ? what : "a job");
  }

  void wait_for(const char* what) {
    while (controller_.busy()) QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    count(what);
  }

  void check(const char* what) {
    SCOPED_TRACE(what);
    EXPECT_EQ(undo_.can_undo(), now_ > 0);
    EXPECT_EQ(undo_.can_redo(), now_ + 1 < past_.size());
    ASSERT_EQ(document_.scans().size(), 1U) << failure_.toStdString();
    expect_exterior(document_.first_scan().model->soup);
    std::size_t patch_triangles = 0;
    for (const OpenPatch& patch : document_.patches())
      if (patch.state->status != PatchStatus::invalid || patch.acceptance == Acceptance::accepted)
        patch_triangles += static_cast<std::size_t>(patch.state->patch.patch_triangles);
    const TriangleSoup whole = plain_surface(export_task(document_, {}));
    expect_exterior(whole);
    EXPECT_EQ(whole.triangles.size(), original_.triangles.size() + patch_triangles);
  }

  /// The scan comes first, in every bit.
  void expect_exterior(const TriangleSoup& soup) {
    ++counts_["surfaces compared"];
    ASSERT_GE(soup.points.size(), original_.points.size());
    ASSERT_GE(soup.triangles.size(), original_.triangles.size());
    std::vector<std::uint64_t> bits, wanted;
    add_bits(bits, {soup.points.begin(), soup.points.begin() + static_cast<std::ptrdiff_t>(original_.points.size())});
    add_bits(wanted, original_.points);
    EXPECT_EQ(bits, wanted);
    EXPECT_TRUE(std::equal(original_.triangles.begin(), original_.triangles.end(), soup.triangles.begin()));
  }

  void count(const char* what) {
    ++counts_[what];
    story_ += std::string(story_.empty() ? "" : ", ") + what;
  }

  std::set<int> some_loops() {
    std::set<int> loops;
    for (int loop = 0; loop < document_.loop_count(); ++loop)
      if (dice_.below(3) > 0) loops.insert(loop);
    return loops;
  }

  std::set<int> some_patches() {
    std::set<int> ids;
    for (const OpenPatch& patch : document_.patches())
      if (dice_.below(3) > 0) ids.insert(patch.id);
    return ids;
  }

  Dice dice_;
  std::map<std::string, int>& counts_;
  TriangleSoup original_;
  QTemporaryDir folder_;
  QString scan_, session_, failure_;
  QByteArray scan_bytes_;
  std::vector<SceneCopy> past_;     ///< what undo and redo must lead to
  std::size_t now_ = 0;             ///< place in it
  std::vector<SceneCopy> on_disk_;  ///< what the session file may hold
  std::string story_;               ///< what was done
  bool opened_ = false;             ///< another scene has come
  QTimer heartbeat_;                ///< so that no wait for events is without an end
  Document document_;
  UndoHistory undo_;
  FillController controller_{document_, undo_};
};

/// Another flow on a bridge of two free vertices that no step improves: the energy of the last step was corrected, and
/// there was none.
TEST(Cycles, AFlowWhoseFirstStepIsRefusedGoesOnWithCubicFits) {
  std::map<std::string, int> counts;
  Cycle(252, counts).run();
  EXPECT_GT(counts["steady"], 0);
}

/// The one is large and takes longer to be written than the other, which is saved when the first was cancelled.
TEST(Cycles, ASaveThatWasCancelledDoesNotReplaceTheOneAfterIt) {
  const QTemporaryDir folder;
  const QString scan = folder.filePath(QStringLiteral("scan.ply")),
                path = folder.filePath(QStringLiteral("a.loopmend"));
  write_mesh(scan.toStdString(), cut(make_icosphere(4), [](const Vec3& p) { return p.z() > 0.5; }));
  Document document;
  UndoHistory undo;
  FillController controller(document, undo);
  QTimer heartbeat;
  heartbeat.start(20);
  const auto wait = [&] {
    while (controller.busy()) QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
  };
  controller.open({scan}, OpenMode::replace);
  wait();
  controller.fill({0}, {1.0, FillOptions::Islands::join});
  wait();
  ASSERT_EQ(document.patches().size(), 1U);
  for (int k = 0; k < 30; ++k) {
    controller.save_session(path);
    QThread::usleep(static_cast<unsigned long>(500 * (k % 10)));
    controller.cancel();
    undo.undo();
    ASSERT_EQ(document.patches().size(), 0U);
    controller.save_session(path);
    wait();
    ASSERT_TRUE(controller.shut_down(std::chrono::minutes(4)));
    EXPECT_EQ(session_from_file(path).patches.size(), 0U) << "after " << 500 * (k % 10) << " microseconds";
    undo.redo();
    ASSERT_EQ(document.patches().size(), 1U);
  }
}

TEST(Cycles, LeaveTheScanAsItWasAndUndoLeadsBack) {
  std::map<std::string, int> counts;
  const int first = number_from("LOOPMEND_FIRST_CYCLE", 0);
  for (int k = 0; k < cycles() && !::testing::Test::HasFailure(); ++k) {
    SCOPED_TRACE("cycle " + std::to_string(first + k));
    Cycle(static_cast<unsigned>(first + k), counts).run();
  }
  for (const auto& [what, count] : counts) std::cout << "  " << what << ": " << count << '\n';
  if (cycles() < 50) return;
  for (const char* what : {"fill", "step", "steady", "undo", "redo", "cancel", "save", "reopen", "export"})
    EXPECT_GT(counts[what], 5) << what;
}

}  // namespace
}  // namespace loopmend::test
