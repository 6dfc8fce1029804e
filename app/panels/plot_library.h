// SPDX-License-Identifier: GPL-3.0-or-later
// QCustomPlot, which uses Qt's keywords: given to it here, and taken away again.
#pragma once

#include <QObject>

#define signals Q_SIGNALS
#define slots Q_SLOTS
#define emit
#define foreach Q_FOREACH
#include <qcustomplot.h>
#undef signals
#undef slots
#undef emit
#undef foreach
