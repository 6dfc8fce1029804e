// SPDX-License-Identifier: GPL-3.0-or-later
// The recorded states of a patch are played: from the start, at a pace, paused, again and again; one change for undo.
#include "driver.h"
#include "test_main.h"

#include "document/labels.h"
#include "document/timeline.h"
#include "evolution/evolution.h"
#include "samples/analytic_surfaces.h"

#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QElapsedTimer>
#include <QLabel>
#include <QPushButton>
#include <QSlider>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>

#include <cmath>
#include <set>
#include <vector>

using namespace loopmend;
using namespace loopmend::testing;

namespace {

/// The sample's first hole, filled: its flow has several states.
struct Flow {
  explicit Flow(MainWindow& w) : window(w) {
    window.selection().select({first_hole(window.document())});
    trigger(window, "fillAction");
    ready = wait_idle(window) && states() > 3;
    settle();
    changes = undo_text();
  }
  const OpenPatch& patch() const { return window.document().patches().front(); }
  int states() const { return static_cast<int>(patch().timeline->size()); }
  int place() const { return static_cast<int>(place_in(*patch().timeline, patch().state)); }
  QString undo_text() const { return window.undo().undo_text(); }
  MainWindow& window;
  bool ready = false;
  QString changes;
};

bool is_playing(MainWindow& window) { return part<QPushButton>(window, "play")->text() == QStringLiteral("Pause"); }

void choose_pace(MainWindow& window, double states_a_second) {
  auto* pace = part<QComboBox>(window, "playPace");
  pace->setCurrentIndex(pace->findData(states_a_second));
}

/// A ball with one hole, and its initial patch.
QString ball_with_a_hole(const QTemporaryDir& folder) {
  return scan_file(folder, QStringLiteral("ball.ply"),
                   cut(make_icosphere(3), [](const Vec3& p) { return p.z() > 0.8; }));
}

/// @returns the first recorded state that differs in a bit from what the engine makes in as many steps; -1: none.
int first_other_state(const Timeline& states, Evolution& evolution) {
  for (std::size_t k = 0; k < states.size(); ++k) {
    if (states[k]->patch.positions != evolution.patch().positions) return static_cast<int>(k);
    if (k + 1 < states.size()) evolution.step({});
  }
  return -1;
}

}  // namespace

class PlayerTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void every_state_is_shown_in_its_order();
  void the_pace_is_what_it_says();
  void a_pause_is_one_change_for_undo();
  void space_and_escape_pause();
  void space_runs_and_plays_with_the_focus_on_a_slider();
  void it_goes_on_again_and_again_until_something_else_is_done();
  void the_next_state_comes_by_a_key();
  void there_is_nothing_to_play_without_states();
  void a_session_keeps_the_states();
  void steps_are_those_of_the_scheme_with_the_time_step_shown();
  void run_shows_the_states_of_the_engine();
  void what_a_fold_opens_comes_into_view();

 private:
  QTemporaryDir folder_;
};

void PlayerTest::every_state_is_shown_in_its_order() {
  Shown window({sample_file(folder_)});
  const Flow flow(window);
  QVERIFY(flow.ready);
  QCOMPARE(flow.place(), flow.states() - 1);
  const QImage last = window.view().picture();
  choose_pace(window, 8);
  std::vector<int> places;
  QStringList places_named;
  auto* words = part<QLabel>(window, "timelinePlace");
  connect(&window.document(), &Document::patch_moved, words, [&] {
    places.push_back(flow.place());
    if (!places_named.contains(words->text())) places_named << words->text();
  });
  press(window, "play");
  QVERIFY(is_playing(window));
  QVERIFY(wait_until([&] { return !is_playing(window); }));
  QCOMPARE(static_cast<int>(places.size()), flow.states());
  for (int k = 0; k < flow.states(); ++k) QCOMPARE(places[static_cast<std::size_t>(k)], k);
  QCOMPARE(static_cast<int>(places_named.size()), flow.states());
  QVERIFY(places_named.filter(QStringLiteral("initial patch")).size() == 1);
  // It ends where it was: nothing has changed.
  QCOMPARE(flow.undo_text(), flow.changes);
  settle();
  QVERIFY(picture_returns(window, last));
}

