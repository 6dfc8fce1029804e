// SPDX-License-Identifier: GPL-3.0-or-later
// Fill a folder: which scans, to where, how; a table of what becomes of each; and the page of the results.
#pragma once

#include "jobs/batch_controller.h"

#include <QDialog>
#include <QElapsedTimer>

#include <map>

class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace loopmend {

class BatchDialog : public QDialog {
  Q_OBJECT

 public:
  explicit BatchDialog(BatchController& controller, QWidget* parent = nullptr);

  void set_folders(const QString& input, const QString& output);
  BatchJob job() const;
  /// The command that does the same.
  QString command_line() const;
  void start();

 Q_SIGNALS:
  /// A filled scan is to be opened.
  void scan_wanted(const QString& path);

 protected:
  /// Stops what runs; with nothing running it closes.
  void reject() override;

 private:
  void build();
  QWidget* build_choices();
  QWidget* make_folder_row(QLineEdit* line, const char* name, const QString& title);
  void build_table();
  void connect_controller();
  void propose_output();
  void stop();
  void show_listed(const std::vector<Scan>& scans);
  void show_row(std::size_t scan, const SummaryRow& row);
  void show_progress();
  void show_end(const std::vector<SummaryRow>& rows);
  void fail(const QString& words);
  void update_state();

  BatchController& controller_;
  QLineEdit *input_ = nullptr, *output_ = nullptr;
  QComboBox *format_ = nullptr, *pictures_ = nullptr, *again_ = nullptr;
  QCheckBox *prepare_ = nullptr, *overwrite_ = nullptr;
  QWidget* choices_ = nullptr;
  QTreeWidget* table_ = nullptr;
  QProgressBar* progress_ = nullptr;
  QLabel *words_ = nullptr, *left_ = nullptr;
  QPushButton *start_ = nullptr, *stop_ = nullptr, *report_ = nullptr, *copy_ = nullptr;
  std::vector<QTreeWidgetItem*> items_;
  std::vector<double> bytes_;
  double bytes_done_ = 0, bytes_known_ = 0;  ///< of scans that were filled, and of those that need not be
  std::size_t done_ = 0;
  QElapsedTimer since_start_;
  QString proposed_;  ///< as output
  BatchJob running_;
};

}  // namespace loopmend
