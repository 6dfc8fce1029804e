// SPDX-License-Identifier: GPL-3.0-or-later
#include "dialogs/picture_dialog.h"

#include "panels/parts.h"

#include <QClipboard>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileDialog>
#include <QFormLayout>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>

namespace loopmend {
namespace {

constexpr int own_size = 0;
constexpr int smallest = 64, largest = 8192;

}  // namespace

PictureDialog::PictureDialog(MeshView& view, QWidget* parent)
    : PictureDialog({view.size() * view.devicePixelRatioF(),
                     [&view](const PictureOptions& options) { return view.picture(options); }},
                    parent) {}

PictureDialog::PictureDialog(PictureSource source, QWidget* parent) : QDialog(parent), source_(std::move(source)) {
  setObjectName(QStringLiteral("pictureDialog"));
  setWindowTitle(tr("Screenshot"));
  build();
  connect(size_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &PictureDialog::propose_size);
  propose_size();
}

void PictureDialog::build() {
  const auto combo = [](const char* name, const QString& title, const QString& help) {
    auto* box = new QComboBox;
    box->setObjectName(QLatin1String(name));
    explain(box, title, help);
    return box;
  };
  size_ = combo("pictureSize", tr("Size"), tr("How many pixels the picture has"));
  size_->addItem(tr("As on the screen"), 1);
  size_->addItem(tr("Twice as large"), 2);
  size_->addItem(tr("Four times as large"), 4);
  size_->addItem(tr("Own size"), own_size);
  const auto pixels = [](const char* name, const QString& title) {
    auto* box = new QSpinBox;
    box->setObjectName(QLatin1String(name));
    box->setRange(smallest, largest);
    box->setSuffix(tr(" px"));
    explain(box, title, title);
    return box;
  };
  width_ = pixels("pictureWidth", tr("Width in pixels"));
  height_ = pixels("pictureHeight", tr("Height in pixels"));
  auto* both = new QHBoxLayout;
  both->addWidget(width_);
  both->addWidget(new QLabel(QStringLiteral("\u00d7")));
  both->addWidget(height_);
  ground_ = combo("pictureGround", tr("Ground"), tr("What is behind the surface"));
  ground_->addItem(tr("As on the screen"), static_cast<int>(PictureOptions::Ground::as_seen));
  ground_->addItem(tr("Transparent"), static_cast<int>(PictureOptions::Ground::transparent));
  extras_ = combo("pictureExtras", tr("With"), tr("What is drawn beside the surface"));
  const auto offer = [this](const QString& text, PictureOptions::Extras what) {
    extras_->addItem(text, static_cast<int>(what));
  };
  if (source_.offer == PictureSource::Offer::everything) {
    offer(tr("Legend, axes and scale bar"), PictureOptions::Extras::legend_axes_scale);
    offer(tr("Legend"), PictureOptions::Extras::legend);
    offer(tr("The surface alone"), PictureOptions::Extras::none);
  } else {
    offer(tr("Headings and legend"), PictureOptions::Extras::legend);
    offer(tr("The surfaces alone"), PictureOptions::Extras::none);
  }
  fault_ = new QLabel;
  fault_->setObjectName(QStringLiteral("pictureTrouble"));
  fault_->setWordWrap(true);
  fault_->hide();
  auto* buttons = new QDialogButtonBox;
  auto* save = make_button("pictureSave", tr("&Save\u2026"), tr("Choose a file and write the picture"));
  auto* copy = make_button("pictureCopy", tr("&Copy"), tr("Put the picture into the clipboard"));
  buttons->addButton(save, QDialogButtonBox::AcceptRole);
  buttons->addButton(copy, QDialogButtonBox::ActionRole);
  buttons->addButton(QDialogButtonBox::Close);
  save->setDefault(true);
  connect(save, &QPushButton::clicked, this, &PictureDialog::ask_and_save);
  connect(copy, &QPushButton::clicked, this, &PictureDialog::copy);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* form = new QFormLayout(this);
  form->setContentsMargins(18, 18, 18, 14);
  form->setVerticalSpacing(10);
  form->addRow(tr("Si&ze"), size_);
  form->addRow(QString(), both);
  form->addRow(tr("&Ground"), ground_);
  form->addRow(tr("&With"), extras_);
  form->addRow(fault_);
  form->addRow(buttons);
}

void PictureDialog::propose_size() {
  const int times = size_->currentData().toInt();
  for (QSpinBox* box : {width_, height_}) box->setEnabled(times == own_size);
  if (times == own_size) return;
  const QSize seen = source_.seen * times;
  width_->setValue(seen.width());
  height_->setValue(seen.height());
}

PictureOptions PictureDialog::options() const {
  PictureOptions options;
  options.size = QSize(width_->value(), height_->value());
  options.ground = static_cast<PictureOptions::Ground>(ground_->currentData().toInt());
  options.extras = static_cast<PictureOptions::Extras>(extras_->currentData().toInt());
  return options;
}

bool PictureDialog::save(const QString& path) {
  const QImage picture = source_.draw(options());
  const bool written = !picture.isNull() && picture.save(path, "PNG");
  fault_->setVisible(!written);
  if (written) {
    Q_EMIT saved(QDir::toNativeSeparators(path));
    return true;
  }
  fault_->setText(picture.isNull() ? tr("The graphics cannot draw a picture of this size. Choose a smaller one.")
                                   : tr("%1 cannot be written. Choose another folder, or check how much space is left.")
                                         .arg(QDir::toNativeSeparators(path)));
  return false;
}

void PictureDialog::ask_and_save() {
  QString path =
      QFileDialog::getSaveFileName(this, tr("Screenshot"), QStringLiteral("loopmend.png"), tr("PNG (*.png)"));
  if (path.isEmpty()) return;
  if (QFileInfo(path).suffix().isEmpty()) path += QStringLiteral(".png");
  if (save(path)) accept();
}

void PictureDialog::copy() {
  const QImage picture = source_.draw(options());
  fault_->setVisible(picture.isNull());
  if (!picture.isNull()) QGuiApplication::clipboard()->setImage(picture);
}

}  // namespace loopmend