void PlayerTest::the_pace_is_what_it_says() {
  Shown window({sample_file(folder_)});
  const Flow flow(window);
  QVERIFY(flow.ready);
  for (const double pace : {4.0, 16.0}) {
    choose_pace(window, pace);
    QElapsedTimer clock;
    clock.start();
    press(window, "play");
    QVERIFY(wait_until([&] { return !is_playing(window); }));
    const double seconds = 0.001 * static_cast<double>(clock.elapsed()), least = (flow.states() - 1) / pace;
    // Never faster; a busy machine may be slower.
    QVERIFY2(seconds > 0.9 * least, qPrintable(QString::number(seconds)));
    if (seconds > 3 * least) QSKIP("the machine is too busy to say how fast it plays");
  }
}

void PlayerTest::a_pause_is_one_change_for_undo() {
  Shown window({sample_file(folder_)});
  const Flow flow(window);
  QVERIFY(flow.ready);
  const PatchStatePtr last = flow.patch().state;
  choose_pace(window, 8);
  key(window, Qt::Key_Space, Qt::ShiftModifier);
  QVERIFY(is_playing(window));
  QVERIFY(wait_until([&] { return flow.place() >= 2 && flow.place() < flow.states() - 1; }));
  key(window, Qt::Key_Space, Qt::ShiftModifier);
  QVERIFY(!is_playing(window));
  const int at = flow.place();
  QVERIFY(at >= 2 && at < flow.states() - 1);
  QVERIFY(flow.undo_text() != flow.changes);
  trigger(window, "undo");
  QVERIFY(flow.patch().state == last);
  QCOMPARE(flow.undo_text(), flow.changes);
  trigger(window, "redo");
  QCOMPARE(flow.place(), at);
  // From there, not from the start.
  key(window, Qt::Key_Space, Qt::ShiftModifier);
  QVERIFY(is_playing(window) && flow.place() >= at);
  QVERIFY(wait_until([&] { return !is_playing(window); }));
  QCOMPARE(flow.place(), flow.states() - 1);
}

void PlayerTest::space_and_escape_pause() {
  Shown window({sample_file(folder_)});
  const Flow flow(window);
  QVERIFY(flow.ready);
  const TimelinePtr recorded = flow.patch().timeline;
  choose_pace(window, 1);
  for (const Qt::Key stop : {Qt::Key_Space, Qt::Key_Escape}) {
    trigger(window, "playAction");
    QVERIFY(is_playing(window));
    key(window, stop);
    QVERIFY(!is_playing(window) && !window.controller().busy());
    QVERIFY(flow.patch().timeline == recorded);  // no run replaced what comes later
    QVERIFY(!window.selection().selected().empty());
  }
  // With the hand on the slider, too.
  auto* timeline = part<QSlider>(window, "timeline");
  trigger(window, "playAction");
  QTest::mouseClick(timeline, Qt::LeftButton, {}, timeline->rect().center());
  QVERIFY(!is_playing(window));
}

/// A click on the timeline leaves the focus there.
void PlayerTest::space_runs_and_plays_with_the_focus_on_a_slider() {
  Shown window({sample_file(folder_)});
  const Flow flow(window);
  QVERIFY(flow.ready);
  choose_pace(window, 1);
  for (const char* name : {"timeline", "sigma"}) {
    auto* slider = part<QSlider>(window, name);
    QTest::mouseClick(slider, Qt::LeftButton, {}, QPoint(4, slider->height() / 2));
    QVERIFY2(slider->hasFocus(), name);
    QVERIFY(!is_playing(window) && !window.controller().busy());
    QTest::keyClick(slider, Qt::Key_Space, Qt::ShiftModifier);
    QVERIFY2(is_playing(window), name);
    QTest::keyClick(slider, Qt::Key_Space, Qt::ShiftModifier);
    QVERIFY2(!is_playing(window) && !window.controller().busy(), name);
    QTest::keyClick(slider, Qt::Key_Space);
    QVERIFY2(window.controller().busy(), name);
    QWidget* focused = QApplication::focusWidget();  // no control that would answer to Space
    QTest::keyClick(focused ? focused : &window, Qt::Key_Space);
    QVERIFY2(window.controller().activity() == Activity::pausing || !window.controller().busy(), name);
    QVERIFY(wait_idle(window));
  }
}

