#include "document/hole_table.h"

#include "document/document.h"
#include "document/words.h"

#include <QColor>

namespace loopmend {

HoleTable::HoleTable(const Document& document, QObject* parent) : QAbstractTableModel(parent), document_(document) {
  connect(&document, &Document::opened, this, [this] {
    beginResetModel();
    rows_ = static_cast<int>(document_.loops().size());
    endResetModel();
  });
  connect(&document, &Document::holes_changed, this, [this] {
    if (rows_ > 0) Q_EMIT dataChanged(index(0, state), index(rows_ - 1, state));
  });
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
      return static_cast<int>(Qt::AlignVCenter | (column < kind ? Qt::AlignRight : Qt::AlignLeft));
    default: return {};
  }
}

QVariant HoleTable::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  if (role == Qt::TextAlignmentRole)
    return static_cast<int>(Qt::AlignVCenter | (section < kind ? Qt::AlignRight : Qt::AlignLeft));
  if (role == Qt::ToolTipRole) {
    if (section == perimeter) return tr("Length of the rim, in the scan's unit");
    if (section == diameter) return tr("Largest distance between two rim vertices, in the scan's unit");
    if (section == edges) return tr("Number of edges along the rim");
    return {};
  }
  if (role != Qt::DisplayRole) return {};
  switch (section) {
    case number: return tr("#");
    case edges: return tr("Edges");
    case perimeter: return tr("Perimeter");
    case diameter: return tr("Diameter");
    case kind: return tr("Kind");
    case state: return tr("State");
    default: return {};
  }
}

QVariant HoleTable::text(int loop, int column) const {
  const BoundaryLoop& l = document_.loops()[static_cast<std::size_t>(loop)];
  switch (column) {
    case number: return QString::number(l.number);
    case edges: return QString::number(l.edges());
    case perimeter: return words::number(l.perimeter);
    case diameter: return words::number(l.diameter);
    case kind: return words::kind(l.kind);
    case state: return words::state(document_.state(loop));
    default: return {};
  }
}

QVariant HoleTable::sort_key(int loop, int column) const {
  const BoundaryLoop& l = document_.loops()[static_cast<std::size_t>(loop)];
  switch (column) {
    case number: return l.number;
    case edges: return l.edges();
    case perimeter: return l.perimeter;
    case diameter: return l.diameter;
    case kind: return static_cast<int>(l.kind);
    case state: return static_cast<int>(document_.state(loop));
    default: return {};
  }
}

QVariant HoleTable::tool_tip(int loop, int column) const {
  if (column == kind) return words::kind_help(document_.loops()[static_cast<std::size_t>(loop)].kind);
  if (column != state) return {};
  const QString more = document_.message(loop);
  const QString help = words::state_help(document_.state(loop));
  return more.isEmpty() ? help : help + QLatin1Char(' ') + more;
}

}  // namespace loopmend
