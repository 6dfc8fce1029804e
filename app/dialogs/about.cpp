// SPDX-License-Identifier: GPL-3.0-or-later
#include "dialogs/about.h"

#include "panels/parts.h"

#include "core/version.h"
#include "panels/icons.h"

#include <QDialogButtonBox>
#include <QGridLayout>
#include <QLabel>

namespace loopmend {

About::About(QWidget* parent) : QDialog(parent) {
  setObjectName(QStringLiteral("about"));
  setWindowTitle(tr("About Loopmend"));
  auto* picture = new QLabel;
  picture->setPixmap(application_icon().pixmap(72, 72));
  auto* text =
      new QLabel(tr("<h2>Loopmend %1</h2>"
                    "<p>Closes holes in scanned meshes with patches whose curvature runs through the seam.</p>"
                    "<p>Free software under the GNU General Public License, version 3 or later: you may use, study, "
                    "share and change "
                    "it. It comes without any warranty.<br><a href=\"https://www.gnu.org/licenses/gpl-3.0.html\">"
                    "gnu.org/licenses/gpl-3.0</a></p>"
                    "<p>Built with Qt, VTK, QCustomPlot, giflib, Eigen, OpenMesh, CGAL and SuiteSparse.</p>")
                     .arg(QLatin1String(version())));
  text->setWordWrap(true);
  text->setOpenExternalLinks(true);
  text->setMinimumWidth(380);
  auto* buttons = make_dialog_buttons(QDialogButtonBox::Close);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* layout = new QGridLayout(this);
  layout->setContentsMargins(20, 20, 20, 16);
  layout->setHorizontalSpacing(20);
  layout->addWidget(picture, 0, 0, Qt::AlignTop);
  layout->addWidget(text, 0, 1);
  layout->addWidget(buttons, 1, 0, 1, 2);
}

}  // namespace loopmend
