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

QList<QKeySequence> keys_of(const char* text) {
  QList<QKeySequence> keys;
  for (const QString& word : QString::fromLatin1(text).split(QStringLiteral("; "), Qt::SkipEmptyParts))
    keys << QKeySequence(word);
  return keys;
}

/// A separator for each null.
void put(QMenu* menu, const QList<QAction*>& actions) {
  for (QAction* action : actions)
    if (action)
      menu->addAction(action);
    else
      menu->addSeparator();
}

constexpr char close_as_names[] = "closeAsAutomatic closeAsTangent closeAsFlat - closeAsBase";

}  // namespace

struct WindowActions::Spec {
  const char* name;
  const char* text;
  const char* help;
  const char* keys = "";       ///< several are separated by "; "; the first is shown
  const char* icon = nullptr;  ///< in resources/icons; may be null
  enum Kind { plain, toggle, choice, up_choice, navigation_choice, shape_choice } kind = plain;
};

/// In the order of the menus.
const std::vector<WindowActions::Spec>& WindowActions::specs() {
  static const std::vector<Spec> specs{
      {"open", QT_TR_NOOP("&Open\u2026"), QT_TR_NOOP("Open a scan or a session"), "Ctrl+O", "open"},
      {"add", QT_TR_NOOP("&Add to the scene\u2026"), QT_TR_NOOP("Open further scans beside the present ones"),
       "Ctrl+Shift+O"},
      {"sample", QT_TR_NOOP("Open the sa&mple"), QT_TR_NOOP("Open a small made-up scan with five holes")},
      {"saveSession", QT_TR_NOOP("&Save session"),
       QT_TR_NOOP("Keep scans and patches as they are, to go on another day"), "Ctrl+S", "save"},
      {"saveSessionAs", QT_TR_NOOP("Save session &as\u2026"), QT_TR_NOOP("Save the session under another name"),
       "Ctrl+Shift+S"},
      {"export", QT_TR_NOOP("&Export\u2026"), QT_TR_NOOP("Write scan and patches to a mesh file"), "Ctrl+E", "export"},
      {"screenshot", QT_TR_NOOP("S&creenshot\u2026"), QT_TR_NOOP("Write the picture to a PNG file"), "F12", "camera"},
      {"film", QT_TR_NOOP("Export fil&m\u2026"),
       QT_TR_NOOP("Write the flow on the selected patches, or on all, as a film (animated GIF)")},
      {"report", QT_TR_NOOP("Write re&port\u2026"),
       QT_TR_NOOP("Write a page with a picture of each patch, its verdict and what was added (HTML or PDF)")},
      {"batch", QT_TR_NOOP("&Fill a folder\u2026"),
       QT_TR_NOOP("Fill every scan of a folder, with a page of the results, as the command loopmend batch does")},
      {"quit", QT_TR_NOOP("&Quit"), QT_TR_NOOP("Close the window"), "Ctrl+Q"},
      {"undo", QT_TR_NOOP("&Undo"), QT_TR_NOOP("Take back the last change"), "Ctrl+Z", "undo"},
      {"redo", QT_TR_NOOP("&Redo"), QT_TR_NOOP("Do it again"), "Ctrl+Y; Ctrl+Shift+Z", "redo"},
      {"selectAll", QT_TR_NOOP("Select &all holes"), QT_TR_NOOP("Select every hole"), "Ctrl+A"},
      {"nextHole", QT_TR_NOOP("&Next hole"), QT_TR_NOOP("Select the next hole of the table and fly there"), "N"},
      {"nextToLookAt", QT_TR_NOOP("Next to &look at"),
       QT_TR_NOOP("Select the next hole whose patch has a fault or a doubt, or that stayed open, and fly there"), "L"},
      {"previousHole", QT_TR_NOOP("&Previous hole"), QT_TR_NOOP("Select the hole before and fly there"), "Shift+N"},
      {"filter", QT_TR_NOOP("&Filter holes"), QT_TR_NOOP("Write into the filter of the holes table"), "Ctrl+L"},
      {"preferences", QT_TR_NOOP("Pre&ferences\u2026"), QT_TR_NOOP("Language, colours, memory, recovery"), "Ctrl+,"},
      {"curvature", QT_TR_NOOP("&Mean curvature"), QT_TR_NOOP("Colour by mean curvature H"), "1", "curvature",
       Spec::choice},
      {"gaussian", QT_TR_NOOP("&Gaussian curvature"), QT_TR_NOOP("Colour by Gaussian curvature K"), "2", "gaussian",
       Spec::choice},
      {"plain", QT_TR_NOOP("&Plain"), QT_TR_NOOP("One colour; patches in another"), "3", "plain", Spec::choice},
      {"zebra", QT_TR_NOOP("&Zebra"), QT_TR_NOOP("Reflected stripes: kinks show where tangents or curvature jump"), "4",
       "zebra", Spec::choice},
      {"isophotes", QT_TR_NOOP("&Isophotes"), QT_TR_NOOP("Bands of equal brightness"), "5", "isophotes", Spec::choice},
      {"scanColors", QT_TR_NOOP("&Scan colours"), QT_TR_NOOP("The scan's own colours or texture"), "6", "palette",
       Spec::choice},
      {"deviation", QT_TR_NOOP("&Likely error"),
       QT_TR_NOOP("Colour patches by how far each point is likely from what was there"), "7", "deviation",
       Spec::choice},
      {"wireframe", QT_TR_NOOP("&Wireframe"), QT_TR_NOOP("Draw the triangles' edges"), "W", "wireframe", Spec::toggle},
      {"seams", QT_TR_NOOP("&Boundaries and seams"), QT_TR_NOOP("Draw boundaries and seams as lines"), "M", "seams",
       Spec::toggle},
      {"tint", QT_TR_NOOP("&Tint on the patches"),
       QT_TR_NOOP("Draw patches greener than the scan; over the colours of curvature as a hatching"), "Shift+T",
       nullptr, Spec::toggle},
      {"frame", QT_TR_NOOP("&Frame everything"), QT_TR_NOOP("See the whole scene"), "F", "frame"},
      {"orthographic", QT_TR_NOOP("&Orthographic"), QT_TR_NOOP("Without perspective: what is parallel stays so"), "O",
       nullptr, Spec::toggle},
      {"clip", QT_TR_NOOP("C&lipping plane"),
       QT_TR_NOOP("Cut the surfaces open across the line of sight, to see the inside"), "X", nullptr, Spec::toggle},
      {"hidePiece", QT_TR_NOOP("&Hide component"),
       QT_TR_NOOP("Hide the component under the mouse, or those of the selected holes; it is filled and exported "
                  "as before"),
       "H"},
      {"isolatePiece", QT_TR_NOOP("&Isolate component"), QT_TR_NOOP("Hide all other components"), "Shift+H"},
      {"showPieces", QT_TR_NOOP("Sho&w all components"), QT_TR_NOOP("Show everything that was hidden"), "Ctrl+H"},
      {"lookFront", QT_TR_NOOP("&Front"), QT_TR_NOOP("See everything from the front"), "Ctrl+1"},
      {"lookBack", QT_TR_NOOP("&Back"), QT_TR_NOOP("See everything from the back"), "Ctrl+2"},
      {"lookLeft", QT_TR_NOOP("&Left"), QT_TR_NOOP("See everything from the left"), "Ctrl+3"},
      {"lookRight", QT_TR_NOOP("&Right"), QT_TR_NOOP("See everything from the right"), "Ctrl+4"},
      {"lookTop", QT_TR_NOOP("&Top"), QT_TR_NOOP("See everything from above"), "Ctrl+5"},
      {"lookBottom", QT_TR_NOOP("B&ottom"), QT_TR_NOOP("See everything from below"), "Ctrl+6"},
      {"upByShape", QT_TR_NOOP("&As the shape suggests"),
       QT_TR_NOOP("Up is z where the scan is tallest along z, else y"), "", nullptr, Spec::up_choice},
      {"upX", QT_TR_NOOP("&X up"), QT_TR_NOOP("The x axis points upwards"), "", nullptr, Spec::up_choice},
      {"upMinusX", QT_TR_NOOP("&\u2212X up"), QT_TR_NOOP("The x axis points downwards"), "", nullptr, Spec::up_choice},
      {"upY", QT_TR_NOOP("&Y up"), QT_TR_NOOP("The y axis points upwards"), "", nullptr, Spec::up_choice},
      {"upMinusY", QT_TR_NOOP("\u2212Y u&p"), QT_TR_NOOP("The y axis points downwards"), "", nullptr, Spec::up_choice},
      {"upZ", QT_TR_NOOP("&Z up"), QT_TR_NOOP("The z axis points upwards"), "", nullptr, Spec::up_choice},
      {"upMinusZ", QT_TR_NOOP("\u2212Z &up"), QT_TR_NOOP("The z axis points downwards"), "", nullptr, Spec::up_choice},
      {"navigateLoopmend", QT_TR_NOOP("&Loopmend navigation"), QT_TR_NOOP("Drag with the left button to turn"), "",
       nullptr, Spec::navigation_choice},
      {"navigateBlender", QT_TR_NOOP("&Blender navigation"),
       QT_TR_NOOP("Drag with the middle button to turn about the up axis, with Shift to move"), "", nullptr,
       Spec::navigation_choice},
      {"navigateMeshLab", QT_TR_NOOP("&MeshLab navigation"),
       QT_TR_NOOP("Drag with the left button to turn, with Ctrl to move, with Shift to zoom"), "", nullptr,
       Spec::navigation_choice},
      {"navigateCad", QT_TR_NOOP("&CAD navigation"),
       QT_TR_NOOP("Drag with the middle button to turn, with Ctrl to move, with Shift to zoom"), "", nullptr,
       Spec::navigation_choice},
      {"probe", QT_TR_NOOP("&Values in the middle"), QT_TR_NOOP("Show the values at the middle of the picture"), "P"},
      {"fillAction", QT_TR_NOOP("&Fill and smooth"), QT_TR_NOOP("Close the selected holes, or all, by fair patches"),
       "Ctrl+F; T"},
      {"initialAction", QT_TR_NOOP("Initial &patch only"),
       QT_TR_NOOP("Close the selected holes, or all; no flow runs yet"), "Ctrl+Shift+F"},
      {"closeAsAutomatic", QT_TR_NOOP("&Automatic"),
       QT_TR_NOOP("Close the selected holes as the options of the flow say"), "", nullptr, Spec::shape_choice},
      {"closeAsTangent", QT_TR_NOOP("&Tangent"),
       QT_TR_NOOP("Close the selected holes without a crease, whatever their curvature"), "", nullptr,
       Spec::shape_choice},
      {"closeAsFlat", QT_TR_NOOP("&Flat"), QT_TR_NOOP("Close the selected holes by a plane, or by a taut skin"), "",
       nullptr, Spec::shape_choice},
      {"closeAsBase", QT_TR_NOOP("&Base\u2026"),
       QT_TR_NOOP("Close the selected loop for a print: a straight wall to a plane below the surface")},
      {"prepareAction", QT_TR_NOOP("Prepare the sca&n"),
       QT_TR_NOOP("Stitch, repair and trim where the scan needs that to be filled, and change nothing else")},
      {"trimAction", QT_TR_NOOP("Tri&m the boundary"),
       QT_TR_NOOP("Remove bad triangles at the boundaries of the selected holes, or of all")},
      {"trimCrossingAction", QT_TR_NOOP("Trim crossin&g triangles"),
       QT_TR_NOOP("At the boundaries of the selected holes, or of all, remove only the triangles that run through "
                  "the surface: no patch could be valid there")},
      {"eraseRingAction", QT_TR_NOOP("&Erase a ring of faces"),
       QT_TR_NOOP("Widen the selected holes by one ring of faces, where they are ragged; once more for another")},
      {"stitchAction", QT_TR_NOOP("Stitc&h cracks"), QT_TR_NOOP("Zip boundaries that nearly coincide")},
      {"turnAroundAction", QT_TR_NOOP("Turn faces ar&ound"),
       QT_TR_NOOP("Turn the faces that look inward, in the scans of the selected holes or in all; where none does, "
                  "turn all faces")},
      {"repairAction", QT_TR_NOOP("Repai&r\u2026"), QT_TR_NOOP("See the defects of the scan, and repair them")},
      {"stepAction", QT_TR_NOOP("&Step"), QT_TR_NOOP("Take one time step"), "S"},
      {"runAction", QT_TR_NOOP("&Run or pause"), QT_TR_NOOP("Smooth, every step shown for a moment"), "Space"},
      {"playAction", QT_TR_NOOP("&Play or pause the states"),
       QT_TR_NOOP("Show the recorded states of the selected patches one after another"), "Shift+Space"},
      {"nextStateAction", QT_TR_NOOP("Ne&xt state"),
       QT_TR_NOOP("One recorded state further; after the last, the first"), "."},
      {"compare", QT_TR_NOOP("&Compare flows\u2026"), QT_TR_NOOP("Several flows from one start, side by side"), "C",
       "compare"},
      {"toolRegionAction", QT_TR_NOOP("&Region"),
       QT_TR_NOOP("Make a region of a surface smooth, its neighborhood held"), "R"},
      {"toolPointsAction", QT_TR_NOOP("Surface through &points"),
       QT_TR_NOOP("A smooth surface through the vertices of a polyhedron"), "I"},
      {"toolBlendAction", QT_TR_NOOP("&Blend boundaries"), QT_TR_NOOP("Join two or more boundaries by one patch"), "B"},
      {"toolBridgeAction", QT_TR_NOOP("Brid&ge"),
       QT_TR_NOOP("Part a hole into two by a strip between two of its vertices"), "G"},
      {"toolFillPartAction", QT_TR_NOOP("Fill a &part\u2026"),
       QT_TR_NOOP("Click two vertices of a hole; the part between them is filled"), "Shift+G"},
      {"partAction", QT_TR_NOOP("Part where it to&uches itself"),
       QT_TR_NOOP("Part the boundary at vertices that it passes twice: what hangs there becomes an island")},
      {"toolEdgesAction", QT_TR_NOOP("Sharp &edges\u2026"),
       QT_TR_NOOP("See, remove or draw the sharp edges that run on across holes"), "Shift+E"},
      {"toolMirrorAction", QT_TR_NOOP("&Mirror image\u2026"),
       QT_TR_NOOP("See the plane of symmetry, and what its image would fill"), "Shift+M"},
      {"toolCutAction", QT_TR_NOOP("Plane c&ut\u2026"),
       QT_TR_NOOP("Cut off one side of a plane, and close the section flat"), "Shift+X"},
      {"toolMeasureAction", QT_TR_NOOP("&Distance"), QT_TR_NOOP("The distance between two vertices"), "D"},
      {"candidatesAction", QT_TR_NOOP("&Other patches\u2026"),
       QT_TR_NOOP("Compute other patches for the selected hole, see them side by side, take one"), "V"},
      {"acceptAction", QT_TR_NOOP("&Accept or open again"), QT_TR_NOOP("Keep the patch as it is, or take it up again"),
       "A"},
      {"rejectAction", QT_TR_NOOP("&Discard"), QT_TR_NOOP("Throw the patch away; the hole is open again"), "Del"},
      {"copyAction", QT_TR_NOOP("&Copy command line"), QT_TR_NOOP("Copy the commands that do the same"),
       "Ctrl+Shift+C"},
      {"cancelAction", QT_TR_NOOP("Ca&ncel"), QT_TR_NOOP("Stop at once; or close a message; or select nothing"), "Esc"},
      {"help", QT_TR_NOOP("&Help"), QT_TR_NOOP("How things are done, with pictures"), "F1"},
      {"palette", QT_TR_NOOP("Find a &command\u2026"), QT_TR_NOOP("Find any command by typing, and run it"), "Ctrl+K"},
      {"shortcuts", QT_TR_NOOP("&Keyboard shortcuts"), QT_TR_NOOP("All keys on one sheet"), "?"},
      {"navigationSheet", QT_TR_NOOP("&What differs\u2026"),
       QT_TR_NOOP("What the mouse does in each style of navigation, on one sheet")},
      {"about", QT_TR_NOOP("A&bout Loopmend"), QT_TR_NOOP("Version and licence")},
  };
  return specs;
}

