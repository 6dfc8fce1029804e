// SPDX-License-Identifier: GPL-3.0-or-later
#include "dialogs/command_palette.h"

#include "panels/parts.h"

#include <QAction>
#include <QKeyEvent>
#include <QLineEdit>
#include <QListWidget>
#include <QPainter>
#include <QPointer>
#include <QSet>
#include <QStyledItemDelegate>
#include <QTimer>
#include <QVBoxLayout>

#include <algorithm>

namespace loopmend {
namespace {

constexpr int keys_role = Qt::UserRole, group_role = Qt::UserRole + 1, entry_role = Qt::UserRole + 2;
constexpr int palette_width = 520, rows_shown = 12;

/// Letters alone: "Copy command line" for "&Copy command line".
QString plain(const QString& text) {
  QString words = text;
  return words.remove(QLatin1Char('&')).remove(QChar(0x2026)).trimmed();
}

/// One word of what was typed.
int fit_of_word(const QString& word, const QString& command) {
  constexpr int at_start = 8, inside = 4, scattered = 1;
  const int at = command.indexOf(word, 0, Qt::CaseInsensitive);
  for (int k = at; k >= 0; k = command.indexOf(word, k + 1, Qt::CaseInsensitive))
    if (k == 0 || !command[k - 1].isLetterOrNumber()) return at_start;
  if (at >= 0) return inside;
  int next = 0;
  for (const QChar letter : command)
    if (next < word.size() && letter.toLower() == word[next].toLower()) ++next;
  return next == word.size() && word.size() > 2 ? scattered : 0;
}

/// Name at the left, menu and keys at the right.
class EntryDelegate : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;
  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex&) const override {
    return {palette_width, option.fontMetrics.lineSpacing() + 10};
  }
  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    const bool selected = option.state.testFlag(QStyle::State_Selected);
    const bool enabled = index.flags().testFlag(Qt::ItemIsEnabled);
    if (selected) painter->fillRect(option.rect, option.palette.highlight());
    const auto group = enabled ? QPalette::Active : QPalette::Disabled;
    const QColor ink = option.palette.color(group, selected ? QPalette::HighlightedText : QPalette::Text);
    QColor quiet = ink;
    quiet.setAlphaF(0.6);
    const QRect row = option.rect.adjusted(10, 0, -10, 0);
    const QString keys = index.data(keys_role).toString(), menu = index.data(group_role).toString();
    constexpr int keys_width = 110;
    painter->setPen(ink);
    painter->drawText(row, Qt::AlignRight | Qt::AlignVCenter, keys);
    painter->setPen(quiet);
    const QRect before_keys = row.adjusted(0, 0, -keys_width, 0);
    painter->drawText(before_keys, Qt::AlignRight | Qt::AlignVCenter, menu);
    painter->setPen(ink);
    const int room = before_keys.width() - option.fontMetrics.horizontalAdvance(menu) - 12;
    painter->drawText(before_keys, Qt::AlignLeft | Qt::AlignVCenter,
                      option.fontMetrics.elidedText(index.data().toString(), Qt::ElideRight, room));
  }
};

}  // namespace

int fit_of(const QString& typed, const QString& command) {
  int sum = 1;
  for (const QString& word : typed.split(QLatin1Char(' '), Qt::SkipEmptyParts)) {
    const int fit = fit_of_word(word, command);
    if (fit == 0) return 0;
    sum += fit;
  }
  return sum;
}

