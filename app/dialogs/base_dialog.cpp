// SPDX-License-Identifier: GPL-3.0-or-later
#include "dialogs/base_dialog.h"

#include "document/labels.h"

#include <QInputDialog>

#include <algorithm>
#include <cmath>

namespace loopmend {

void ask_base(int loop, const Document& document, FillController& controller, QWidget* over) {
  constexpr double share = 0.05;  // of the loop's diameter, as the command line proposes it
  const double diameter = document.loop(loop).diameter;
  const int decimals = std::clamp(3 - static_cast<int>(std::floor(std::log10(std::max(diameter, 1e-300)))), 0, 12);
  const double least = std::pow(10, -decimals);
  const QString unit = labels::unit_symbol(document.unit(document.scan_of(loop)));
  auto* dialog = new QInputDialog(over);
  dialog->setObjectName(QStringLiteral("baseDialog"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(FillController::tr("Base"));
  dialog->setInputMode(QInputDialog::DoubleInput);
  dialog->setLabelText(
      FillController::tr("A straight wall leads from hole %1 down to a plane.\nHow far the plane lies below the lowest "
                         "point of the surface%2:")
          .arg(labels::hole_name(document, loop), unit.isEmpty() ? QString() : QStringLiteral(", ") + unit));
  dialog->setDoubleDecimals(decimals);
  dialog->setDoubleRange(least, 1e3 * diameter);
  dialog->setDoubleStep(std::max(least, share / 5 * diameter));
  dialog->setDoubleValue(share * diameter);
  dialog->setOkButtonText(FillController::tr("&Build"));
  QObject::connect(dialog, &QInputDialog::doubleValueSelected, &controller,
                   [&controller, loop](double distance) { controller.build_base(loop, distance); });
  dialog->open();
}

}  // namespace loopmend