WindowActions::WindowActions(QMainWindow* window) : QObject(window), window_(window) {
  std::map<Spec::Kind, QActionGroup*> choices;
  for (const auto kind : {Spec::choice, Spec::up_choice, Spec::navigation_choice, Spec::shape_choice})
    choices[kind] = new QActionGroup(this);
  // Selected holes of several shapes have none in common.
  choices[Spec::shape_choice]->setExclusionPolicy(QActionGroup::ExclusionPolicy::ExclusiveOptional);
  for (const Spec& spec : specs()) {
    auto* action = new QAction(tr(spec.text), window);
    action->setObjectName(QLatin1String(spec.name));
    action->setShortcuts(keys_of(spec.keys));
    const QString shown = action->shortcut().toString(QKeySequence::NativeText);
    action->setToolTip(shown.isEmpty() ? tr(spec.help) : tr("%1 (%2)").arg(tr(spec.help), shown));
    action->setStatusTip(tr(spec.help));
    action->setCheckable(spec.kind != Spec::plain);
    if (const auto group = choices.find(spec.kind); group != choices.end()) group->second->addAction(action);
    window->addAction(action);
  }
}

QAction* WindowActions::operator[](const char* name) const {
  return window_->findChild<QAction*>(QLatin1String(name), Qt::FindDirectChildrenOnly);
}

