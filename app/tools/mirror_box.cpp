// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/mirror_box.h"

#include "document/labels.h"
#include "panels/parts.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QSignalBlocker>
#include <QVBoxLayout>

namespace loopmend {

MirrorBox::MirrorBox(const Document& document, MirrorGuide& guide, QWidget* parent)
    : QWidget(parent),
      document_(document),
      guide_(guide),
      plane_(new QComboBox),
      use_(make_option<QCheckBox>(
          "mirrorUse", tr("Copy where the image fits"),
          tr("Holes of this scan are filled by a copy of the other side where the image fits; the others as ever"))),
      fits_(make_note("mirrorFits")) {
  auto* hint = make_note("mirrorHint", tr("The plane is that of the best mirror image of the scan. Drag the blue dot "
                                          "to move it, a white one to turn it. "
                                          "Holes that the image fits show what would be copied."));
  explain(plane_, "mirrorPlane", tr("Plane"),
          tr("The planes that were found, the best first, or the one that was dragged"));
  auto* layout = make_layout<QVBoxLayout>(this);
  for (QWidget* widget : std::initializer_list<QWidget*>{hint, plane_, fits_, use_}) layout->addWidget(widget);
  connect(plane_, QOverload<int>::of(&QComboBox::activated), this, [this](int index) {
    if (index >= static_cast<int>(guide_.planes().size())) return;
    guide_.move_plane(guide_.planes()[index]);
    guide_.let_go();
  });
  connect(use_, &QCheckBox::toggled, this,
          [this](bool on) { guide_.use(on ? MirrorGuide::Use::where_it_fits : MirrorGuide::Use::no); });
  connect(&guide_, &MirrorGuide::changed, this, &MirrorBox::follow);
  follow();
}

QString MirrorBox::fits_text() const {
  if (guide_.busy() && guide_.planes().empty()) return tr("Looking for planes of symmetry\u2026");
  if (guide_.has_failed()) return tr("The scan could not be compared with its image.");
  if (!guide_.plane()) return tr("No plane of symmetry was found.");
  if (guide_.busy()) return tr("Comparing the holes with the image\u2026");
  const auto answer = [](const MirrorFit& fit) {
    if (fit.is_proposed()) return tr("the image fits, %1 diameters off").arg(labels::number(fit.misfit));
    if (fit.is_used()) return tr("lies across the plane, and its patch would be symmetric");
    return labels::notice(notice_on(fit));
  };
  QStringList lines;
  for (const MirrorGuide::Fit& one : guide_.fits())
    lines << tr("%1: %2.").arg(labels::sentence(labels::holes(document_, {one.loop})).remove(QLatin1Char('.')),
                               answer(one.fit));
  if (!lines.isEmpty()) return lines.join(QLatin1Char('\n'));
  return guide_.is_of_selection() ? tr("No selected hole of this scan is open.") : tr("There is no open hole.");
}

void MirrorBox::follow() {
  const QSignalBlocker quiet_plane(plane_), quiet_use(use_);
  plane_->clear();
  int current = -1;
  for (std::size_t k = 0; k < guide_.planes().size(); ++k) {
    const MirrorPlane& plane = guide_.planes()[k];
    plane_->addItem(tr("Plane %1: image within %2 % of the extent").arg(k + 1).arg(labels::number(100 * plane.misfit)));
    if (guide_.plane() && plane.point == guide_.plane()->point && plane.normal == guide_.plane()->normal)
      current = static_cast<int>(k);
  }
  if (guide_.plane() && current < 0) {
    plane_->addItem(tr("Dragged"));
    current = plane_->count() - 1;
  }
  plane_->setCurrentIndex(current);
  plane_->setEnabled(guide_.plane().has_value());
  use_->setEnabled(guide_.plane().has_value());
  use_->setChecked(guide_.use() == MirrorGuide::Use::where_it_fits);
  fits_->setText(fits_text());
}

}  // namespace loopmend