void PlayerTest::it_goes_on_again_and_again_until_something_else_is_done() {
  Shown window({sample_file(folder_)});
  const Flow flow(window);
  QVERIFY(flow.ready);
  choose_pace(window, 16);
  part<QCheckBox>(window, "playAgain")->setChecked(true);
  int starts = 0;
  connect(&window.document(), &Document::patch_moved, this, [&] { starts += flow.place() == 0; });
  press(window, "play");
  QVERIFY(wait_until([&] { return starts == 3; }));
  QVERIFY(is_playing(window));
  window.selection().select({});
  QVERIFY(!is_playing(window));
  window.selection().select({first_hole(window.document())});
  press(window, "play");
  QVERIFY(is_playing(window));
  press(window, "accept");
  QVERIFY(!is_playing(window));
  QVERIFY(flow.patch().acceptance == Acceptance::accepted);
  trigger(window, "undo");
  QVERIFY(flow.patch().acceptance == Acceptance::pending);
}

void PlayerTest::the_next_state_comes_by_a_key() {
  Shown window({sample_file(folder_)});
  const Flow flow(window);
  QVERIFY(flow.ready);
  key(window, Qt::Key_Period);
  QCOMPARE(flow.place(), 0);  // after the last, the first
  key(window, Qt::Key_Period);
  QCOMPARE(flow.place(), 1);
  press(window, "nextState");
  QCOMPARE(flow.place(), 2);
}

void PlayerTest::there_is_nothing_to_play_without_states() {
  Shown window({sample_file(folder_)});
  for (const char* name : {"playAction", "nextStateAction"})
    QVERIFY2(!window.findChild<QAction*>(QLatin1String(name))->isEnabled(), name);
  window.selection().select({first_hole(window.document())});
  press(window, "fill");
  QVERIFY(wait_idle(window));
  settle();
  QVERIFY(!part<QPushButton>(window, "play")->isEnabled());  // the initial patch alone
}

/// Saved in the middle of its states and opened again: all are there, to the bit, and make a film.
void PlayerTest::a_session_keeps_the_states() {
  const QString session = folder_.filePath(QStringLiteral("states.loopmend"));
  std::vector<Points> positions;
  std::vector<int> steps;
  int place = 0;
  {
    Shown window({sample_file(folder_)});
    const Flow flow(window);
    QVERIFY(flow.ready);
    part<QSlider>(window, "timeline")->setValue(2);
    QVERIFY(wait_until([&] { return flow.place() == 2; }));
    for (const PatchStatePtr& state : *flow.patch().timeline) {
      positions.push_back(state->patch.positions);
      steps.push_back(state->steps);
    }
    place = flow.place();
    window.controller().save_session(session);
    QVERIFY(wait_idle(window));
  }
  Shown window({session});
  QVERIFY(wait_until([&] { return !window.document().patches().empty() && !window.controller().busy(); }));
  const OpenPatch& patch = window.document().patches().front();
  QCOMPARE(patch.timeline->size(), positions.size());
  for (std::size_t k = 0; k < positions.size(); ++k) {
    QVERIFY((*patch.timeline)[k]->patch.positions == positions[k]);
    QCOMPARE((*patch.timeline)[k]->steps, steps[k]);
  }
  QCOMPARE(static_cast<int>(place_in(*patch.timeline, patch.state)), place);
  window.selection().select({patch.loops.front()});
  settle();
  QVERIFY(window.findChild<QAction*>(QStringLiteral("film"))->isEnabled());
  std::set<int> shown;
  choose_pace(window, 8);
  connect(&window.document(), &Document::patch_moved, &window, [&] {
    shown.insert(static_cast<int>(
        place_in(*window.document().patches().front().timeline, window.document().patches().front().state)));
  });
  press(window, "play");
  QVERIFY(wait_until([&] { return !is_playing(window); }));
  QCOMPARE(*shown.rbegin(), static_cast<int>(positions.size()) - 1);
  QCOMPARE(static_cast<int>(shown.size()), static_cast<int>(positions.size()) - 1 - place);  // from there on
}

