// SPDX-License-Identifier: GPL-3.0-or-later
#include "dialogs/session_dialog.h"

#include "panels/parts.h"

#include <QCheckBox>
#include <QFileInfo>
#include <QGridLayout>

namespace loopmend {

SessionDialog::SessionDialog(const QString& proposal, KeepScans keep, QWidget* parent)
    : QFileDialog(parent, tr("Save session"), QFileInfo(proposal).path()),
      keep_(new QCheckBox(tr("&Keep the scans in the session"))) {
  setObjectName(QStringLiteral("sessionDialog"));
  setOption(QFileDialog::DontUseNativeDialog);  // which has no room for the choice
  setAcceptMode(QFileDialog::AcceptSave);
  setNameFilter(tr("Loopmend session (*.loopmend)"));
  setDefaultSuffix(QLatin1String(session_suffix));
  selectFile(QFileInfo(proposal).fileName());
  keep_->setObjectName(QStringLiteral("keepScans"));
  keep_->setChecked(keep == KeepScans::inside);
  explain(
      keep_, tr("Keep the scans in the session"),
      tr("The session can be moved or sent by itself, and is as large as the compressed scans. Pictures and material "
         "files beside a scan are not in it"));
  auto* grid = qobject_cast<QGridLayout*>(layout());
  grid->addWidget(keep_, grid->rowCount(), 1);
}

KeepScans SessionDialog::keep() const { return keep_->isChecked() ? KeepScans::inside : KeepScans::outside; }

QString SessionDialog::path() const {
  const QString chosen = selectedFiles().value(0);
  return chosen.isEmpty() || is_session_path(chosen) ? chosen
                                                     : chosen + QLatin1Char('.') + QLatin1String(session_suffix);
}

}  // namespace loopmend
