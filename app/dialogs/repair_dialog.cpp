// SPDX-License-Identifier: GPL-3.0-or-later
#include "dialogs/repair_dialog.h"

#include "document/labels.h"
#include "document/targets.h"
#include "panels/parts.h"
#include "panels/steady_label.h"

#include <QDialogButtonBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>

namespace loopmend {
namespace {

struct Words {
  Defect defect;
  const char* name;  ///< of the row's widgets
  const char* title;
  const char* fix;
  const char* help;
};

const Words all_words[] = {
    {Defect::coincident_points, "Coincident",
     QT_TRANSLATE_NOOP("loopmend::RepairDialog", "Vertices at exactly the same place"),
     QT_TRANSLATE_NOOP("loopmend::RepairDialog", "Join"),
     QT_TRANSLATE_NOOP("loopmend::RepairDialog", "Faces share one vertex there; the scan hangs together along it")},
    {Defect::degenerate_faces, "Degenerate", QT_TRANSLATE_NOOP("loopmend::RepairDialog", "Degenerate faces"),
     QT_TRANSLATE_NOOP("loopmend::RepairDialog", "Remove"),
     QT_TRANSLATE_NOOP("loopmend::RepairDialog", "Faces that have a vertex twice, and so no area")},
    {Defect::duplicate_faces, "Duplicate", QT_TRANSLATE_NOOP("loopmend::RepairDialog", "Duplicate faces"),
     QT_TRANSLATE_NOOP("loopmend::RepairDialog", "Remove"),
     QT_TRANSLATE_NOOP("loopmend::RepairDialog",
                       "Faces over the same three vertices: one stays, or none where they cancel out")},
    {Defect::intersections, "Intersecting", QT_TRANSLATE_NOOP("loopmend::RepairDialog", "Faces that intersect others"),
     QT_TRANSLATE_NOOP("loopmend::RepairDialog", "Cut out"),
     QT_TRANSLATE_NOOP("loopmend::RepairDialog", "They are removed; the holes that this leaves can be filled")},
    {Defect::non_manifold, "NonManifold",
     QT_TRANSLATE_NOOP("loopmend::RepairDialog", "Non-manifold edges and vertices, faces turned the wrong way"),
     QT_TRANSLATE_NOOP("loopmend::RepairDialog", "Separate"),
     QT_TRANSLATE_NOOP("loopmend::RepairDialog",
                       "Every edge gets two faces at most, every vertex one fan; faces are turned to agree")},
    {Defect::overlaps, "Overlapping",
     QT_TRANSLATE_NOOP("loopmend::RepairDialog", "Bodies that overlap; Fix all leaves them"),
     QT_TRANSLATE_NOOP("loopmend::RepairDialog", "Unite"),
     QT_TRANSLATE_NOOP(
         "loopmend::RepairDialog",
         "One body of all closed ones that overlap, touch along faces or lie within each other; cavities stay. "
         "Open ones are left")},
    {Defect::handles, "Handles", QT_TRANSLATE_NOOP("loopmend::RepairDialog", "Tiny handles; Fix all leaves them"),
     QT_TRANSLATE_NOOP("loopmend::RepairDialog", "Cut open"),
     QT_TRANSLATE_NOOP(
         "loopmend::RepairDialog",
         "Struts and tunnels of at most eight edges around: most come from noise, some may be real. Holes are "
         "left of each, to be filled")},
    {Defect::fragments, "Fragments", QT_TRANSLATE_NOOP("loopmend::RepairDialog", "Tiny loose components"),
     QT_TRANSLATE_NOOP("loopmend::RepairDialog", "Remove"),
     QT_TRANSLATE_NOOP("loopmend::RepairDialog",
                       "Components of up to ten faces and a twentieth of the extent of the largest one")},
};

std::size_t count_of(Defect defect, const RepairCounts& counts) {
  switch (defect) {
    case Defect::coincident_points: return counts.joined_points;
    case Defect::degenerate_faces: return counts.degenerate_faces;
    case Defect::duplicate_faces: return counts.duplicate_faces;
    case Defect::intersections: return counts.intersecting_faces;
    case Defect::non_manifold: return counts.separated_edges + counts.separated_vertices + counts.turned_faces;
    case Defect::overlaps: return counts.overlapping_bodies;
    case Defect::handles: return counts.cut_handles;
    case Defect::fragments: return counts.removed_pieces;
  }
  return 0;
}

bool is_defect_for_sure(Defect defect) { return defect != Defect::handles && defect != Defect::overlaps; }

}  // namespace

RepairDialog::RepairDialog(const Document& document, FillController& controller, QWidget* parent)
    : QDialog(parent),
      document_(document),
      controller_(controller) {
  setObjectName(QStringLiteral("repairDialog"));
  setWindowTitle(tr("Repair"));
  build();
  connect(&document_, &Document::scans_changed, this, &RepairDialog::count);
  connect(&document_, &Document::opened, this, [this] {
    done_.clear();
    for (auto& [defect, row] : rows_) row.found_before.reset();
  });
  connect(&controller_, &FillController::repaired, this, [this](const QString& words) {
    for (auto& [defect, row] : rows_) row.found_before = row.found_at_start;
    add_answer(words);
  });
  connect(&controller_, &FillController::nothing_repaired, this, &RepairDialog::add_answer);
  connect(&controller_, &FillController::activity_changed, this, &RepairDialog::update_buttons);
  connect(&controller_, &FillController::stage_changed, this, [this](const QString& stage) {
    if (!stage.isEmpty()) done_.clear();  // the answer of a former repair is none to this one
    if (job_ || marking_) return;
    stage.isEmpty() ? tell() : summary_->setText(stage + QChar(0x2026));
  });
  connect(&controller_, &FillController::done_so_far, this, [this](const QString& words) {
    if (!job_ && !marking_ && !words.isEmpty())
      summary_->setText(summary_->text() + QLatin1Char('\n') + tr("So far: %1.").arg(words));
  });
  count();
}

void RepairDialog::build() {
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(18, 18, 18, 14);
  grid->setHorizontalSpacing(10);
  grid->setVerticalSpacing(6);
  summary_ = new SteadyLabel;
  summary_->setObjectName(QStringLiteral("repairSummary"));
  summary_->keep_room_for({QStringLiteral("1\n2\n3\n4\n5\n6")});  // what was done takes some lines
  grid->addWidget(summary_, 0, 0, 1, 5);
  int line = 1;
  for (const Words& words : all_words) {
    Row& row = rows_[words.defect];
    auto* title = new QLabel(tr(words.title));
    title->setWordWrap(true);  // a narrow window leaves room to see what it shows
    title->setToolTip(tr(words.help));
    row.count = new QLabel;
    row.count->setObjectName(QStringLiteral("count") + QLatin1String(words.name));
    row.count->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    row.count->setMinimumWidth(row.count->fontMetrics().horizontalAdvance(labels::count(1'000'000)));
    row.before = make_note((QByteArray("before") + words.name).constData());
    row.before->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    row.before->setMinimumWidth(row.before->fontMetrics().horizontalAdvance(tr("was %1").arg(labels::count(100000))));
    const QString help =
        tr("Mark in the view the faces that the repair would remove or change, and fly there; once more: to the next "
           "place");
    row.show = make_button((QByteArray("show") + words.name).constData(), tr("Show"), help);
    row.show->setAccessibleName(tr("%1: %2").arg(tr(words.title), tr("Show")));
    row.show->setAutoDefault(false);
    connect(row.show, &QPushButton::clicked, this, [this, defect = words.defect] { show_defect(defect); });
    const QByteArray name = QByteArray("fix") + words.name;
    row.fix = make_button(name.constData(), tr(words.fix), tr(words.help));
    row.fix->setAccessibleName(tr("%1: %2").arg(tr(words.title), tr(words.fix)));
    row.fix->setAutoDefault(false);
    connect(row.fix, &QPushButton::clicked, this, [this, defect = words.defect] { controller_.repair({defect}); });
    grid->addWidget(title, line, 0);
    grid->addWidget(row.before, line, 1);
    grid->addWidget(row.count, line, 2);
    grid->addWidget(row.show, line, 3);
    grid->addWidget(row.fix, line++, 4);
  }
  grid->setColumnStretch(0, 1);
  auto* buttons = make_dialog_buttons(QDialogButtonBox::Close);
  all_ = make_button("repairAll", tr("&Fix all"),
                     tr("Repair everything that was found but overlaps and tiny handles, in this order"));
  buttons->addButton(all_, QDialogButtonBox::ActionRole);
  all_->setDefault(true);
  connect(all_, &QPushButton::clicked, this, [this] {
    std::set<Defect> all;  // also those of which none was found: repairing one may make another
    for (const auto& [defect, row] : rows_)
      if (is_defect_for_sure(defect)) all.insert(defect);
    controller_.repair(all);
  });
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  grid->addWidget(buttons, line, 0, 1, 5);
}

void RepairDialog::count() {
  const bool were_known = !job_;  // a repair changes the scans twice: one comes, one goes
  drop(job_);
  drop_marks();
  const bool any = document_.has_scan();
  summary_->setText(any ? tr("Looking for defects\u2026") : tr("No scan is open."));
  for (auto& [defect, row] : rows_) {
    if (were_known) row.found_at_start = row.found;
    row.found = 0;
    row.count->setText(any ? QStringLiteral("\u2026") : QStringLiteral("\u2013"));
  }
  update_buttons();
  if (!any) return;
  job_ = std::make_shared<Job>(this);
  std::vector<std::shared_ptr<const OpenedScan>> scans;
  for (int index : document_.scans()) scans.push_back(document_.scan(index));
  tasks_.run(
      job_,
      [scans, job = job_] {
        RepairCounts all;
        for (const auto& scan : scans) {
          const RepairCounts own = count_defects(scan->model->soup, job->token());
          all.joined_points += own.joined_points;
          all.degenerate_faces += own.degenerate_faces;
          all.duplicate_faces += own.duplicate_faces;
          all.intersecting_faces += own.intersecting_faces;
          all.overlapping_bodies += own.united.bodies + own.united.left();
          all.separated_edges += own.separated_edges;
          all.separated_vertices += own.separated_vertices;
          all.turned_faces += own.turned_faces;
          all.cut_handles += own.cut_handles;
          all.removed_pieces += own.removed_pieces;
        }
        return all;
      },
      [this](const RepairCounts& counts) { show_counts(counts); },
      [this](const QString& text) { summary_->setText(text); });
}

void RepairDialog::show_counts(const RepairCounts& counts) {
  job_.reset();
  for (auto& [defect, row] : rows_) {
    row.found = count_of(defect, counts);
    row.count->setText(row.found > 0 ? labels::count(row.found) : tr("none"));
    const bool is_other = row.found_before && *row.found_before != row.found;
    row.before->setText(!is_other                ? QString()
                        : *row.found_before == 0 ? tr("was none")
                                                 : tr("was %1").arg(labels::count(*row.found_before)));
  }
  tell();
  update_buttons();
}

/// Each scan has one.
void RepairDialog::add_answer(const QString& words) {
  if (!done_.isEmpty()) done_ += QLatin1Char('\n');
  done_ += words;
  if (!job_) tell();
}

/// What was done last, and how the scan is.
void RepairDialog::tell() {
  const bool found = std::any_of(rows_.begin(), rows_.end(), [](const auto& row) { return row.second.found > 0; });
  QStringList lines;
  if (!done_.isEmpty()) lines << done_;
  lines << (found ? tr("Every change can be undone. Patches of a scan go when it is repaired.")
                  : tr("None of these defects is found in the scan as it is."));
  if (const int open = open_loops(document_) + cracks_left(document_); !found && open > 0)
    lines << tr("%Ln boundary loop(s) are open: Fill and smooth closes holes.", nullptr, open);
  summary_->setText(lines.join(QLatin1Char('\n')));
}

void RepairDialog::show_defect(Defect defect) {
  if (shown_ == defect && !marking_) return go_to_next_place();
  drop_marks();
  shown_ = defect;
  summary_->setText(tr("Looking for the places\u2026"));
  std::vector<std::shared_ptr<const OpenedScan>> scans;
  for (int index : document_.scans()) scans.push_back(document_.scan(index));
  marking_ = std::make_shared<Job>(this);
  tasks_.run(
      marking_,
      [scans, defect, origin = document_.origin(), job = marking_] {
        return find_defect_places(scans, defect, origin, job->token());
      },
      [this](DefectPlaces found) {
        marking_.reset();
        places_ = std::move(found);
        Q_EMIT marked(places_.shape);
        go_to_next_place();
      },
      [this](const QString& text) {
        marking_.reset();
        summary_->setText(text);
      });
}

void RepairDialog::go_to_next_place() {
  if (places_.places.empty()) {
    summary_->setText(tr("This repair would change no face: it joins or parts vertices alone."));
    return;
  }
  std::size_t faces = 0;
  for (const DefectPlace& place : places_.places) faces += place.faces;
  const std::size_t at = next_place_++ % places_.places.size();
  summary_->setText(tr("Red: what this repair would remove or change. Faces: %1, places: %2. Place %3 is in the view; "
                       "Show goes to the next.")
                        .arg(labels::count(faces), labels::count(places_.places.size()), labels::count(at + 1)));
  Q_EMIT place_wanted(places_.places[at]);
}

void RepairDialog::drop_marks() {
  drop(marking_);
  if (!shown_) return;
  shown_.reset();
  places_ = {};
  next_place_ = 0;
  Q_EMIT marked(nullptr);
}

void RepairDialog::hideEvent(QHideEvent* event) {
  drop_marks();
  QDialog::hideEvent(event);
}

void RepairDialog::update_buttons() {
  const bool idle = !controller_.busy();
  bool any = false;
  for (auto& [defect, row] : rows_) {
    row.fix->setEnabled(idle && row.found > 0);
    row.show->setEnabled(idle && row.found > 0);
    any = any || (row.found > 0 && is_defect_for_sure(defect));
  }
  all_->setEnabled(idle && any);
}

}  // namespace loopmend
