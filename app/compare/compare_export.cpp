// SPDX-License-Identifier: GPL-3.0-or-later
// What a comparison leaves behind: one picture, three tables, a command, its place on the screen.
#include "compare/compare_numbers.h"
#include "compare/compare_window.h"
#include "compare/flow_canvas.h"
#include "compare/flow_view.h"
#include "compare/legend_strip.h"
#include "core/error.h"
#include "dialogs/picture_dialog.h"
#include "document/file_path.h"
#include "document/message_words.h"
#include "document/preferences.h"
#include "panels/banner.h"
#include "problems/comparison_table.h"

#include "io/atomic_file.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QPainter>
#include <QStackedWidget>

namespace loopmend {
namespace {

void write(const QString& path, const std::string& text) {
  write_file_atomically(file_path(path), [&text](std::ostream& out) { out << text; });
}

}  // namespace

QImage CompareWindow::picture(const PictureOptions& options) {
  const QSize& size = options.size;
  const bool words = options.extras != PictureOptions::Extras::none;
  const bool see_through = options.ground == PictureOptions::Ground::transparent;
  const QWidget& seen = *pages_->parentWidget();
  const double scale = static_cast<double>(size.height()) / std::max(1, seen.height());
  QImage all(size, see_through ? QImage::Format_ARGB32 : QImage::Format_RGB32);
  all.fill(see_through ? QColor(Qt::transparent) : palette().color(QPalette::Window));
  QPainter painter(&all);
  painter.setRenderHint(QPainter::Antialiasing);
  const double legend = words && legend_->isVisible() ? legend_->sizeHint().width() * scale : 0;
  const bool wiping = pages_->currentIndex() == 1;
  const int count = wiping ? 1 : flow_comparison_.flow_runs(), columns = count == 4 ? 2 : count,
            rows = count == 4 ? 2 : 1;
  const double width = (size.width() - legend) / columns, height = static_cast<double>(size.height()) / rows;
  const double title = wiping || !words ? 0 : 2 * fontMetrics().height() * scale;
  QFont letters = font();
  letters.setPixelSize(std::max(6, static_cast<int>(fontInfo().pixelSize() * scale)));
  for (int flow_run = 0; flow_run < count; ++flow_run) {
    const QRectF cell(flow_run % columns * width, flow_run / columns * height, width, height);
    const QSize drawn(static_cast<int>(cell.width() - 3 * scale), static_cast<int>(cell.height() - title - 3 * scale));
    if (drawn.isEmpty()) return {};
    FlowView& shown = *flow_views_[flow_run];
    const QImage view = (wiping ? *wipe_ : shown.canvas()).picture(drawn, options.ground);
    if (view.isNull()) return {};
    painter.drawImage(QPointF(cell.left(), cell.top() + title), view);
    if (title == 0) continue;
    painter.setFont(letters);
    painter.setPen(palette().color(QPalette::WindowText));
    painter.drawText(QRectF(cell.left() + 6 * scale, cell.top(), cell.width() - 12 * scale, title),
                     Qt::AlignLeft | Qt::AlignVCenter, shown.caption());
  }
  if (legend > 0) {
    painter.translate(size.width() - legend, 0);
    painter.scale(scale, scale);
    legend_->paint(painter, QRectF(0, 0, legend / scale, size.height() / scale), palette().color(QPalette::WindowText));
  }
  return all;
}

QString CompareWindow::save_numbers(const QString& path) const {
  const QFileInfo file(path);
  const QString base = file.dir().filePath(file.completeBaseName());
  write(path, csv_of(table_rows(flow_comparison_)));
  write(base + QStringLiteral("-energies.csv"), curves_csv(flow_comparison_));
  if (flow_comparison_.comparison() && !flow_comparison_.comparison()->profiles.empty())
    write(base + QStringLiteral("-profile.csv"), profile_csv(*flow_comparison_.comparison()));
  return tr("Wrote %1, and beside it energies and profile.").arg(QDir::toNativeSeparators(path));
}

void CompareWindow::ask_picture() {
  auto* dialog = new PictureDialog(
      {pages_->parentWidget()->size() * devicePixelRatioF(),
       [this](const PictureOptions& options) { return picture(options); }, PictureSource::Offer::no_axes},
      this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &PictureDialog::saved, this,
          [this](const QString& path) { banner_->show_notice(tr("Wrote %1.").arg(path)); });
  dialog->show();
}

void CompareWindow::ask_numbers() {
  QString path =
      QFileDialog::getSaveFileName(this, tr("Save numbers"), QStringLiteral("compare.csv"), tr("CSV (*.csv)"));
  if (path.isEmpty()) return;
  if (QFileInfo(path).suffix().isEmpty()) path += QStringLiteral(".csv");
  try {
    banner_->show_notice(save_numbers(path));
  } catch (const std::exception& error) {
    banner_->show_problem(labels::in_words(message_of(error)));
  }
}

void CompareWindow::copy_command() {
  std::vector<FlowKind> flows;
  for (int flow_run = 0; flow_run < flow_comparison_.flow_runs(); ++flow_run)
    flows.push_back(flow_comparison_.flow(flow_run));
  banner_->show_notice(copy_to_clipboard(comparing_command(task_.command, options(), flows)));
}

void CompareWindow::keep_place() const { save_compare_place(saveGeometry()); }

}  // namespace loopmend
