// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/choices.h"

#include "document/words.h"
#include "panels/parts.h"
#include "scene/shading.h"

#include <QComboBox>
#include <QCoreApplication>

namespace loopmend {
namespace {

QString tr(const char* text) { return QCoreApplication::translate("loopmend::choices", text); }

}  // namespace

QComboBox* make_flow_choice(const char* name, const QString& help) {
  auto* choice = new QComboBox;
  choice->setObjectName(QLatin1String(name));
  explain(choice, tr("Flow"), help);
  for (FlowKind kind : {FlowKind::mmcvf, FlowKind::wf, FlowKind::sdf, FlowKind::mcf}) {
    choice->addItem(words::flow(kind), static_cast<int>(kind));
    choice->setItemData(choice->count() - 1, words::flow_help(kind), Qt::ToolTipRole);
  }
  choice->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  choice->setMinimumContentsLength(18);
  return choice;
}

QComboBox* make_shading_choice(const char* name, const QString& help) {
  auto* choice = new QComboBox;
  choice->setObjectName(QLatin1String(name));
  explain(choice, tr("Shading"), help);
  for (const auto& [text, shading] : {std::pair{tr("Mean curvature H"), Shading::curvature},
                                      {tr("Gaussian curvature K"), Shading::gaussian},
                                      {tr("Plain"), Shading::plain},
                                      {tr("Zebra"), Shading::zebra},
                                      {tr("Isophotes"), Shading::isophotes}})
    choice->addItem(text, static_cast<int>(shading));
  return choice;
}

}  // namespace loopmend