CommandPalette::CommandPalette(const std::vector<Group>& groups, QWidget* parent)
    : QDialog(parent, Qt::Popup),
      typed_(new QLineEdit),
      found_(new QListWidget) {
  setObjectName(QStringLiteral("commandPalette"));
  setWindowTitle(tr("Find a command"));
  QSet<QAction*> known;
  for (const Group& group : groups)
    for (QAction* action : group.actions) {
      if (action->isSeparator() || known.contains(action)) continue;
      known.insert(action);
      entries_.push_back({action, plain(action->text()), plain(group.title)});
    }
  typed_->setPlaceholderText(tr("Type some letters of a command"));
  explain(typed_, "commandTyped", tr("Find a command"),
          tr("Type some letters of a command; Return runs the first one"));
  explain(found_, "commandList", tr("Commands"), tr("The commands that fit, the best one first"));
  found_->setItemDelegate(new EntryDelegate(found_));
  found_->setFocusPolicy(Qt::NoFocus);
  found_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  found_->setFrameShape(QFrame::NoFrame);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(8, 8, 8, 8);
  layout->addWidget(typed_);
  layout->addWidget(found_);
  typed_->installEventFilter(this);
  connect(typed_, &QLineEdit::textChanged, this, &CommandPalette::find);
  connect(typed_, &QLineEdit::returnPressed, this, &CommandPalette::run);
  connect(found_, &QListWidget::itemClicked, this, &CommandPalette::run);
  find();
  const int row = found_->sizeHintForRow(0);
  resize(palette_width, typed_->sizeHint().height() + rows_shown * row + 34);
  if (parent) move(parent->mapToGlobal(QPoint((parent->width() - width()) / 2, 84)));
  typed_->setFocus();
}

void CommandPalette::find() {
  const QString typed = typed_->text();
  std::vector<std::pair<int, std::size_t>> order;
  for (std::size_t k = 0; k < entries_.size(); ++k) {
    const Entry& entry = entries_[k];
    // The help says what the command does in other words; a fit there counts least.
    const int by_name = 10 * fit_of(typed, entry.text),
              by_help = fit_of(
                  typed, entry.text + QLatin1Char(' ') + entry.group + QLatin1Char(' ') + entry.action->statusTip());
    if (const int fit = std::max(by_name, by_help); fit > 0)
      order.emplace_back(-fit - (entry.action->isEnabled() ? 1 : 0), k);
  }
  if (!typed.trimmed().isEmpty()) std::sort(order.begin(), order.end());
  found_->clear();
  for (const auto& [fit, k] : order) {
    const Entry& entry = entries_[k];
    auto* item = new QListWidgetItem(entry.action->isChecked() ? entry.text + QStringLiteral(" \u2713") : entry.text);
    item->setData(keys_role, entry.action->shortcut().toString(QKeySequence::NativeText));
    item->setData(group_role, entry.group);
    item->setData(entry_role, static_cast<int>(k));
    item->setToolTip(entry.action->statusTip());
    if (!entry.action->isEnabled()) item->setFlags(item->flags() & ~Qt::ItemIsEnabled);
    found_->addItem(item);
  }
  found_->setCurrentRow(found_->count() > 0 ? 0 : -1);
}

bool CommandPalette::eventFilter(QObject* watched, QEvent* event) {
  if (watched != typed_ || event->type() != QEvent::KeyPress) return QDialog::eventFilter(watched, event);
  const int key = static_cast<QKeyEvent*>(event)->key();
  const int step = key == Qt::Key_Down       ? 1
                   : key == Qt::Key_Up       ? -1
                   : key == Qt::Key_PageDown ? rows_shown
                   : key == Qt::Key_PageUp   ? -rows_shown
                                             : 0;
  if (step == 0) return QDialog::eventFilter(watched, event);
  if (found_->count() > 0) found_->setCurrentRow(std::clamp(found_->currentRow() + step, 0, found_->count() - 1));
  return true;
}

/// When the palette has gone: what is asked for may open a dialog, or act on what has the focus.
void CommandPalette::run() {
  const QListWidgetItem* item = found_->currentItem();
  if (!item || !item->flags().testFlag(Qt::ItemIsEnabled)) return;
  const QPointer<QAction> action = entries_[item->data(entry_role).toInt()].action;
  close();
  QTimer::singleShot(0, parentWidget(), [action] {
    if (action) action->trigger();
  });
}

}  // namespace loopmend
