// SPDX-License-Identifier: GPL-3.0-or-later
#include "dialogs/export_dialog.h"

#include "document/labels.h"
#include "panels/parts.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFileInfo>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>

namespace loopmend {

ExportDialog::ExportDialog(PrintCheck& check, const QString& proposal, const QStringList& filters,
                           const QString& filter, QWidget* parent)
    : QFileDialog(parent, tr("Export"), QFileInfo(proposal).path()),
      check_(check),
      content_(new QComboBox),
      new_faces_(new QCheckBox(tr("&Label new triangles"))),
      deviations_(new QCheckBox(tr("Likely &error of new vertices"))),
      verdict_(new QLabel),
      hidden_(new QLabel) {
  setObjectName(QStringLiteral("exportDialog"));
  setOption(QFileDialog::DontUseNativeDialog);  // which has no room for what is below
  setAcceptMode(QFileDialog::AcceptSave);
  setNameFilters(filters);
  selectNameFilter(filter);
  selectFile(QFileInfo(proposal).fileName());
  content_->addItem(tr("Scan and patches"), static_cast<int>(ExportChoice::Content::scene));
  content_->addItem(tr("Patches only"), static_cast<int>(ExportChoice::Content::patches));
  explain(content_, "exportContent", tr("What is written"),
          tr("The scan with its holes closed, or the patches by themselves"));
  verdict_->setObjectName(QStringLiteral("exportVerdict"));
  verdict_->setWordWrap(true);
  auto* grid = qobject_cast<QGridLayout*>(layout());
  const int row = grid->rowCount();
  auto* content_label = new QLabel(tr("&Write:"));
  content_label->setBuddy(content_);
  grid->addWidget(content_label, row, 0);
  grid->addWidget(content_, row, 1);
  new_faces_->setObjectName(QStringLiteral("exportNewFaces"));
  deviations_->setObjectName(QStringLiteral("exportDeviations"));
  grid->addWidget(new_faces_, row + 1, 1);
  grid->addWidget(deviations_, row + 2, 1);
  grid->addWidget(new QLabel(tr("Printing:")), row + 3, 0);
  grid->addWidget(verdict_, row + 3, 1, 1, 2);
  hidden_->setObjectName(QStringLiteral("exportHidden"));
  hidden_->setWordWrap(true);
  hidden_->hide();
  grid->addWidget(hidden_, row + 4, 1, 1, 2);
  connect(&check_, &PrintCheck::changed, this, &ExportDialog::show_verdict);
  connect(content_, qOverload<int>(&QComboBox::currentIndexChanged), this, &ExportDialog::show_verdict);
  for (auto signal : {&QFileDialog::filterSelected, &QFileDialog::currentChanged})
    connect(this, signal, this, &ExportDialog::follow_format);
  connect(findChild<QLineEdit*>(QStringLiteral("fileNameEdit")), &QLineEdit::textChanged, this,
          &ExportDialog::follow_format);
  follow_format();
  check_.start();
  show_verdict();
}

void ExportDialog::tell_of_hidden(int count) {
  hidden_->setText(tr("%Ln hidden component(s) or patch(es) are written as well.", nullptr, count));
  hidden_->setVisible(count > 0);
}

void ExportDialog::tell_unit(const QString& name) {
  unit_ = name;
  show_verdict();
}

void ExportDialog::leave_out_labels() {
  has_labels_ = false;
  follow_format();
}

ExportChoice::Content ExportDialog::content() const {
  return static_cast<ExportChoice::Content>(content_->currentData().toInt());
}

ExportChoice ExportDialog::choice() const {
  ExportChoice choice{content()};
  if (new_faces_->isEnabled() && new_faces_->isChecked()) choice.new_faces = NewFaces::labelled;
  if (deviations_->isEnabled() && deviations_->isChecked()) choice.deviations = ExportChoice::Deviations::written;
  return choice;
}

/// STL and OFF have no room for labels, and PLY and polydata have room for a number of each vertex.
void ExportDialog::follow_format() {
  const QString name = path().toLower();
  const auto is = [&](const char* ending) {
    return name.endsWith(QLatin1String(ending)) || name.endsWith(QLatin1String(ending) + QStringLiteral(".gz"));
  };
  const QString one_scan = tr("Only where the file has one scan");
  new_faces_->setEnabled(has_labels_ && !is(".stl") && !is(".off"));
  explain(new_faces_, tr("Label new triangles"),
          !has_labels_ ? one_scan
          : new_faces_->isEnabled()
              ? tr("PLY and VTK: face property patch; OBJ: group, glTF and 3MF: object loopmend_patch")
              : tr("STL and OFF have no room for a label"));
  deviations_->setEnabled(has_labels_ && (is(".ply") || is(".vtp") || is(".vtk")));
  explain(deviations_, tr("Likely error of new vertices"),
          !has_labels_               ? one_scan
          : deviations_->isEnabled() ? tr("Vertex property expected_deviation, in the unit of the scan")
                                     : tr("PLY and VTK polydata alone have room for it"));
}

QString ExportDialog::path() const {
  const QString chosen = selectedFiles().value(0);
  if (chosen.isEmpty() || !QFileInfo(chosen).suffix().isEmpty()) return chosen;
  return chosen +
         selectedNameFilter().section(QLatin1Char('*'), 1).section(QLatin1Char(' '), 0, 0).remove(QLatin1Char(')'));
}

void ExportDialog::show_verdict() {
  if (content() == ExportChoice::Content::patches)
    verdict_->setText(tr("Patches by themselves are open surfaces."));
  else if (check_.result())
    verdict_->setText(labels::verdict_in_full(*check_.result()) + (unit_.isEmpty()
                                                                       ? tr(". Lengths are in the units of the scan.")
                                                                       : tr(". Lengths are in %1.").arg(unit_)));
  else
    verdict_->setText(tr("Looking for open edges and intersections\u2026"));
  verdict_->setToolTip(check_.result() ? labels::verdict_help(*check_.result()) : QString());
}

}  // namespace loopmend
