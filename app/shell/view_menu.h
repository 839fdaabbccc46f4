#pragma once

#include <QList>
#include <QMenu>
#include <functional>

#include "app/shell/key_table.h"
#include "app/shell/preference_store.h"

namespace terratact {

/// One way to see the console: a layout, a theme or a size of the letters.
struct ViewChoice {
    QString name;
    QList<QKeyCombination> keys;  ///< may be empty
    std::function<void(Preferences&)> edit;
    std::function<bool(const Preferences&)> chosen;  ///< null: it is a step, not a state
    bool needsNewWindow = false;                     ///< to be seen
};

/// In the order of the menu; an empty name stands for a separator.
QList<ViewChoice> viewChoices();

void addViewKeys(KeyTable& keys, PreferenceStore& preferences);  ///< of the choices that have any

/// The menu of them.  newWindow: when there is one, in words.
class ViewMenu final : public QMenu {
    Q_OBJECT
public:
    ViewMenu(PreferenceStore& preferences, const QString& newWindow, QWidget* parent = nullptr);
};

}  // namespace terratact
