// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/hole_table.h"

#include "document/document.h"
#include "document/labels.h"
#include "document/message_words.h"

#include <cmath>
#include <utility>

namespace loopmend {

namespace {

bool is_number(int column) {
  return column < HoleTable::kind || column == HoleTable::crease || column == HoleTable::deviation;
}

}  // namespace

HoleTable::HoleTable(const Document& document, QObject* parent) : QAbstractTableModel(parent), document_(document) {
  rows_ = document.loop_count();
  connect(&document, &Document::opened, this, &HoleTable::follow_rows);
  connect(&document, &Document::scans_changed, this, &HoleTable::follow_rows);
  for (auto signal : {&Document::opened, &Document::scans_changed, &Document::units_changed})
    connect(&document, signal, this, &HoleTable::follow_unit);
  connect(&document, &Document::holes_changed, this, [this] {
    if (rows_ > 0) Q_EMIT dataChanged(index(0, boundary), index(rows_ - 1, state));
  });
}

void HoleTable::follow_rows() {
  beginResetModel();
  rows_ = document_.loop_count();
  endResetModel();
}

int HoleTable::rowCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : rows_; }

int HoleTable::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : column_count; }

QVariant HoleTable::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rows_) return {};
  const int loop = index.row(), column = index.column();
  switch (role) {
    case Qt::DisplayRole: return text(loop, column);
    case sort_role: return sort_key(loop, column);
    case Qt::ToolTipRole: return tool_tip(loop, column);
    case Qt::TextAlignmentRole:
      return static_cast<int>(Qt::AlignVCenter | (is_number(column) ? Qt::AlignRight : Qt::AlignLeft));
    default: return {};
  }
}

QVariant HoleTable::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  if (role == Qt::TextAlignmentRole)
    return static_cast<int>(Qt::AlignVCenter | (is_number(section) ? Qt::AlignRight : Qt::AlignLeft));
  if (role == Qt::ToolTipRole) {
    switch (section) {
      case number: return tr("The loop's number within its scan, by falling perimeter");
      case edges: return tr("Number of edges along the boundary");
      case diameter: return tr("Largest distance between two boundary vertices, in the scan's unit");
      case perimeter: return tr("Length of the boundary, in the scan's unit");
      case area: return tr("Area of the boundary's projection to its best plane, in the scan's unit squared");
      case planarity: return tr("How far the boundary leaves its best plane: rms distance divided by the diameter");
      case kind: return tr("Hole, outer rim of a sheet, crack, ...");
      case scan: return tr("The file that the loop belongs to");
      case boundary:
        return tr("How far the scan around the hole can be trusted, known once a flow has run: smooth, noisy or rough");
      case crease:
        return tr(
            "Bend of the surface along the seam, in degrees: 8 % of the seam's edges, at least two, have it or more; "
            "known once the hole is filled; 'edge' where one belongs there, as at a flat base");
      case deviation:
        return tr(
            "How far the patch is likely from what was there (80 %), in the scan's unit; known once the hole is "
            "filled");
      case state:
        return tr(
            "The verdict on the patch, or what has been done about the hole; sorted, those to look at come first");
      default: return {};
    }
  }
  if (role != Qt::DisplayRole) return {};
  switch (section) {
    case number: return tr("#");
    case edges: return tr("Edges");
    case diameter: return with_unit(tr("Diameter"));
    case perimeter: return with_unit(tr("Perimeter"));
    case area: return tr("Area");
    case planarity: return tr("Planarity");
    case kind: return tr("Kind");
    case scan: return tr("Scan");
    case boundary: return tr("Boundary");
    case crease: return tr("Crease");
    case deviation: return tr("Likely off");
    case state: return tr("State");
    default: return {};
  }
}

void HoleTable::follow_unit() {
  const QString now = labels::unit_symbol(document_.unit());
  if (std::exchange(unit_, now) != now) Q_EMIT headerDataChanged(Qt::Horizontal, 0, column_count - 1);
}

QString HoleTable::with_unit(const QString& title) const {
  return unit_.isEmpty() ? title : tr("%1, %2").arg(title, unit_);
}

QVariant HoleTable::text(int loop, int column) const {
  const BoundaryLoop& l = document_.loop(loop);
  switch (column) {
    case number: return QString::number(l.number);
    case edges: return labels::count(static_cast<std::size_t>(l.edges()));
    case perimeter: return labels::number(l.perimeter);
    case diameter: return labels::number(l.diameter);
    case area: return labels::number(l.area);
    case planarity: return labels::number(l.planarity);
    case kind: return labels::kind(l.kind);
    case scan: return document_.present(loop) ? document_.scan(document_.scan_of(loop))->name : QString();
    case boundary: return boundary_of(loop) ? labels::neighborhood(boundary_of(loop)->split.kind()) : QString();
    case crease:
      if (!document_.verdict(loop)) return {};
      return document_.verdict(loop)->crease_deg ? tr("%1\u00b0").arg(std::lround(*document_.verdict(loop)->crease_deg))
                                                 : tr("edge");
    case deviation: {
      const ExpectedDeviation expected = document_.deviation(loop);
      return expected.is_known() ? labels::number(expected.likely) : QString();
    }
    case state: {
      const QString words = labels::verdict_or_state(document_, loop);
      const auto shape = document_.chosen_shape(loop);
      return shape ? tr("%1, %2").arg(words, labels::shape(*shape)) : words;
    }
    default: return {};
  }
}

QVariant HoleTable::sort_key(int loop, int column) const {
  const BoundaryLoop& l = document_.loop(loop);
  switch (column) {
    case number: return l.number;
    case edges: return l.edges();
    case perimeter: return l.perimeter;
    case diameter: return l.diameter;
    case area: return l.area;
    case planarity: return l.planarity;
    case kind: return static_cast<int>(l.kind);
    case scan: return document_.scan_of(loop);
    case boundary: return boundary_of(loop) ? boundary_of(loop)->noise_per_edge : -1;
    case crease: return document_.verdict(loop) ? document_.verdict(loop)->crease_deg.value_or(0) : -1;
    case deviation: return document_.deviation(loop).is_known() ? document_.deviation(loop).likely : -1;
    case state: return labels::urgency(document_.state(loop));
    default: return {};
  }
}

/// Of the last recorded state. Null where no flow has run, or the hole was too small for an estimate.
const BoundarySummary* HoleTable::boundary_of(int loop) const {
  const OpenPatch* patch = document_.patch_of(loop);
  if (!patch) return nullptr;
  const std::vector<BoundarySummary>& known = patch->timeline->back()->neighborhood;
  const std::size_t k = patch->place_of(loop);
  return k < known.size() ? &known[k] : nullptr;
}

QVariant HoleTable::tool_tip(int loop, int column) const {
  if (column == kind) return labels::kind_help(document_.loop(loop).kind);
  if (column == boundary) return boundary_of(loop) ? labels::boundary_help(*boundary_of(loop)) : QString();
  if (column < crease) return {};
  const QString more = labels::in_words(document_.message(loop));
  const Verdict* verdict = document_.verdict(loop);
  QString help = labels::state_help(document_.state(loop));
  if (verdict && verdict->grade != Grade::good) help += QLatin1Char(' ') + labels::sentence_of(*verdict);
  if (const auto shape = document_.chosen_shape(loop)) help += QLatin1Char(' ') + labels::shape_help(*shape);
  return more.isEmpty() ? help : help + QLatin1Char(' ') + labels::sentence(more);
}

}  // namespace loopmend
