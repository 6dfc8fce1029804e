// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/write_report.h"

#include "core/path_text.h"
#include "io/atomic_file.h"
#include "io/text_cursor.h"

#include <QBuffer>
#include <QPdfWriter>
#include <QTextDocument>
#include <QThread>
#include <QUrl>

#include <exception>
#include <memory>
#include <ostream>

namespace loopmend {
namespace {

QByteArray pdf_of(const FillReport& report) {
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  QPdfWriter writer(&buffer);
  writer.setPageSize(QPageSize(QPageSize::A4));
  writer.setTitle(report.title);
  QTextDocument page;
  for (std::size_t k = 0; k < report.holes.size(); ++k)
    page.addResource(QTextDocument::ImageResource, QUrl(QStringLiteral("picture:%1").arg(k)), report.holes[k].picture);
  page.setHtml(html_of(report, PictureLinks::named));
  page.print(&writer);
  return bytes;
}

/// The layout of a document has timers, which Qt allows in its own threads alone.
QByteArray pdf_by_thread(const FillReport& report) {
  QByteArray bytes;
  std::exception_ptr failure;
  const std::unique_ptr<QThread> thread(QThread::create([&] {
    try {
      bytes = pdf_of(report);
    } catch (...) {
      failure = std::current_exception();
    }
  }));
  thread->start();
  thread->wait();
  if (failure) std::rethrow_exception(failure);
  return bytes;
}

}  // namespace

bool write_report(const std::filesystem::path& path, const FillReport& report, const CancelToken& cancel) {
  const bool is_pdf = equals_ignoring_case(path_text(path.extension()), ".pdf");
  const QByteArray bytes = is_pdf ? pdf_by_thread(report) : html_of(report, PictureLinks::within).toUtf8();
  if (cancel.cancelled()) return false;
  write_file_atomically(path, [&](std::ostream& out) { out.write(bytes.constData(), bytes.size()); });
  return true;
}

}  // namespace loopmend
