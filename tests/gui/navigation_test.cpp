// SPDX-License-Identifier: GPL-3.0-or-later
// From where the scene is seen, and what the mouse does to it: the up axis, the view cube, the styles of navigation.
#include "driver.h"
#include "test_main.h"

#include "dialogs/navigation_sheet.h"
#include "document/navigation.h"
#include "document/preferences.h"
#include "samples/analytic_surfaces.h"
#include "views/tool_controller.h"
#include "views/view_cube.h"

#include <QAction>
#include <QLabel>
#include <QMouseEvent>
#include <QPointer>
#include <QTemporaryDir>
#include <QTest>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

using namespace loopmend;
using namespace loopmend::testing;

namespace {

Vec3 towards_eye(MainWindow& window) {
  const Viewpoint from = window.view().viewpoint();
  return (from.eye - from.focus).normalized();
}

bool near(const Vec3& a, const Vec3& b) { return (a - b).norm() < 1e-6 * (1 + b.norm()); }

void send(QWidget* canvas, QEvent::Type type, const QPoint& at, Qt::MouseButton button, Qt::MouseButtons held,
          Qt::KeyboardModifiers keys) {
  QMouseEvent event(type, at, canvas->mapToGlobal(at), button, held, keys);
  QCoreApplication::sendEvent(canvas, &event);
}

/// From the middle of the picture by this way.
void drag(MainWindow& window, Qt::MouseButton button, Qt::KeyboardModifiers keys, const QPoint& way) {
  QWidget* canvas = window.view().canvas();
  const QPoint from = canvas->rect().center();
  send(canvas, QEvent::MouseButtonPress, from, button, button, keys);
  constexpr int parts = 8;
  for (int k = 1; k <= parts; ++k) send(canvas, QEvent::MouseMove, from + k * way / parts, Qt::NoButton, button, keys);
  send(canvas, QEvent::MouseButtonRelease, from + way, button, Qt::NoButton, keys);
  settle();
}

/// What a drag did to the picture.
Motion motion_between(const Viewpoint& before, const Viewpoint& after) {
  const Vec3 a = before.eye - before.focus, b = after.eye - after.focus;
  const double size = a.norm();
  if ((after.focus - before.focus).norm() > 1e-3 * size) return Motion::slide;
  if (std::abs(b.norm() - size) > 1e-3 * size) return Motion::zoom;
  if ((a - b).norm() > 1e-3 * size) return Motion::turn;
  return (after.up - before.up).norm() > 1e-3 ? Motion::roll : Motion::nothing;
}

}  // namespace

class NavigationTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void cleanup() {
    save_navigation(NavigationStyle::loopmend);
    save_look({});
  }
  void the_picture_is_moved_and_asked_by_keys();
  void sides_projection_and_zoom_to_the_cursor();
  void the_up_axis_is_up_in_every_view();
  void the_up_axis_is_kept();
  void a_click_on_the_cube_shows_that_side();
  void the_cube_stays_clear_of_note_and_legend();
  void each_style_does_what_its_table_says_data();
  void each_style_does_what_its_table_says();
  void blender_turns_about_the_up_axis();
  void clicks_select_in_every_style();
  void tools_keep_the_left_button_in_every_style();
  void the_sheet_names_every_drag();

 private:
  QTemporaryDir folder_;
};

void NavigationTest::the_picture_is_moved_and_asked_by_keys() {
  Shown window({sample_file(folder_)});
  QWidget* canvas = window.view().canvas();
  canvas->setFocus();
  const Viewpoint first = window.view().viewpoint();
  QTest::keyClick(canvas, Qt::Key_Left);
  const Viewpoint turned = window.view().viewpoint();
  QVERIFY(near(turned.focus, first.focus) && !near(turned.eye, first.eye));
  QTest::keyClick(canvas, Qt::Key_Right, Qt::ShiftModifier);
  const Viewpoint slid = window.view().viewpoint();
  QVERIFY(near(slid.eye - turned.eye, slid.focus - turned.focus) && !near(slid.eye, turned.eye));
  QTest::keyClick(canvas, Qt::Key_Left, Qt::ShiftModifier);
  QVERIFY((window.view().viewpoint().eye - turned.eye).norm() < 1e-6 * turned.eye.norm());
  key(window, Qt::Key_P);
  const QString words = part<QLabel>(window, "statusFigures")->text();
  QVERIFY2(words.contains(QStringLiteral("vertex")), qPrintable(words));
}