QList<QAction*> WindowActions::all(const char* names) const {
  QList<QAction*> actions;
  for (const QString& name : QString::fromLatin1(names).split(QLatin1Char(' ')))
    actions << window_->findChild<QAction*>(name, Qt::FindDirectChildrenOnly);
  return actions;
}

QMenu* WindowActions::make_hole_menu() {
  auto* menu = new QMenu(window_);
  menu->setObjectName(QStringLiteral("holeMenu"));
  menu->setAttribute(Qt::WA_DeleteOnClose);
  put(menu, all("fillAction initialAction runAction - toolFillPartAction - prepareAction trimAction trimCrossingAction "
                "eraseRingAction stitchAction repairAction toolBridgeAction partAction - candidatesAction acceptAction "
                "rejectAction - compare copyAction"));
  auto* close_as = new QMenu(tr("&Close as"), menu);
  close_as->setObjectName(QStringLiteral("closeAsMenu"));
  put(close_as, all(close_as_names));
  menu->insertMenu((*this)["runAction"], close_as);
  return menu;
}

QMenu* WindowActions::add_menu(const QString& title, const char* names, QMenu* in) {
  QMenu* menu = in ? new QMenu(title, in) : window_->menuBar()->addMenu(title);
  const QList<QAction*> actions = all(names);
  put(menu, actions);
  Group group{QString(title).remove(QLatin1Char('&')), {}};
  for (QAction* action : actions)
    if (action) group.actions << action;
  groups_.push_back(std::move(group));
  return menu;
}

