// The bottom dock: the seam of the selected holes before and after, in numbers and a sentence, and a log.
#pragma once

#include <QTimer>
#include <QWidget>

class QLabel;
class QPlainTextEdit;
class QTableWidget;

namespace loopmend {

class Document;
class HoleSelection;

class ReportPanel : public QWidget {
  Q_OBJECT

 public:
  ReportPanel(const Document& document, const HoleSelection& selection, QWidget* parent = nullptr);

 public Q_SLOTS:
  void log(const QString& words);

 private:
  QWidget* build_seam();
  QWidget* build_log();
  void update_seam();
  void update_seam_soon();
  void fill_row(int row, int loop);
  std::vector<int> shown_loops() const;
  void copy_seam() const;

  const Document& document_;
  const HoleSelection& selection_;
  QTimer soon_;
  QTableWidget* seam_ = nullptr;
  QLabel* sentence_ = nullptr;
  QPlainTextEdit* log_ = nullptr;
};

}  // namespace loopmend