void NavigationTest::sides_projection_and_zoom_to_the_cursor() {
  Shown window({sample_file(folder_)});
  trigger(window, "lookRight");
  const Vec3 right = towards_eye(window);
  trigger(window, "lookLeft");
  QVERIFY((right + towards_eye(window)).norm() < 1e-9);
  trigger(window, "lookTop");
  QVERIFY(std::abs(right.dot(towards_eye(window))) < 1e-9);

  trigger(window, "lookFront");
  settle();
  const QImage perspective = window.view().picture();
  trigger(window, "orthographic");
  QVERIFY(picture_changes(window, perspective, 0.001));
  trigger(window, "orthographic");
  QVERIFY(picture_returns(window, perspective));

  // What lies under the cursor stays there: only exactly so in the focal plane, which runs through the middle of the scan.
  for (const bool orthographic : {false, true}) {
    if (orthographic) trigger(window, "orthographic");
    trigger(window, "lookFront");
    settle();
    QWidget* canvas = window.view().canvas();
    const QPoint at(canvas->width() / 4, canvas->height() / 3);
    const Viewpoint before = window.view().viewpoint();
    QWheelEvent wheel(at, canvas->mapToGlobal(at), {}, {0, 120}, Qt::NoButton, {}, Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(canvas, &wheel);
    settle();
    const Viewpoint after = window.view().viewpoint();
    const double closer = (before.eye - before.focus).norm() / (after.eye - after.focus).norm();
    QVERIFY2(closer > 1.05, qPrintable(QString::number(closer)));
    // The focus moves towards the cursor: up and to the left of the picture.
    const Vec3 side = (before.focus - before.eye).cross(before.up).normalized();
    const Vec3 way = after.focus - before.focus;
    QVERIFY(way.dot(side) < 0 && way.dot(before.up) > 0);
    const double aspect = static_cast<double>(canvas->width()) / canvas->height();
    QVERIFY(std::abs(way.dot(side) / way.dot(before.up) + 0.5 * aspect / (1.0 / 3)) < 0.05);
  }
}

void NavigationTest::the_up_axis_is_up_in_every_view() {
  Shown window({sample_file(folder_)});
  const std::pair<const char*, Vec3> axes[] = {
      {"upX", Vec3::UnitX()}, {"upMinusX", -Vec3::UnitX()}, {"upY", Vec3::UnitY()},      {"upMinusY", -Vec3::UnitY()},
      {"upZ", Vec3::UnitZ()}, {"upMinusZ", -Vec3::UnitZ()}, {"upByShape", Vec3::UnitY()}};
  for (const auto& [name, up] : axes) {
    trigger(window, name);
    QVERIFY2(window.findChild<QAction*>(QLatin1String(name))->isChecked(), name);
    QVERIFY2(window.view().viewpoint().up.dot(up) > 0.9, name);  // the first picture, slightly from above
    Vec3 around = Vec3::Zero();
    for (const char* side : {"lookFront", "lookBack", "lookLeft", "lookRight"}) {
      trigger(window, side);
      QVERIFY2(near(window.view().viewpoint().up, up), side);
      around += towards_eye(window);
    }
    QVERIFY2(around.norm() < 1e-6, name);
    // Left and right are those of the person who looks at the front.
    trigger(window, "lookFront");
    const Vec3 front = towards_eye(window);
    trigger(window, "lookRight");
    QVERIFY2(near(towards_eye(window), up.cross(front)), name);
    trigger(window, "lookTop");
    QVERIFY2(near(towards_eye(window), up) && near(window.view().viewpoint().up, -front), name);
    trigger(window, "lookBottom");
    QVERIFY2(near(towards_eye(window), -up) && near(window.view().viewpoint().up, front), name);
  }
}

void NavigationTest::the_up_axis_is_kept() {
  const QString path = sample_file(folder_), session = folder_.filePath(QStringLiteral("turned.loopmend"));
  {
    Shown shown({path});
    trigger(shown, "upMinusZ");
    shown.controller().save_session(session);
    QVERIFY(wait_idle(shown));
    shown.keep_layout();
  }
  QVERIFY(load_look().up == UpAxis::minus_z);
  {
    Shown shown;
    shown.restore_layout();
    shown.open(path);
    QVERIFY(wait_until([&] { return shown.document().has_scan(); }) && wait_idle(shown));
    QVERIFY(near(shown.view().up(), -Vec3::UnitZ()));
  }
  save_look({});
  Shown shown({path});
  QVERIFY(near(shown.view().up(), Vec3::UnitY()));
  shown.open(session);
  QVERIFY(wait_until([&] { return near(shown.view().up(), -Vec3::UnitZ()); }));
}

void NavigationTest::a_click_on_the_cube_shows_that_side() {
  Shown window({sample_file(folder_)});
  auto* cube = window.findChild<ViewCube*>();
  QVERIFY(cube && cube->isVisible());
  trigger(window, "upMinusY");
  settle();
  const std::set<int> selected = {first_hole(window.document())};
  window.selection().select(selected);
  QWidget* canvas = window.view().canvas();
  for (const auto& [side, along] : {std::pair{NamedView::top, Vec3(-Vec3::UnitY())},
                                    {NamedView::front, Vec3(Vec3::UnitZ())},
                                    {NamedView::right, Vec3(-Vec3::UnitX())}}) {
    // From the front and above: each of these faces shows.
    window.view().set_viewpoint({Vec3::Zero(), 300 * Vec3(-0.5, -0.6, 0.7).normalized(), -Vec3::UnitY()});
    settle();
    const std::optional<QPoint> at = cube->middle_of(side);
    QVERIFY(at);
    QTest::mouseMove(canvas, *at);
    QTest::mouseClick(canvas, Qt::LeftButton, {}, *at);
    QVERIFY(window.view().is_flying());
    QVERIFY(wait_until([&] { return !window.view().is_flying(); }));
    QVERIFY(near(towards_eye(window), along));
    QVERIFY(window.selection().selected() == selected);  // a click on the cube is no click on nothing
  }
  // Beside the cube, in its corner, the picture has the mouse.
  QTest::mouseClick(canvas, Qt::LeftButton, {}, cube->geometry().bottomRight() - QPoint(2, 2));
  QVERIFY(window.selection().selected().empty());
}

void NavigationTest::the_cube_stays_clear_of_note_and_legend() {
  Shown window({sample_file(folder_)});
  auto* cube = window.findChild<ViewCube*>();
  auto* note = window.findChild<QWidget*>(QStringLiteral("hiddenNote"));
  trigger(window, "frame");
  window.selection().select({first_hole(window.document())});
  trigger(window, "hidePiece");
  QVERIFY(wait_until([&] { return note->isVisible(); }));
  QVERIFY(!note->geometry().intersects(cube->geometry()));
  QVERIFY(window.view().rect().contains(cube->geometry()));
  trigger(window, "showPieces");
  // The legend is all that the picture has beside the surface.
  PictureOptions options;
  options.size = window.view().canvas()->size() * window.view().canvas()->devicePixelRatioF();
  options.extras = PictureOptions::Extras::legend_axes_scale;
  const QImage with = window.view().picture(options);
  options.extras = PictureOptions::Extras::none;
  const QImage without = window.view().picture(options);
  const double ratio = window.view().canvas()->devicePixelRatioF();
  const QRect corner(QPointF(ratio * cube->x(), ratio * cube->y()).toPoint(), (QSizeF(cube->size()) * ratio).toSize());
  QVERIFY(with.copy(corner) == without.copy(corner));
}

void NavigationTest::each_style_does_what_its_table_says_data() {
  QTest::addColumn<int>("style");
  for (NavigationStyle style : all_navigation_styles) QTest::newRow(navigation(style).word) << static_cast<int>(style);
}

void NavigationTest::each_style_does_what_its_table_says() {
  QFETCH(int, style);
  const auto wanted = static_cast<NavigationStyle>(style);
  const char* const actions[] = {"navigateLoopmend", "navigateBlender", "navigateMeshLab", "navigateCad"};
  Shown window({scan_file(folder_, QStringLiteral("ball.ply"), make_icosphere(3))});
  trigger(window, actions[style]);
  QVERIFY(load_navigation() == wanted);
  for (Qt::MouseButton button : {Qt::LeftButton, Qt::MiddleButton, Qt::RightButton})
    for (Qt::KeyboardModifiers keys :
         {Qt::KeyboardModifiers(Qt::NoModifier), Qt::KeyboardModifiers(Qt::ShiftModifier),
          Qt::KeyboardModifiers(Qt::ControlModifier), Qt::KeyboardModifiers(Qt::AltModifier)}) {
      trigger(window, "lookFront");
      settle();
      const Viewpoint before = window.view().viewpoint();
      drag(window, button, keys, {90, 70});
      const Motion seen = motion_between(before, window.view().viewpoint());
      const Motion said = motion_of(wanted, button, keys, Hand::empty);
      QVERIFY2(seen == said, qPrintable(QStringLiteral("button %1, keys %2: %3 instead of %4")
                                            .arg(button)
                                            .arg(static_cast<int>(keys))
                                            .arg(static_cast<int>(seen))
                                            .arg(static_cast<int>(said))));
    }
  // What a person of each program expects.
  const Qt::MouseButton turns =
      wanted == NavigationStyle::blender || wanted == NavigationStyle::cad ? Qt::MiddleButton : Qt::LeftButton;
  QVERIFY(motion_of(wanted, turns, {}, Hand::empty) == Motion::turn);
}

void NavigationTest::blender_turns_about_the_up_axis() {
  Shown window({sample_file(folder_)});
  trigger(window, "navigateBlender");
  trigger(window, "upZ");
  trigger(window, "lookFront");
  settle();
  const Vec3 up = Vec3::UnitZ();
  for (const QPoint& way : {QPoint(160, 60), QPoint(-90, 110), QPoint(70, -60)}) {
    drag(window, Qt::MiddleButton, {}, way);
    const Viewpoint from = window.view().viewpoint();
    // The up axis stays upright: no part of it points to the side of the picture.
    QVERIFY(std::abs((from.focus - from.eye).normalized().cross(from.up).dot(up)) < 1e-9 && from.up.dot(up) > 0);
  }
  drag(window, Qt::MiddleButton, {}, {0, 5000});  // to the pole, and not beyond
  QVERIFY(near(towards_eye(window), up) || near(towards_eye(window), -up));
  drag(window, Qt::MiddleButton, {}, {0, -100});
  QVERIFY(window.view().viewpoint().up.dot(up) > 0);
}

void NavigationTest::clicks_select_in_every_style() {
  Shown window({sample_file(folder_)});
  const int hole = first_hole(window.document());
  QVERIFY(fly(window, hole));
  for (const char* style : {"navigateBlender", "navigateMeshLab", "navigateCad", "navigateLoopmend"}) {
    trigger(window, style);
    window.selection().select({});
    const Viewpoint before = window.view().viewpoint();
    QTest::mouseClick(window.view().canvas(), Qt::LeftButton, {}, visible_point(window, hole));
    QVERIFY2(window.selection().selected() == std::set<int>{hole}, style);
    QVERIFY2(near(window.view().viewpoint().eye, before.eye), style);
  }
}

void NavigationTest::tools_keep_the_left_button_in_every_style() {
  Shown window({sample_file(folder_)});
  trigger(window, "lookFront");
  trigger(window, "toolRegionAction");
  settle();
  for (const char* style : {"navigateBlender", "navigateMeshLab", "navigateCad", "navigateLoopmend"}) {
    trigger(window, style);
    const Viewpoint before = window.view().viewpoint();
    drag(window, Qt::LeftButton, {}, {40, 10});
    QVERIFY2(motion_between(before, window.view().viewpoint()) == Motion::nothing, style);  // it paints
    drag(window, Qt::LeftButton, Qt::ShiftModifier, {40, 10});
    QVERIFY2(motion_between(before, window.view().viewpoint()) == Motion::turn, style);
    trigger(window, "lookFront");
    settle();
  }
  QVERIFY(!window.tools().region().vertices().empty());
}

void NavigationTest::the_sheet_names_every_drag() {
  Shown shown({sample_file(folder_)});
  trigger(shown, "navigationSheet");
  QPointer<NavigationSheet> sheet;
  QVERIFY(wait_until([&] { return (sheet = shown.findChild<NavigationSheet*>()) && sheet->isVisible(); }));
  QStringList texts;
  for (const QLabel* label : sheet->findChildren<QLabel*>()) texts << label->text();
  for (NavigationStyle style : all_navigation_styles)
    for (Motion motion : {Motion::turn, Motion::slide, Motion::zoom})
      for (const QString& drag : drags_for(style, motion).split(QStringLiteral(", ")))
        QVERIFY2(!drag.isEmpty() && texts.join(QLatin1Char('\n')).contains(drag), qPrintable(drag));
  sheet->close();
}

std::unique_ptr<QObject> loopmend::testing::make_test() { return std::make_unique<NavigationTest>(); }

#include "navigation_test.moc"
