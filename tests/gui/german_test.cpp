// SPDX-License-Identifier: GPL-3.0-or-later
// What a German window shows of the engine's messages: German, with its own controls in place of options.
#include "driver.h"
#include "test_main.h"

#include "document/language.h"
#include "samples/analytic_surfaces.h"
#include "support/english_words.h"

#include <QComboBox>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <functional>
#include <random>
#include <set>

using namespace loopmend;
using namespace loopmend::testing;

namespace {

TriangleSoup open_ball(int level) {
  return cut(make_icosphere(level), [](const Vec3& p) { return p.z() > 0.8; });
}

void add(TriangleSoup& soup, const TriangleSoup& more, const std::function<Vec3(const Vec3&)>& place) {
  const int first = static_cast<int>(soup.points.size());
  for (const Vec3& p : more.points) soup.points.push_back(place(p));
  for (const Triangle& t : more.triangles) soup.triangles.push_back({first + t[0], first + t[1], first + t[2]});
}

/// With a triangle by itself, whose boundary is no hole.
TriangleSoup ball_with_fragment() {
  TriangleSoup soup = open_ball(3);
  TriangleSoup fragment;
  fragment.points = {Vec3(3, 0, 0), Vec3(4, 0, 0), Vec3(3, 1, 0)};
  fragment.triangles = {{0, 1, 2}};
  add(soup, fragment, [](const Vec3& p) { return p; });
  return soup;
}

/// With a needle through its hole, which any patch cuts.
TriangleSoup ball_with_needle() {
  TriangleSoup soup = open_ball(3);
  add(soup, make_icosphere(1), [](const Vec3& p) { return Vec3(0.1 * p.x(), 0.1 * p.y(), 0.9 + p.z()); });
  return soup;
}

/// With relief as high as a quarter of an edge.
TriangleSoup rough_ball() {
  TriangleSoup soup = open_ball(4);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> height(-0.02, 0.02);
  for (Vec3& p : soup.points) p *= 1 + height(random);
  return soup;
}

/// Every text of the window that has English words or options in it.
QString english_texts(MainWindow& window) {
  QStringList found;
  for (const QObject* object : window.findChildren<QObject*>())
    for (const QString& text : texts_of(*object))
      if (const QStringList words = loopmend::test::english_in(text); !words.isEmpty())
        found << QStringLiteral("%1: %2 [%3]").arg(object->objectName(), text, words.join(QLatin1Char(' ')));
  return found.join(QLatin1Char('\n'));
}

}  // namespace

class GermanTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() { install_language(QStringLiteral("de")); }
  void cleanup() { install_language(QStringLiteral("en")); }
  void no_english_message_is_shown_data();
  void no_english_message_is_shown();
  void a_file_that_cannot_be_read_is_told_in_german();

 private:
  QString file(const QString& name, const TriangleSoup& soup) { return scan_file(folder_, name, soup); }
  QTemporaryDir folder_;
};

void GermanTest::no_english_message_is_shown_data() {
  QTest::addColumn<QString>("path");
  QTest::addColumn<QString>("button");
  QTest::addColumn<int>("boundary");
  QTest::addColumn<QString>("told");
  const QString fragment = file(QStringLiteral("fragment.ply"), ball_with_fragment());
  const QString needle = file(QStringLiteral("needle.ply"), ball_with_needle());
  const QString rough = file(QStringLiteral("rough.ply"), rough_ball());
  QTest::newRow("no hole") << fragment << QStringLiteral("fill") << 0 << QStringLiteral("eines einzelnen Dreiecks");
  QTest::newRow("cannot be filled") << needle << QStringLiteral("fillAndSmooth") << 0
                                    << QStringLiteral("nicht versucht, kann aber helfen");
  QTest::newRow("rough") << rough << QStringLiteral("fillAndSmooth") << 0
                         << QStringLiteral("mit dem Rand \u201eExakt\u201c l\u00e4uft der Fluss selbst");
  QTest::newRow("rough, robust fairing") << rough << QStringLiteral("fillAndSmooth") << 2
                                         << QStringLiteral("obuste Gl\u00e4ttung statt des Flusses");
}

void GermanTest::no_english_message_is_shown() {
  QFETCH(QString, path);
  QFETCH(QString, button);
  QFETCH(int, boundary);
  QFETCH(QString, told);
  Shown window({path});
  std::set<int> all;
  for (int loop = 0; loop < window.document().loop_count(); ++loop) all.insert(loop);
  window.selection().select(all);
  part<QComboBox>(window, "boundary")->setCurrentIndex(boundary);
  press(window, button.toLatin1().constData());
  QVERIFY(wait_idle(window));
  settle();
  const QString english = english_texts(window);
  QVERIFY2(english.isEmpty(), qPrintable(english));
  QStringList places;  // the log, and the state of the hole
  for (const QObject* object : window.findChildren<QObject*>())
    if (texts_of(*object).join(QLatin1Char('\n')).contains(told)) places << object->objectName();
  QVERIFY2(places.contains(QStringLiteral("log")), qPrintable(places.join(QLatin1Char(' '))));
}

void GermanTest::a_file_that_cannot_be_read_is_told_in_german() {
  Shown window({sample_file(folder_)});
  const QString path = folder_.filePath(QStringLiteral("bad.ply"));
  QFile bad(path);
  QVERIFY(bad.open(QIODevice::WriteOnly));
  bad.write("ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nend_header\n0 0 nonsense\n");
  bad.close();
  window.open(path);
  QVERIFY(wait_idle(window));
  settle();
  const QString english = english_texts(window);
  QVERIFY2(english.isEmpty(), qPrintable(english));
}

std::unique_ptr<QObject> loopmend::testing::make_test() { return std::make_unique<GermanTest>(); }

#include "german_test.moc"
