// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/choices.h"

#include "document/labels.h"
#include "evolution/evolution.h"
#include "panels/parts.h"
#include "scene/shading.h"

#include <QComboBox>
#include <QCoreApplication>

namespace loopmend {
namespace {

QString tr(const char* text) { return QCoreApplication::translate("loopmend", text); }

}  // namespace

QComboBox* make_flow_choice(const char* name, const QString& help) {
  auto* choice = new QComboBox;
  choice->setObjectName(QLatin1String(name));
  explain(choice, tr("Flow"), help);
  for (FlowKind kind : {FlowKind::mmcvf, FlowKind::wf, FlowKind::sdf, FlowKind::mcf}) {
    choice->addItem(labels::flow(kind), static_cast<int>(kind));
    choice->setItemData(choice->count() - 1, labels::flow_help(kind), Qt::ToolTipRole);
  }
  choice->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  choice->setMinimumContentsLength(18);
  return choice;
}

QComboBox* make_boundary_choice(const char* name) {
  auto* choice = new QComboBox;
  choice->setObjectName(QLatin1String(name));
  explain(choice, tr("Boundary"), tr("How far MMCVF trusts the curvature of the scan around the hole"));
  const auto add = [&](const QString& text, BoundaryTrust boundary, const QString& help) {
    choice->addItem(text, static_cast<int>(boundary));
    choice->setItemData(choice->count() - 1, help, Qt::ToolTipRole);
  };
  add(tr("Auto"), BoundaryTrust::automatic,
      tr("As far as it can be trusted: the flow, on rough and noisy scans on the smooth surface under them."));
  add(tr("Exact"), BoundaryTrust::exact, tr("As it is: the flow itself, also on rough scans."));
  add(tr("Robust"), BoundaryTrust::robust, tr("Hardly: robust fairing in place of the flow."));
  return choice;
}

QComboBox* make_continuity_choice(const char* name) {
  auto* choice = new QComboBox;
  choice->setObjectName(QLatin1String(name));
  explain(choice, tr("Continuity"), tr("What MMCVF makes run through the seam"));
  const auto add = [&](const QString& text, SeamContinuity continuity, const QString& help) {
    choice->addItem(text, static_cast<int>(continuity));
    choice->setItemData(choice->count() - 1, help, Qt::ToolTipRole);
  };
  add(tr("Curvature"), SeamContinuity::curvature, tr("Position, tangent and curvature: the flow itself."));
  add(tr("Tangent"), SeamContinuity::tangent, tr("Position and tangent: linear fairing in place of the flow."));
  add(tr("Position"), SeamContinuity::position, tr("Position alone: a taut skin, with a crease at the seam."));
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