void WindowActions::build_menus(const QList<QAction*>& docks) {
  QMenu* file = add_menu(tr("&File"),
                         "open add sample - saveSession saveSessionAs - export screenshot film report - batch - quit");
  recent_ = new QMenu(tr("Open &recent"), file);
  close_ = new QMenu(tr("C&lose"), file);
  file->insertMenu((*this)["sample"], recent_);
  file->insertMenu((*this)["quit"], close_);
  add_menu(tr("&Edit"), "undo redo - selectAll nextHole previousHole nextToLookAt filter - preferences");
  QMenu* view = add_menu(tr("&View"),
                         "curvature gaussian plain zebra isophotes scanColors deviation - wireframe seams tint - frame "
                         "lookFront lookBack lookLeft lookRight lookTop lookBottom orthographic clip - "
                         "hidePiece isolatePiece showPieces - probe -");
  view->addActions(docks);
  QMenu* up = add_menu(tr("&Up axis"), "upByShape - upX upMinusX upY upMinusY upZ upMinusZ", view);
  QMenu* navigation = add_menu(tr("&Navigation"),
                               "navigateLoopmend navigateBlender navigateMeshLab navigateCad - navigationSheet", view);
  for (QMenu* menu : {up, navigation}) view->insertMenu((*this)["orthographic"], menu);
  QMenu* patch =
      add_menu(tr("&Patch"),
               "fillAction initialAction - prepareAction trimAction trimCrossingAction eraseRingAction stitchAction "
               "partAction turnAroundAction repairAction - runAction stepAction playAction nextStateAction - compare - "
               "candidatesAction "
               "acceptAction rejectAction "
               "copyAction - cancelAction");
  patch->insertMenu((*this)["runAction"], add_menu(tr("&Close as"), close_as_names, patch));
  add_menu(tr("&Tools"),
           "compare - toolRegionAction toolPointsAction toolBlendAction toolBridgeAction toolFillPartAction "
           "toolEdgesAction toolMirrorAction toolCutAction - toolMeasureAction");
  add_menu(tr("&Help"), "help palette shortcuts - about");
}

