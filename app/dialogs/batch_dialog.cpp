// SPDX-License-Identifier: GPL-3.0-or-later
#include "dialogs/batch_dialog.h"

#include "dialogs/batch_words.h"
#include "document/file_path.h"
#include "document/labels.h"
#include "document/shell_words.h"
#include "jobs/remaining_time.h"
#include "panels/hole_delegate.h"
#include "panels/parts.h"
#include "panels/progress_bar.h"

#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QDesktopServices>
#include <QDir>
#include <QFileDialog>
#include <QFormLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTreeWidget>
#include <QUrl>

namespace loopmend {
namespace {

enum Column { at_scan, at_state, at_good, at_look, at_bad, at_open, at_likely, at_remarks };

QString words_of_path(const std::filesystem::path& path) { return QString::fromStdString(path_text(path)); }

}  // namespace

BatchDialog::BatchDialog(BatchController& controller, QWidget* parent) : QDialog(parent), controller_(controller) {
  setObjectName(QStringLiteral("batchDialog"));
  setWindowTitle(tr("Fill a folder"));
  build();
  connect_controller();
  update_state();
}

void BatchDialog::build() {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(18, 18, 18, 14);
  layout->setSpacing(10);
  choices_ = build_choices();
  layout->addWidget(choices_);
  build_table();
  layout->addWidget(table_, 1);
  progress_ = new ProgressBar;
  explain(progress_, "batchProgress", tr("Scans done"), tr("How many of the scans are done"));
  left_ = make_note("batchTimeLeft");
  auto* bar = make_layout<QHBoxLayout>();
  bar->addWidget(progress_, 1);
  bar->addWidget(left_);
  layout->addLayout(bar);
  words_ = new QLabel;
  words_->setObjectName(QStringLiteral("batchSummary"));
  words_->setWordWrap(true);
  words_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  layout->addWidget(words_);
  auto* buttons = make_dialog_buttons(QDialogButtonBox::Close);
  start_ = make_button("batchStart", tr("&Start"), tr("Fill the scans of the folder that are not complete"));
  stop_ = make_button("batchStop", tr("S&top"), tr("End the scans that are being filled; finished ones stay (Esc)"));
  report_ = make_button("batchReport", tr("&Open report"), tr("Show the page of all scans in the web browser"));
  copy_ = make_button("batchCopy", tr("&Copy command line"), tr("Copy the command that does the same"));
  buttons->button(QDialogButtonBox::Close)->setAutoDefault(false);  // Return starts, and never closes
  start_->setDefault(true);
  for (QPushButton* button : {stop_, report_, copy_}) button->setAutoDefault(false);
  for (QPushButton* button : {start_, stop_, report_, copy_}) buttons->addButton(button, QDialogButtonBox::ActionRole);
  connect(start_, &QPushButton::clicked, this, &BatchDialog::start);
  connect(stop_, &QPushButton::clicked, this, &BatchDialog::stop);
  connect(report_, &QPushButton::clicked, this, [this] {
    const QString page = words_of_path(result_files(job().output).page);
    if (!QDesktopServices::openUrl(QUrl::fromLocalFile(page))) words_->setText(page);  // there is no browser
  });
  connect(copy_, &QPushButton::clicked, this, [this] { QApplication::clipboard()->setText(command_line()); });
  connect(buttons, &QDialogButtonBox::rejected, this, &BatchDialog::reject);
  layout->addWidget(buttons);
  resize(QSize(1040, 620).boundedTo(largest_window()));
}

QWidget* BatchDialog::make_folder_row(QLineEdit* line, const char* name, const QString& title) {
  auto* row = new QWidget;
  auto* layout = make_layout<QHBoxLayout>(row);
  QPushButton* browse =
      make_button((QByteArray(name) + "Browse").constData(), tr("Browse\u2026"), tr("Choose the folder"));
  browse->setAccessibleName(tr("%1: %2").arg(title, tr("Browse\u2026")));
  browse->setAutoDefault(false);
  connect(browse, &QPushButton::clicked, this, [this, line, title] {
    const QString chosen = QFileDialog::getExistingDirectory(this, title, line->text());
    if (!chosen.isEmpty()) line->setText(QDir::toNativeSeparators(chosen));
  });
  layout->addWidget(line, 1);
  layout->addWidget(browse);
  return row;
}

QWidget* BatchDialog::build_choices() {
  const QString of_scans = tr("Folder of the scans"), of_results = tr("Folder of the results");
  input_ = new QLineEdit;
  explain(input_, "batchInput", of_scans, tr("Every mesh in it and in the folders in it is filled"));
  output_ = new QLineEdit;
  explain(output_, "batchOutput", of_results,
          tr("Created where it does not exist; finished scans in it are not filled again"));
  format_ = new QComboBox;
  explain(format_, "batchFormat", tr("Format"), tr("Format of the filled scans"));
  format_->addItem(tr("That of each scan"), QString());
  for (const char* name : {"ply", "stl", "obj", "off", "glb", "gltf", "3mf", "vtp", "vtk"})
    format_->addItem(QString::fromLatin1(name).toUpper(), QString::fromLatin1(name));
  pictures_ = new QComboBox;
  explain(pictures_, "batchPictures", tr("Pictures"), tr("Pictures before and after, in the page of the results"));
  for (const auto& [text, value] : {std::pair{tr("Of all scans"), BatchJob::Pictures::all},
                                    {tr("Of scans left open"), BatchJob::Pictures::open},
                                    {tr("None"), BatchJob::Pictures::none}})
    pictures_->addItem(text, static_cast<int>(value));
  again_ = new QComboBox;
  explain(again_, "batchAgain", tr("Filled before"),
          tr("What is done with scans that are complete in the folder of the results"));
  for (const auto& [text, value] : {std::pair{tr("Leave as they are"), BatchJob::Again::none},
                                    {tr("Fill those left open again"), BatchJob::Again::open},
                                    {tr("Fill all again"), BatchJob::Again::all}})
    again_->addItem(text, static_cast<int>(value));
  prepare_ = make_option<QCheckBox>(
      "batchPrepare", tr("&Prepare each scan where it needs that"),
      tr("Stitch, repair and trim it before it is filled, as Prepare does with a scan in the window"));
  prepare_->setChecked(true);
  overwrite_ = make_option<QCheckBox>("batchOverwrite", tr("&Replace other files"),
                                      tr("Also files in the folder of the results that no batch wrote, or that have "
                                         "changed since"));
  auto* box = new QWidget;
  auto* form = make_layout<QFormLayout>(box);
  form->setVerticalSpacing(8);
  form->addRow(of_scans, make_folder_row(input_, "batchInput", of_scans));
  form->addRow(of_results, make_folder_row(output_, "batchOutput", of_results));
  auto* row = make_layout<QHBoxLayout>();
  row->addWidget(format_);
  for (QComboBox* choice : {pictures_, again_}) {
    auto* title = new QLabel(choice->accessibleName());
    title->setBuddy(choice);
    row->addSpacing(12);
    row->addWidget(title);
    row->addSpacing(4);
    row->addWidget(choice);
  }
  row->addStretch(1);
  form->addRow(format_->accessibleName(), row);
  auto* ticks = make_layout<QHBoxLayout>();
  ticks->addWidget(prepare_);
  ticks->addSpacing(12);
  ticks->addWidget(overwrite_);
  ticks->addStretch(1);
  form->addRow(QString(), ticks);
  connect(input_, &QLineEdit::textChanged, this, &BatchDialog::propose_output);
  for (QLineEdit* line : {input_, output_}) connect(line, &QLineEdit::textChanged, this, &BatchDialog::update_state);
  return box;
}

void BatchDialog::build_table() {
  table_ = new QTreeWidget;
  explain(table_, "batchTable", tr("Scans"), tr("What becomes of each scan; double click or Return opens it filled"));
  table_->setRootIsDecorated(false);
  table_->setUniformRowHeights(true);
  table_->setAlternatingRowColors(true);
  table_->setHeaderLabels({tr("Scan"), tr("State"), tr("Good"), tr("To look at"), tr("Bad"), tr("Left open"),
                           tr("Likely error"), tr("Remarks")});
  table_->headerItem()->setToolTip(at_likely, tr("Of the patch that is likely farthest from what was there"));
  table_->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table_->header()->setStretchLastSection(true);
  table_->setSortingEnabled(true);
  table_->header()->setSortIndicator(-1, Qt::AscendingOrder);
  connect(table_, &QTreeWidget::itemActivated, this, [this](const QTreeWidgetItem* item) {
    const QString path = item->data(at_scan, Qt::UserRole).toString();
    if (!path.isEmpty()) Q_EMIT scan_wanted(path);
  });
}

void BatchDialog::connect_controller() {
  connect(&controller_, &BatchController::listed, this,
          [this](const std::vector<Scan>& scans, const std::vector<double>& bytes) {
            bytes_ = bytes;
            show_listed(scans);
          });
  connect(&controller_, &BatchController::begun, this, [this](std::size_t scan) {
    items_[scan]->setText(at_state, tr("is being filled"));
    items_[scan]->setIcon(at_state, sign_icon(HoleState::running));
    table_->scrollToItem(items_[scan]);
  });
  connect(&controller_, &BatchController::ended, this, &BatchDialog::show_row);
  connect(&controller_, &BatchController::finished, this, &BatchDialog::show_end);
  connect(&controller_, &BatchController::failed, this, &BatchDialog::fail);
}

void BatchDialog::set_folders(const QString& input, const QString& output) {
  input_->setText(input);
  output_->setText(output);
}

/// Beside the scans, until a person writes something else.
void BatchDialog::propose_output() {
  if (output_->text() != proposed_) return;
  const QString input = QDir::cleanPath(QDir::fromNativeSeparators(input_->text()));
  proposed_ = input_->text().isEmpty() ? QString() : QDir::toNativeSeparators(input + QStringLiteral("-filled"));
  output_->setText(proposed_);
}

BatchJob BatchDialog::job() const {
  BatchJob job;
  job.inputs = {file_path(input_->text())};
  job.output = file_path(output_->text());
  job.program = BatchController::program();
  job.format = format_->currentData().toString().toStdString();
  job.pictures = static_cast<BatchJob::Pictures>(pictures_->currentData().toInt());
  job.again = static_cast<BatchJob::Again>(again_->currentData().toInt());
  job.existing = overwrite_->isChecked() ? BatchJob::Existing::overwrite : BatchJob::Existing::keep;
  job.prepare = prepare_->isChecked() ? BatchJob::Prepare::where_needed : BatchJob::Prepare::as_asked;
  job.command_line = command_line().toStdString();
  return job;
}

QString BatchDialog::command_line() const {
  QStringList words{QStringLiteral("loopmend"), QStringLiteral("batch"), shell::quoted(input_->text()),
                    QStringLiteral("-o"), shell::quoted(output_->text())};
  const auto add = [&words](const char* option, const QString& value) {
    words << QLatin1String(option);
    if (!value.isEmpty()) words << value;
  };
  if (const QString format = format_->currentData().toString(); !format.isEmpty()) add("--format", format);
  const auto pictures = static_cast<BatchJob::Pictures>(pictures_->currentData().toInt());
  if (pictures == BatchJob::Pictures::open) add("--pictures", QStringLiteral("open"));
  if (pictures == BatchJob::Pictures::none) add("--pictures", QStringLiteral("none"));
  const auto again = static_cast<BatchJob::Again>(again_->currentData().toInt());
  if (again == BatchJob::Again::open) add("--again", QStringLiteral("open"));
  if (again == BatchJob::Again::all) add("--again", QStringLiteral("all"));
  if (overwrite_->isChecked()) add("--overwrite", {});
  if (!prepare_->isChecked()) add("--no-auto", {});
  return words.join(QLatin1Char(' '));
}

void BatchDialog::start() {
  if (controller_.busy()) return;
  table_->clear();
  items_.clear();
  bytes_done_ = bytes_known_ = 0;
  done_ = 0;
  left_->clear();
  words_->setText(tr("Looking for the scans\u2026"));
  running_ = job();
  if (!QFileInfo(input_->text()).isDir()) return fail(tr("There is no folder %1.").arg(input_->text()));
  since_start_.start();
  controller_.start(running_);
  update_state();
}

void BatchDialog::stop() {
  controller_.stop();
  words_->setText(tr("Stopping\u2026"));
  left_->clear();
  update_state();
}

void BatchDialog::show_listed(const std::vector<Scan>& scans) {
  table_->setSortingEnabled(false);
  for (const Scan& scan : scans) {
    auto* item = new QTreeWidgetItem(table_, {QString::fromStdString(scan.name), tr("waits")});
    item->setIcon(at_state, sign_icon(HoleState::open));
    item->setToolTip(at_scan, words_of_path(scan.input));
    for (int column = at_good; column <= at_likely; ++column)
      item->setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
    items_.push_back(item);
  }
  table_->setSortingEnabled(true);
  progress_->setRange(0, static_cast<int>(scans.size()));
  show_progress();
}

void BatchDialog::show_row(std::size_t scan, const SummaryRow& row) {
  QTreeWidgetItem& item = *items_[scan];
  item.setText(at_state, labels::status_of(row));
  item.setIcon(at_state, sign_icon(labels::sign_of(row)));
  if (row.end.has_mesh())
    item.setData(at_scan, Qt::UserRole, words_of_path(files_of(running_.output, row.scan.name).mesh));
  if (row.figures) {
    const ScanFigures& f = *row.figures;
    item.setData(at_good, Qt::DisplayRole, f.filled - f.look - f.bad);
    item.setData(at_look, Qt::DisplayRole, f.look);
    item.setData(at_bad, Qt::DisplayRole, f.bad);
    item.setData(at_open, Qt::DisplayRole, f.failed + f.left);
    if (f.likely_off) item.setText(at_likely, labels::number(*f.likely_off));
  }
  const QStringList said = labels::remarks_on(row);
  item.setText(at_remarks, said.join(QStringLiteral("; ")));
  item.setToolTip(at_remarks, said.join(QLatin1Char('\n')));
  ++done_;
  (row.end.state == ScanEnd::State::filled ? bytes_done_ : bytes_known_) += bytes_[scan];
  show_progress();
}

/// Reading and filling take about as long as a file is large; what was complete before took no time.
void BatchDialog::show_progress() {
  progress_->setValue(static_cast<int>(done_));
  words_->setText(tr("%1 of %Ln scan(s) done.", nullptr, static_cast<int>(items_.size())).arg(done_));
  double all = 0;
  for (const double bytes : bytes_) all += bytes;
  const double work = all - bytes_known_;
  const auto seconds =
      seconds_left(static_cast<double>(since_start_.elapsed()) / 1000, work > 0 ? bytes_done_ / work : 0);
  left_->setText(seconds ? labels::time_left(*seconds) : QString());
}

void BatchDialog::show_end(const std::vector<SummaryRow>& rows) {
  for (std::size_t k = 0; k < rows.size(); ++k)
    if (rows[k].end.state == ScanEnd::State::waiting) {
      items_[k]->setText(at_state, labels::status_of(rows[k]));
      items_[k]->setIcon(at_state, sign_icon(labels::sign_of(rows[k])));
    }
  left_->clear();
  words_->setText(labels::summary_of(rows));
  update_state();
  if (!table_->hasFocus()) start_->setFocus();
}

void BatchDialog::fail(const QString& words) {
  left_->clear();
  words_->setText(words);
  update_state();
}

void BatchDialog::update_state() {
  const bool busy = controller_.busy();
  choices_->setEnabled(!busy);
  start_->setEnabled(!busy && !input_->text().isEmpty() && !output_->text().isEmpty());
  stop_->setEnabled(busy && !controller_.is_stopping());
  copy_->setEnabled(!input_->text().isEmpty() && !output_->text().isEmpty());
  report_->setEnabled(!busy && !output_->text().isEmpty() &&
                      QFileInfo::exists(words_of_path(result_files(file_path(output_->text())).page)));
  progress_->setVisible(busy);
}

void BatchDialog::reject() {
  if (!controller_.busy()) return QDialog::reject();
  stop();
}

}  // namespace loopmend
