// SPDX-License-Identifier: GPL-3.0-or-later
#include "dialogs/preferences_dialog.h"

#include "panels/look_panel.h"
#include "panels/parts.h"
#include "scene/color_map.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QScopedValueRollback>
#include <QSpinBox>

namespace loopmend {

PreferencesDialog::PreferencesDialog(const Preferences& preferences, QWidget* parent)
    : QDialog(parent),
      preferences_(preferences) {
  setObjectName(QStringLiteral("preferencesDialog"));
  setWindowTitle(tr("Preferences"));
  build();
  show_values();
  for (QComboBox* box : {language_, theme_, map_})
    connect(box, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &PreferencesDialog::take);
  for (QSpinBox* box : {undo_, timeline_, autosave_})
    connect(box, QOverload<int>::of(&QSpinBox::valueChanged), this, &PreferencesDialog::take);
}

void PreferencesDialog::build() {
  auto* form = new QFormLayout(this);
  form->setContentsMargins(18, 18, 18, 14);
  form->setVerticalSpacing(10);
  const auto combo = [](const char* name, const QString& title, const QString& help) {
    auto* box = new QComboBox;
    box->setObjectName(QLatin1String(name));
    explain(box, title, help);
    return box;
  };
  const auto number = [](const char* name, const QString& title, const QString& help, int low, int high,
                         const QString& unit) {
    auto* box = new QSpinBox;
    box->setObjectName(QLatin1String(name));
    box->setRange(low, high);
    box->setSuffix(QLatin1Char(' ') + unit);
    box->setKeyboardTracking(false);
    explain(box, title, help);
    return box;
  };
  language_ = combo("language", tr("Language"), tr("Counts when the program starts the next time"));
  language_->addItem(tr("As the system has it"), QString());
  language_->addItem(QStringLiteral("English"), QStringLiteral("en"));
  language_->addItem(QStringLiteral("Deutsch"), QStringLiteral("de"));
  theme_ = combo("theme", tr("Colours of the window"), tr("Light or dark"));
  theme_->addItem(tr("As the system has it"), static_cast<int>(Theme::system));
  theme_->addItem(tr("Light"), static_cast<int>(Theme::light));
  theme_->addItem(tr("Dark"), static_cast<int>(Theme::dark));
  map_ = combo("defaultMap", tr("Colours of curvature"), tr("The colours to begin with"));
  for (ColorMap map : all_color_maps) map_->addItem(color_map_name(map), QLatin1String(to_string(map)));
  undo_ = number("undoMemory", tr("Memory for undo"), tr("Above this, the oldest changes can no longer be taken back"),
                 64, 8192, tr("MB"));
  timeline_ = number("timelineMemory", tr("Memory for each timeline"),
                     tr("Above this, every second recorded state of a patch is forgotten"), 16, 4096, tr("MB"));
  autosave_ = number("autosaveDelay", tr("Copy for recovery after"),
                     tr("This long after a change, a copy is written that survives a crash"), 5, 600, tr("s"));
  form->addRow(tr("&Language"), language_);
  form->addRow(tr("&Window"), theme_);
  form->addRow(tr("C&urvature"), map_);
  form->addRow(tr("Memory for un&do"), undo_);
  form->addRow(tr("Memory for each &timeline"), timeline_);
  form->addRow(tr("Copy for &recovery after"), autosave_);
  auto* note =
      make_note("preferencesNote", tr("Every change counts at once; another language from the next start on."));
  form->addRow(note);
  auto* buttons = make_dialog_buttons(QDialogButtonBox::RestoreDefaults | QDialogButtonBox::Close);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(buttons->button(QDialogButtonBox::RestoreDefaults), &QPushButton::clicked, this, [this] {
    preferences_ = Preferences{};
    show_values();
    Q_EMIT chosen(preferences_);
  });
  form->addRow(buttons);
}

void PreferencesDialog::show_values() {
  const QScopedValueRollback guard(syncing_, true);
  language_->setCurrentIndex(std::max(0, language_->findData(preferences_.language)));
  theme_->setCurrentIndex(theme_->findData(static_cast<int>(preferences_.theme)));
  map_->setCurrentIndex(std::max(0, map_->findData(preferences_.color_map)));
  undo_->setValue(preferences_.undo_megabytes);
  timeline_->setValue(preferences_.timeline_megabytes);
  autosave_->setValue(preferences_.autosave_seconds);
}

void PreferencesDialog::take() {
  if (syncing_) return;
  preferences_.language = language_->currentData().toString();
  preferences_.theme = static_cast<Theme>(theme_->currentData().toInt());
  preferences_.color_map = map_->currentData().toString();
  preferences_.undo_megabytes = undo_->value();
  preferences_.timeline_megabytes = timeline_->value();
  preferences_.autosave_seconds = autosave_->value();
  Q_EMIT chosen(preferences_);
}

}  // namespace loopmend