void WindowActions::build_toolbar() {
  QToolBar* bar = window_->addToolBar(tr("Tools"));
  bar->setObjectName(QStringLiteral("tools"));
  bar->setMovable(false);
  bar->setIconSize(QSize(20, 20));
  bar->setContextMenuPolicy(Qt::PreventContextMenu);
  const auto group = [this, bar](const char* names, Qt::ToolButtonStyle style) {
    for (QAction* action : all(names)) {
      bar->addAction(action);
      auto* button = qobject_cast<QToolButton*>(bar->widgetForAction(action));
      button->setObjectName(action->objectName() + QStringLiteral("Button"));
      button->setToolButtonStyle(style);
      button->setFocusPolicy(Qt::TabFocus);
      button->setAccessibleName(QString(action->text()).remove(QLatin1Char('&')));
      button->setAccessibleDescription(action->toolTip());
    }
    bar->addSeparator();
  };
  group("open saveSession export", Qt::ToolButtonTextBesideIcon);
  group("undo redo", Qt::ToolButtonIconOnly);
  group("curvature gaussian plain zebra isophotes scanColors deviation", Qt::ToolButtonTextBesideIcon);
  group("wireframe seams frame screenshot", Qt::ToolButtonIconOnly);
  group("compare", Qt::ToolButtonTextBesideIcon);
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
  for (const Spec& spec : specs())
    if (spec.icon) (*this)[spec.name]->setIcon(icon(spec.icon, ink));
}

}  // namespace loopmend
