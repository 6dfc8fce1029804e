// SPDX-License-Identifier: GPL-3.0-or-later
// The holes table sorted and narrowed down to what a person wants to see.
#pragma once

#include <QSortFilterProxyModel>

namespace loopmend {

class Document;

enum class HoleGroup { all, to_do, filled, accepted, fault, left_out };

class HoleFilter : public QSortFilterProxyModel {
  Q_OBJECT

 public:
  explicit HoleFilter(const Document& document, QObject* parent = nullptr);

  void set_group(HoleGroup group);
  /// Rows where some cell holds all of these words, or whose number is one of them.
  void set_words(const QString& words);
  bool narrowed() const { return group_ != HoleGroup::all || !words_.isEmpty(); }

 protected:
  bool filterAcceptsRow(int row, const QModelIndex& parent) const override;

 private:
  bool in_group(int loop) const;

  const Document& document_;
  HoleGroup group_ = HoleGroup::all;
  QStringList words_;
};

}  // namespace loopmend