/// Run steps, and Step after it.
void PlayerTest::steps_are_those_of_the_scheme_with_the_time_step_shown() {
  Shown window({ball_with_a_hole(folder_)});
  QVERIFY(press_and_wait(window, "fill"));
  auto* slider = part<QSlider>(window, "sigma");
  slider->setValue(-5);
  const double sigma = std::pow(10, -0.5);
  QCOMPARE(part<QLabel>(window, "sigmaValue")->text(), QStringLiteral("\u03c3 = ") + labels::number(sigma));
  press(window, "runSteps");
  const auto taken = [&] { return window.document().patches().front().timeline->size() - 1; };
  QVERIFY(wait_until([&] { return taken() >= 3; }));
  window.controller().pause();  // the button would start another run where this one has ended
  QVERIFY(wait_idle(window));
  QVERIFY(press_and_wait(window, "step"));
  const Timeline states = *window.document().patches().front().timeline;
  EvolutionOptions options;
  options.mode = EvolutionMode::steps;
  options.sigma = sigma;
  Evolution evolution(states.front()->patch, options);
  QCOMPARE(first_other_state(states, evolution), -1);
  // Each state says the time step with which the engine came there.
  auto* timeline = part<QSlider>(window, "timeline");
  for (std::size_t k = 1; k < states.size(); ++k) {
    const double used = evolution.history()[k - 1].sigma;
    timeline->setValue(static_cast<int>(k));
    const QString words = QStringLiteral("\u03c3 ") + labels::number(used);
    const QString in_timeline = part<QLabel>(window, "timelinePlace")->text(),
                  below = part<QLabel>(window, "statusFigures")->text();
    QVERIFY2(in_timeline.contains(words), qPrintable(in_timeline));
    QVERIFY2(below.contains(words), qPrintable(below));
  }
  QCOMPARE(evolution.history().front().sigma, sigma);
}

/// On an exact neighborhood: the flow itself, to the steady state.
void PlayerTest::run_shows_the_states_of_the_engine() {
  Shown window({ball_with_a_hole(folder_)});
  QVERIFY(press_and_wait(window, "fill"));
  QVERIFY(press_and_wait(window, "run"));
  const Timeline states = *window.document().patches().front().timeline;
  QVERIFY(states.size() > 2);
  Evolution evolution(states.front()->patch, EvolutionOptions());
  QCOMPARE(first_other_state(states, evolution), -1);
}

/// The flow's further controls lie below what the panel shows.
void PlayerTest::what_a_fold_opens_comes_into_view() {
  Shown window({sample_file(folder_)});
  QVERIFY(press_and_wait(window, "fillAndSmooth"));
  auto* fold = part<QToolButton>(window, "moreOfFlow");
  fold->setChecked(false);
  QVERIFY(settle());
  const auto* steps = window.findChild<QPushButton*>(QStringLiteral("runSteps"));
  QTest::mouseClick(fold, Qt::LeftButton);
  QVERIFY(settle());
  QVERIFY(steps->isVisible());
  QCOMPARE(steps->visibleRegion().boundingRect(), steps->rect());
  QVERIFY(!fold->visibleRegion().isEmpty());  // to close it again
}

std::unique_ptr<QObject> loopmend::testing::make_test() { return std::make_unique<PlayerTest>(); }

#include "player_test.moc"
