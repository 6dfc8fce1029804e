// SPDX-License-Identifier: GPL-3.0-or-later
// Where to save the session, and whether the scans are kept in it.
#pragma once

#include "document/session.h"

#include <QFileDialog>

class QCheckBox;

namespace loopmend {

class SessionDialog : public QFileDialog {
  Q_OBJECT

 public:
  SessionDialog(const QString& proposal, KeepScans keep, QWidget* parent = nullptr);

  KeepScans keep() const;
  /// With the ending of sessions.
  QString path() const;

 private:
  QCheckBox* keep_;
};

}  // namespace loopmend
