#pragma once

#include <QList>
#include <QMenu>
#include <functional>

#include "app/shell/key_table.h"
#include "app/shell/preferences/preference_store.h"

namespace terratact {

/// An entry of the view menu: a layout, a theme or a font scale.
struct ViewChoice {
    QString name;
    QList<QKeyCombination> keys;  ///< may be empty
    std::function<void(Preferences&)> edit;
    std::function<bool(const Preferences&)> chosen;  ///< null: the entry is a step, not a state
    bool needsNewWindow = false;                     ///< takes effect in a new window
};

/// Returns the entries in the menu's order; an empty name is a separator.
QList<ViewChoice> viewChoices();

void addViewKeys(KeyTable& keys,
                 PreferenceStore& preferences);  ///< adds the keys of the entries that have any

/// The view menu. newWindow: text on when the new window opens.
class ViewMenu final : public QMenu {
    Q_OBJECT
public:
    ViewMenu(PreferenceStore& preferences, const QString& newWindow, QWidget* parent = nullptr);
};

}  // namespace terratact
