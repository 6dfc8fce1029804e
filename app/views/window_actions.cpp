// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/window_actions.h"

#include "panels/icons.h"

#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QToolBar>
#include <QToolButton>

#include <map>

namespace loopmend {
namespace {

struct Spec {
  const char* name;
  const char* text;
  const char* help;
  const char* keys;  ///< several are separated by "; "; the first is shown
  const char* icon;  ///< in resources/icons; may be null
  enum class Kind { plain, toggle, choice, up_choice, navigation_choice } kind = Kind::plain;
};

constexpr auto toggle = Spec::Kind::toggle;
constexpr auto choice = Spec::Kind::choice;
constexpr auto up_choice = Spec::Kind::up_choice;
constexpr auto navigation_choice = Spec::Kind::navigation_choice;

const Spec specs[] = {
    {"open", QT_TRANSLATE_NOOP("loopmend::WindowActions", "&Open\u2026"),
     QT_TRANSLATE_NOOP("loopmend::WindowActions", "Open a scan or a session"), "Ctrl+O", "open"},
    {"add", QT_TRANSLATE_NOOP("loopmend::WindowActions", "&Add to the scene\u2026"),
     QT_TRANSLATE_NOOP("loopmend::WindowActions", "Open further scans beside the present ones"), "Ctrl+Shift+O",
     nullptr},
    {"sample", QT_TRANSLATE_NOOP("loopmend::WindowActions", "Open the sa&mple"),
     QT_TRANSLATE_NOOP("loopmend::WindowActions", "Open a small made-up scan with five holes"), "", nullptr},
    {"saveSession", QT_TRANSLATE_NOOP("loopmend::WindowActions", "&Save session"),
     QT_TRANSLATE_NOOP("loopmend::WindowActions", "Keep scans and patches as they are, to go on another day"), "Ctrl+S",
     "save"},
    {"saveSessionAs", QT_TRANSLATE_NOOP("loopmend::WindowActions", "Save session &as\u2026"),
     QT_TRANSLATE_NOOP("loopmend::WindowActions", "Save the session under another name"), "Ctrl+Shift+S", nullptr},
    {"export", QT_TRANSLATE_NOOP("loopmend::WindowActions", "&Export\u2026"),
     QT_TRANSLATE_NOOP("loopmend::WindowActions", "Write scan and patches to a mesh file"), "Ctrl+E", "export"},
    {"screenshot", QT_TRANSLATE_NOOP("loopmend::WindowActions", "S&creenshot\u2026"),
     QT_TRANSLATE_NOOP("loopmend::WindowActions", "Write the picture to a PNG file"), "F12", "camera"},
    {"film", QT_TRANSLATE_NOOP("loopmend::WindowActions", "Export fil&m\u2026"),
     QT_TRANSLATE_NOOP("loopmend::WindowActions",
                       "Write the flow on the selected patches, or on all, as a film (animated GIF)"),
     "", nullptr},
    {"report", QT_TRANSLATE_NOOP("loopmend::WindowActions", "Write re&port\u2026"),
     QT_TRANSLATE_NOOP("loopmend::WindowActions",
                       "Write a page with a picture of each patch, its verdict and what was added (HTML or PDF)"),
     "", nullptr},
    {"quit", QT_TRANSLATE_NOOP("loopmend::WindowActions", "&Quit"),
     QT_TRANSLATE_NOOP("loopmend::WindowActions", "Close the window"), "Ctrl+Q", nullptr},
    {"undo", QT_TRANSLATE_NOOP("loopmend::WindowActions", "&Undo"),
     QT_TRANSLATE_NOOP("loopmend::WindowActions", "Take back the last change"), "Ctrl+Z", "undo"},
    {"redo", QT_TRANSLATE_NOOP("loopmend::WindowActions", "&Redo"),
     QT_TRANSLATE_NOOP("loopmend::WindowActions", "Do it again"), "Ctrl+Y; Ctrl+Shift+Z", "redo"},
    {"selectAll", QT_TRANSLATE_NOOP("loopmend::WindowActions", "Select &all holes"),
     QT_TRANSLATE_NOOP("loopmend::WindowActions", "Select every hole"), "Ctrl+A", nullptr},
    {"nextHole", QT_TRANSLATE_NOOP("loopmend::WindowActions", "&Next hole"),
     QT_TRANSLATE_NOOP("loopmend::WindowActions", "Select the next hole of the table and fly there"), "N", nullptr},
    {"nextToLookAt", QT_TRANSLATE_NOOP("loopmend::WindowActions", "Next to &look at"),
     QT_TRANSLATE_NOOP("loopmend::WindowActions",
                       "Select the next hole whose patch has a fault or a doubt, or that stayed open, and fly there"),
     "L", nullptr},
    {"previousHole", QT_TRANSLATE_NOOP("loopmend::WindowActions", "&Previous hole"),
     QT_TRANSLATE_NOOP("loopmend::WindowActions", "Select the hole before and fly there"), "Shift+N", nullptr},
    {"filter", QT_TRANSLATE_NOOP("loopmend::WindowActions", "&Filter holes"),
     QT_TRANSLATE_NOOP("loopmend::WindowActions", "Write into the filter of the holes table"), "Ctrl+L", nullptr},
    {"preferences", QT_TRANSLATE_NOOP("loopmend::WindowActions", "Pre&ferences\u2026"),
     QT_TRANSLATE_NOOP("loopmend::WindowActions", "Language, colours, memory, recovery"), "Ctrl+,", nullptr},
    {"curvature", QT_TRANSLATE_NOOP("loopmend::WindowActions", "&Mean curvature"),
     QT_TRANSLATE_NOOP("loopmend::WindowActions", "Colour by mean curvature H"), "1", "curvature", choice},
    {"gaussian", QT_TRANSLATE_NOOP("loopmend::WindowActions", "&Gaussian curvature"),
     QT_TRANSLATE_NOOP("loopmend::WindowActions", "Colour by Gaussian curvature K"), "2", "gaussian", choice},
    {"plain", QT_TRANSLATE_NOOP("loopmend::WindowActions", "&Plain"),
     QT_TRANSLATE_NOOP("loopmend::WindowActions", "One colour; patches in another"), "3", "plain", choice},
    {"zebra", QT_TRANSLATE_NOOP("loopmend::WindowActions", "&Zebra"),
     QT_TRANSLATE_NOOP("loopmend::WindowActions", "Reflected stripes: kinks show where tangents or curvature jump"),
     "4", "zebra", choice},
    {"isophotes", QT_TRANSLATE_NOOP("loopmend::WindowActions", "&Isophotes"),
     QT_TRANSLATE_NOOP("loopmend::WindowActions", "Bands of equal brightness"), "5", "isophotes", choice},
    {"scanColors", QT_TRANSLATE_NOOP("loopmend::WindowActions", "&Scan colours"),
     QT_TRANSLATE_NOOP("loopmend::WindowActions", "The scan's own colours or texture"), "6", "palette", choice},
    {"deviation", QT_TRANSLATE_NOOP("loopmend::WindowActions", "&Likely error"),
     QT_TRANSLATE_NOOP("loopmend::WindowActions", "Colour patches by how far each point is likely from what was there"),
     "7", "deviation", choice},
    {"wireframe", QT_TRANSLATE_NOOP("loopmend::WindowActions", "&Wireframe"),
     QT_TRANSLATE_NOOP("loopmend::WindowActions", "Draw the triangles' edges"), "W", "wireframe", toggle},
    {"seams", QT_TRANSLATE_NOOP("loopmend::WindowActions", "&Boundaries and seams"),
     QT_TRANSLATE_NOOP("loopmend::WindowActions", "Draw boundaries and seams as lines"), "M", "seams", toggle},
    {"frame", QT_TRANSLATE_NOOP("loopmend::WindowActions", "&Frame everything"),
     QT_TRANSLATE_NOOP("loopmend::WindowActions", "See the whole scene"), "F", "frame"},
    {"orthographic", QT_TRANSLATE_NOOP("loopmend::WindowActions", "&Orthographic"),
     QT_TRANSLATE_NOOP("loopmend::WindowActions", "Without perspective: what is parallel stays so"), "O", nullptr,
     toggle},
    {"clip", QT_TRANSLATE_NOOP("loopmend::WindowActions", "C&lipping plane"),
     QT_TRANSLATE_NOOP("loopmend::WindowActions", "Cut the surfaces open across the line of sight, to see the inside"),
     "X", nullptr, toggle},
    {"hidePiece", QT_TRANSLATE_NOOP("loopmend::WindowActions", "&Hide piece"),
     QT_TRANSLATE_NOOP("loopmend::WindowActions",
                       "Hide the piece under the mouse, or those of the selected holes; it is filled and exported "
                       "as before"),
     "H", nullptr},
    {"isolatePiece", QT_TRANSLATE_NOOP("loopmend::WindowActions", "&Isolate piece"),
     QT_TRANSLATE_NOOP("loopmend::WindowActions", "Hide all other pieces"), "Shift+H", nullptr},
    {"showPieces", QT_TRANSLATE_NOOP("loopmend::WindowActions", "Sho&w all pieces"),
     QT_TRANSLATE_NOOP("loopmend::WindowActions", "Show everything that was hidden"), "Ctrl+H", nullptr},
    {"lookFront", QT_TRANSLATE_NOOP("loopmend::WindowActions", "&Front"),
     QT_TRANSLATE_NOOP("loopmend::WindowActions", "See everything from the front"), "Ctrl+1", nullptr},
    {"lookBack", QT_TRANSLATE_NOOP("loopmend::WindowActions", "&Back"),
     QT_TRANSLATE_NOOP("loopmend::WindowActions", "See everything from the back"), "Ctrl+2", nullptr},
    {"lookLeft", QT_TRANSLATE_NOOP("loopmend::WindowActions", "&Left"),
     QT_TRANSLATE_NOOP("loopmend::WindowActions", "See everything from the left"), "Ctrl+3", nullptr},
    {"lookRight", QT_TRANSLATE_NOOP("loopmend::WindowActions", "&Right"),
     QT_TRANSLATE_NOOP("loopmend::WindowActions", "See everything from the right"), "Ctrl+4", nullptr},
    {"lookTop", QT_TRANSLATE_NOOP("loopmend::WindowActions", "&Top"),
     QT_TRANSLATE_NOOP("loopmend::WindowActions", "See everything from above"), "Ctrl+5", nullptr},
    {"lookBottom", QT_TRANSLATE_NOOP("loopmend::WindowActions", "B&ottom"),
     QT_TRANSLATE_NOOP("loopmend::WindowActions", "See everything from below"), "Ctrl+6", nullptr},
    {"upByShape", QT_TRANSLATE_NOOP("loopmend::WindowActions", "&As the shape suggests"),
     QT_TRANSLATE_NOOP("loopmend::WindowActions", "Up is z where the scan is tallest along z, else y"), "", nullptr,
     up_choice},
    {"upX", QT_TRANSLATE_NOOP("loopmend::WindowActions", "&X up"),
     QT_TRANSLATE_NOOP("loopmend::WindowActions", "The x axis points upwards"), "", nullptr, up_choice},
    {"upMinusX", QT_TRANSLATE_NOOP("loopmend::WindowActions", "&\u2212X up"),
     QT_TRANSLATE_NOOP("loopmend::WindowActions", "The x axis points downwards"), "", nullptr, up_choice},
    {"upY", QT_TRANSLATE_NOOP("loopmend::WindowActions", "&Y up"),
     QT_TRANSLATE_NOOP("loopmend::WindowActions", "The y axis points upwards"), "", nullptr, up_choice},
    {"upMinusY", QT_TRANSLATE_NOOP("loopmend::WindowActions", "\u2212Y u&p"),
     QT_TRANSLATE_NOOP("loopmend::WindowActions", "The y axis points downwards"), "", nullptr, up_choice},
    {"upZ", QT_TRANSLATE_NOOP("loopmend::WindowActions", "&Z up"),
     QT_TRANSLATE_NOOP("loopmend::WindowActions", "The z axis points upwards"), "", nullptr, up_choice},
    {"upMinusZ", QT_TRANSLATE_NOOP("loopmend::WindowActions", "\u2212Z &up"),
     QT_TRANSLATE_NOOP("loopmend::WindowActions", "The z axis points downwards"), "", nullptr, up_choice},
    {"navigateLoopmend", QT_TRANSLATE_NOOP("loopmend::WindowActions", "&Loopmend navigation"),
     QT_TRANSLATE_NOOP("loopmend::WindowActions", "Drag with the left button to turn"), "", nullptr, navigation_choice},
    {"navigateBlender", QT_TRANSLATE_NOOP("loopmend::WindowActions", "&Blender navigation"),
     QT_TRANSLATE_NOOP("loopmend::WindowActions",
                       "Drag with the middle button to turn about the up axis, with Shift to move"),
     "", nullptr, navigation_choice},
    {"navigateMeshLab", QT_TRANSLATE_NOOP("loopmend::WindowActions", "&MeshLab navigation"),
     QT_TRANSLATE_NOOP("loopmend::WindowActions",
                       "Drag with the left button to turn, with Ctrl to move, with Shift to zoom"),
     "", nullptr, navigation_choice},
    {"navigateCad", QT_TRANSLATE_NOOP("loopmend::WindowActions", "&CAD navigation"),
     QT_TRANSLATE_NOOP("loopmend::WindowActions",
                       "Drag with the middle button to turn, with Ctrl to move, with Shift to zoom"),
     "", nullptr, navigation_choice},
    {"probe", QT_TRANSLATE_NOOP("loopmend::WindowActions", "&Values in the middle"),
     QT_TRANSLATE_NOOP("loopmend::WindowActions", "Show the values at the middle of the picture"), "P", nullptr},
    {"fillAction", QT_TRANSLATE_NOOP("loopmend::WindowActions", "&Fill and smooth"),
     QT_TRANSLATE_NOOP("loopmend::WindowActions", "Close the selected holes, or all, by fair patches"), "Ctrl+F; T",
     nullptr},
    {"initialAction", QT_TRANSLATE_NOOP("loopmend::WindowActions", "Initial &patch only"),
     QT_TRANSLATE_NOOP("loopmend::WindowActions", "Close the selected holes, or all; no flow runs yet"), "Ctrl+Shift+F",
     nullptr},
    {"prepareAction", QT_TRANSLATE_NOOP("loopmend::WindowActions", "Prepare the sca&n"),
     QT_TRANSLATE_NOOP("loopmend::WindowActions",
                       "Stitch, repair and trim where the scan needs that to be filled, and change nothing else"),
     "", nullptr},
    {"trimAction", QT_TRANSLATE_NOOP("loopmend::WindowActions", "Tri&m the boundary"),
     QT_TRANSLATE_NOOP("loopmend::WindowActions",
                       "Remove bad triangles at the boundaries of the selected holes, or of all"),
     "", nullptr},
    {"trimCrossingAction", QT_TRANSLATE_NOOP("loopmend::WindowActions", "Trim crossin&g triangles"),
     QT_TRANSLATE_NOOP("loopmend::WindowActions",
                       "At the boundaries of the selected holes, or of all, remove only the triangles that run through "
                       "the surface: no patch could be valid there"),
     "", nullptr},
    {"eraseRingAction", QT_TRANSLATE_NOOP("loopmend::WindowActions", "&Erase a ring of faces"),
     QT_TRANSLATE_NOOP("loopmend::WindowActions",
                       "Widen the selected holes by one ring of faces, where they are ragged; once more for another"),
     "", nullptr},
    {"stitchAction", QT_TRANSLATE_NOOP("loopmend::WindowActions", "Stitc&h cracks"),
     QT_TRANSLATE_NOOP("loopmend::WindowActions", "Zip boundaries that nearly coincide"), "", nullptr},
    {"repairAction", QT_TRANSLATE_NOOP("loopmend::WindowActions", "Repai&r\u2026"),
     QT_TRANSLATE_NOOP("loopmend::WindowActions", "See the defects of the scan, and repair them"), "", nullptr},
    {"stepAction", QT_TRANSLATE_NOOP("loopmend::WindowActions", "&Step"),
     QT_TRANSLATE_NOOP("loopmend::WindowActions", "Take one time step"), "S", nullptr},
    {"runAction", QT_TRANSLATE_NOOP("loopmend::WindowActions", "&Run or pause"),
     QT_TRANSLATE_NOOP("loopmend::WindowActions", "Smooth, every step shown for a moment"), "Space", nullptr},
    {"playAction", QT_TRANSLATE_NOOP("loopmend::WindowActions", "&Play or pause the states"),
     QT_TRANSLATE_NOOP("loopmend::WindowActions", "Show the recorded states of the selected patches one after another"),
     "Shift+Space", nullptr},
    {"nextStateAction", QT_TRANSLATE_NOOP("loopmend::WindowActions", "Ne&xt state"),
     QT_TRANSLATE_NOOP("loopmend::WindowActions", "One recorded state further; after the last, the first"), ".",
     nullptr},
    {"compare", QT_TRANSLATE_NOOP("loopmend::WindowActions", "&Compare flows\u2026"),
     QT_TRANSLATE_NOOP("loopmend::WindowActions", "Several flows from one start, side by side"), "C", "compare"},
    {"toolRegionAction", QT_TRANSLATE_NOOP("loopmend::WindowActions", "&Region"),
     QT_TRANSLATE_NOOP("loopmend::WindowActions", "Make a region of a surface smooth, its neighborhood held"), "R",
     nullptr},
    {"toolPointsAction", QT_TRANSLATE_NOOP("loopmend::WindowActions", "Surface through &points"),
     QT_TRANSLATE_NOOP("loopmend::WindowActions", "A smooth surface through the vertices of a polyhedron"), "I",
     nullptr},
    {"toolBlendAction", QT_TRANSLATE_NOOP("loopmend::WindowActions", "&Blend boundaries"),
     QT_TRANSLATE_NOOP("loopmend::WindowActions", "Join two or more boundaries by one patch"), "B", nullptr},
    {"toolBridgeAction", QT_TRANSLATE_NOOP("loopmend::WindowActions", "Brid&ge"),
     QT_TRANSLATE_NOOP("loopmend::WindowActions", "Part a hole into two by a strip between two of its vertices"), "G",
     nullptr},
    {"toolFillPartAction", QT_TRANSLATE_NOOP("loopmend::WindowActions", "Fill a &part\u2026"),
     QT_TRANSLATE_NOOP("loopmend::WindowActions", "Click two vertices of a hole; the part between them is filled"),
     "Shift+G", nullptr},
    {"partAction", QT_TRANSLATE_NOOP("loopmend::WindowActions", "Part where it to&uches itself"),
     QT_TRANSLATE_NOOP("loopmend::WindowActions",
                       "Part the boundary at vertices that it passes twice: what hangs there becomes an island"),
     "", nullptr},
    {"toolEdgesAction", QT_TRANSLATE_NOOP("loopmend::WindowActions", "Sharp &edges\u2026"),
     QT_TRANSLATE_NOOP("loopmend::WindowActions", "See, remove or draw the sharp edges that run on across holes"),
     "Shift+E", nullptr},
    {"toolMirrorAction", QT_TRANSLATE_NOOP("loopmend::WindowActions", "&Mirror image\u2026"),
     QT_TRANSLATE_NOOP("loopmend::WindowActions", "See the plane of symmetry, and what its image would fill"),
     "Shift+M", nullptr},
    {"toolMeasureAction", QT_TRANSLATE_NOOP("loopmend::WindowActions", "&Distance"),
     QT_TRANSLATE_NOOP("loopmend::WindowActions", "The distance between two vertices"), "D", nullptr},
    {"candidatesAction", QT_TRANSLATE_NOOP("loopmend::WindowActions", "&Other patches\u2026"),
     QT_TRANSLATE_NOOP("loopmend::WindowActions",
                       "Compute other patches for the selected hole, see them side by side, take one"),
     "V", nullptr},
    {"acceptAction", QT_TRANSLATE_NOOP("loopmend::WindowActions", "&Accept or open again"),
     QT_TRANSLATE_NOOP("loopmend::WindowActions", "Keep the patch as it is, or take it up again"), "A", nullptr},
    {"rejectAction", QT_TRANSLATE_NOOP("loopmend::WindowActions", "&Discard"),
     QT_TRANSLATE_NOOP("loopmend::WindowActions", "Throw the patch away; the hole is open again"), "Del", nullptr},
    {"copyAction", QT_TRANSLATE_NOOP("loopmend::WindowActions", "&Copy command line"),
     QT_TRANSLATE_NOOP("loopmend::WindowActions", "Copy the commands that do the same"), "Ctrl+Shift+C", nullptr},
    {"cancelAction", QT_TRANSLATE_NOOP("loopmend::WindowActions", "Ca&ncel"),
     QT_TRANSLATE_NOOP("loopmend::WindowActions", "Stop at once; or close a message; or select nothing"), "Esc",
     nullptr},
    {"help", QT_TRANSLATE_NOOP("loopmend::WindowActions", "&Help"),
     QT_TRANSLATE_NOOP("loopmend::WindowActions", "How things are done, with pictures"), "F1", nullptr},
    {"palette", QT_TRANSLATE_NOOP("loopmend::WindowActions", "Find a &command\u2026"),
     QT_TRANSLATE_NOOP("loopmend::WindowActions", "Find any command by typing, and run it"), "Ctrl+K", nullptr},
    {"shortcuts", QT_TRANSLATE_NOOP("loopmend::WindowActions", "&Keyboard shortcuts"),
     QT_TRANSLATE_NOOP("loopmend::WindowActions", "All keys on one sheet"), "?", nullptr},
    {"navigationSheet", QT_TRANSLATE_NOOP("loopmend::WindowActions", "&What differs\u2026"),
     QT_TRANSLATE_NOOP("loopmend::WindowActions", "What the mouse does in each style of navigation, on one sheet"), "",
     nullptr},
    {"about", QT_TRANSLATE_NOOP("loopmend::WindowActions", "A&bout Loopmend"),
     QT_TRANSLATE_NOOP("loopmend::WindowActions", "Version and licence"), "", nullptr},
};

QList<QKeySequence> keys_of(const char* text) {
  QList<QKeySequence> keys;
  for (const QString& word : QString::fromLatin1(text).split(QStringLiteral("; "), Qt::SkipEmptyParts))
    keys << QKeySequence(word);
  return keys;
}

}  // namespace

WindowActions::WindowActions(QMainWindow* window) : QObject(window), window_(window) {
  std::map<Spec::Kind, QActionGroup*> choices;
  for (Spec::Kind kind : {choice, up_choice, navigation_choice}) choices[kind] = new QActionGroup(this);
  for (const Spec& spec : specs) {
    auto* action = new QAction(tr(spec.text), window);
    action->setObjectName(QLatin1String(spec.name));
    action->setShortcuts(keys_of(spec.keys));
    const QString shown = action->shortcut().toString(QKeySequence::NativeText);
    action->setToolTip(shown.isEmpty() ? tr(spec.help) : tr("%1 (%2)").arg(tr(spec.help), shown));
    action->setStatusTip(tr(spec.help));
    action->setCheckable(spec.kind != Spec::Kind::plain);
    if (const auto group = choices.find(spec.kind); group != choices.end()) group->second->addAction(action);
    window->addAction(action);
  }
}

QAction* WindowActions::operator[](const char* name) const {
  return window_->findChild<QAction*>(QLatin1String(name), Qt::FindDirectChildrenOnly);
}

QMenu* WindowActions::make_hole_menu() {
  auto* menu = new QMenu(window_);
  menu->setObjectName(QStringLiteral("holeMenu"));
  menu->setAttribute(Qt::WA_DeleteOnClose);
  for (const char* name : {"fillAction",
                           "initialAction",
                           "runAction",
                           "-",
                           "toolFillPartAction",
                           "-",
                           "prepareAction",
                           "trimAction",
                           "trimCrossingAction",
                           "eraseRingAction",
                           "stitchAction",
                           "repairAction",
                           "toolBridgeAction",
                           "partAction",
                           "-",
                           "candidatesAction",
                           "acceptAction",
                           "rejectAction",
                           "-",
                           "compare",
                           "copyAction"}) {
    if (*name == '-')
      menu->addSeparator();
    else
      menu->addAction((*this)[name]);
  }
  return menu;
}

QMenu* WindowActions::add_menu(const QString& title, std::initializer_list<const char*> names, QMenu* in) {
  QMenu* menu = in ? new QMenu(title, in) : window_->menuBar()->addMenu(title);
  Group group{QString(title).remove(QLatin1Char('&')), {}};
  for (const char* name : names) {
    if (*name == '-') {
      menu->addSeparator();
    } else {
      menu->addAction((*this)[name]);
      group.actions << (*this)[name];
    }
  }
  groups_.push_back(std::move(group));
  return menu;
}

void WindowActions::build_menus(const QList<QAction*>& docks) {
  QMenu* file = add_menu(tr("&File"), {"open", "add", "sample", "-", "saveSession", "saveSessionAs", "-", "export",
                                       "screenshot", "film", "report", "-", "quit"});
  recent_ = new QMenu(tr("Open &recent"), file);
  close_ = new QMenu(tr("C&lose"), file);
  file->insertMenu((*this)["sample"], recent_);
  file->insertMenu((*this)["quit"], close_);
  add_menu(tr("&Edit"), {"undo", "redo", "-", "selectAll", "nextHole", "previousHole", "nextToLookAt", "filter", "-",
                         "preferences"});
  QMenu* view = add_menu(
      tr("&View"), {"curvature", "gaussian",     "plain",      "zebra",      "isophotes",    "scanColors", "deviation",
                    "-",         "wireframe",    "seams",      "-",          "frame",        "lookFront",  "lookBack",
                    "lookLeft",  "lookRight",    "lookTop",    "lookBottom", "orthographic", "clip",       "-",
                    "hidePiece", "isolatePiece", "showPieces", "-",          "probe",        "-"});
  view->addActions(docks);
  QMenu* up =
      add_menu(tr("&Up axis"), {"upByShape", "-", "upX", "upMinusX", "upY", "upMinusY", "upZ", "upMinusZ"}, view);
  QMenu* navigation =
      add_menu(tr("&Navigation"),
               {"navigateLoopmend", "navigateBlender", "navigateMeshLab", "navigateCad", "-", "navigationSheet"}, view);
  for (QMenu* menu : {up, navigation}) view->insertMenu((*this)["orthographic"], menu);
  add_menu(tr("&Patch"), {"fillAction",
                          "initialAction",
                          "-",
                          "prepareAction",
                          "trimAction",
                          "trimCrossingAction",
                          "eraseRingAction",
                          "stitchAction",
                          "partAction",
                          "repairAction",
                          "-",
                          "runAction",
                          "stepAction",
                          "playAction",
                          "nextStateAction",
                          "-",
                          "compare",
                          "-",
                          "candidatesAction",
                          "acceptAction",
                          "rejectAction",
                          "copyAction",
                          "-",
                          "cancelAction"});
  add_menu(tr("&Tools"), {"compare", "-", "toolRegionAction", "toolPointsAction", "toolBlendAction", "toolBridgeAction",
                          "toolFillPartAction", "toolEdgesAction", "toolMirrorAction", "-", "toolMeasureAction"});
  add_menu(tr("&Help"), {"help", "palette", "shortcuts", "-", "about"});
}

void WindowActions::build_toolbar() {
  QToolBar* bar = window_->addToolBar(tr("Tools"));
  bar->setObjectName(QStringLiteral("tools"));
  bar->setMovable(false);
  bar->setIconSize(QSize(20, 20));
  bar->setContextMenuPolicy(Qt::PreventContextMenu);
  const auto group = [this, bar](std::initializer_list<const char*> names, Qt::ToolButtonStyle style) {
    for (const char* name : names) {
      QAction* action = (*this)[name];
      bar->addAction(action);
      auto* button = qobject_cast<QToolButton*>(bar->widgetForAction(action));
      button->setObjectName(QLatin1String(name) + QStringLiteral("Button"));
      button->setToolButtonStyle(style);
      button->setFocusPolicy(Qt::TabFocus);
      button->setAccessibleName(QString(action->text()).remove(QLatin1Char('&')));
      button->setAccessibleDescription(action->toolTip());
    }
    bar->addSeparator();
  };
  group({"open", "saveSession", "export"}, Qt::ToolButtonTextBesideIcon);
  group({"undo", "redo"}, Qt::ToolButtonIconOnly);
  group({"curvature", "gaussian", "plain", "zebra", "isophotes", "scanColors", "deviation"},
        Qt::ToolButtonTextBesideIcon);
  group({"wireframe", "seams", "frame", "screenshot"}, Qt::ToolButtonIconOnly);
  group({"compare"}, Qt::ToolButtonTextBesideIcon);
  const auto short_name = [this](const char* name, const QString& text) { (*this)[name]->setIconText(text); };
  short_name("open", tr("Open"));
  short_name("saveSession", tr("Save"));
  short_name("export", tr("Export"));
  short_name("compare", tr("Compare"));
  short_name("curvature", tr("H"));
  short_name("gaussian", tr("K"));
  short_name("scanColors", tr("Colours"));
}

void WindowActions::update_icons() {
  const QColor ink = window_->palette().color(QPalette::ButtonText);
  for (const Spec& spec : specs)
    if (spec.icon) (*this)[spec.name]->setIcon(icon(spec.icon, ink));
}

}  // namespace loopmend
