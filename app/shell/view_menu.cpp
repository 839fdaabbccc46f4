#include "app/shell/view_menu.h"

#include <QAction>
#include <QKeySequence>
#include <algorithm>

#include "app/shell/font_fit.h"
#include "widgets/base/theme.h"

namespace terratact {
namespace {

ViewChoice layoutChoice(const QString& name, int key, Layout layout)
{
    return {name,
            {QKeyCombination(Qt::CTRL, static_cast<Qt::Key>(key))},
            [layout](Preferences& p) { p.layout = layout; },
            [layout](const Preferences& p) { return p.layout == layout; }};
}

ViewChoice themeChoice(const QString& name, int key, ThemeName theme)
{
    return {name,
            {QKeyCombination(Qt::CTRL, static_cast<Qt::Key>(key))},
            [theme](Preferences& p) { p.theme = theme; },
            [theme](const Preferences& p) { return p.theme == theme; }};
}

ViewChoice languageChoice(const QString& name, const char* language)
{
    return {ViewMenu::tr("language: %1").arg(name),
            {},
            [language](Preferences& p) { p.language = QLatin1String(language); },
            [language](const Preferences& p) { return p.language == QLatin1String(language); },
            true};
}

ViewChoice fontStep(const QString& name, QList<QKeyCombination> keys, int step)
{
    return {name,
            std::move(keys),
            [step](Preferences& p) {
                // A scale that does not fit the screen was already reduced.
                const int from =
                    step < 0 ? std::min(p.fontScale, lookInForce().fontScale) : p.fontScale;
                p.fontScale = std::clamp(from + step, kSmallestFont, kLargestFont);
            },
            {}};
}

}  // namespace

QList<ViewChoice> viewChoices()
{
    const auto normal = [](Preferences& p) { p.fontScale = 100; };
    const auto reset = [](Preferences& p) {
        p.layout = Layout::Probe;
        p.fontScale = 100;
    };
    return {
        layoutChoice(ViewMenu::tr("layout: drive"), Qt::Key_1, Layout::Drive),
        layoutChoice(ViewMenu::tr("layout: probe"), Qt::Key_2, Layout::Probe),
        layoutChoice(ViewMenu::tr("layout: review"), Qt::Key_3, Layout::Review),
        {ViewMenu::tr("default layout and text size"),
         {QKeyCombination(Qt::CTRL, Qt::Key_Home)},
         reset,
         {}},
        {},
        themeChoice(ViewMenu::tr("colours: day"), Qt::Key_4, ThemeName::Day),
        themeChoice(ViewMenu::tr("colours: night, red"), Qt::Key_5, ThemeName::NightRed),
        themeChoice(ViewMenu::tr("colours: high contrast"), Qt::Key_6, ThemeName::HighContrast),
        {},
        // Some keyboards have plus on a shifted key.
        fontStep(
            ViewMenu::tr("larger text"),
            {QKeyCombination(Qt::CTRL, Qt::Key_Plus), QKeyCombination(Qt::CTRL, Qt::Key_Equal)},
            +kFontStep),
        fontStep(ViewMenu::tr("smaller text"), {QKeyCombination(Qt::CTRL, Qt::Key_Minus)},
                 -kFontStep),
        {ViewMenu::tr("normal text size"), {QKeyCombination(Qt::CTRL, Qt::Key_0)}, normal, {}},
        {},
        languageChoice(QStringLiteral("English"), "en"),
        languageChoice(QStringLiteral("čeština"), "cs"),
        languageChoice(QStringLiteral("Deutsch"), "de"),
    };
}

void addViewKeys(KeyTable& keys, PreferenceStore& preferences)
{
    for (const ViewChoice& choice : viewChoices())
        if (!choice.keys.isEmpty())
            keys.add({choice.keys, choice.name,
                      [&preferences, edit = choice.edit] { preferences.change(edit); }});
}

ViewMenu::ViewMenu(PreferenceStore& preferences, const QString& newWindow, QWidget* parent)
    : QMenu(parent)
{
    for (const ViewChoice& choice : viewChoices()) {
        if (choice.name.isEmpty()) {
            addSeparator();
            continue;
        }
        QString text = choice.name;
        if (choice.needsNewWindow) text += QStringLiteral(" (%1)").arg(newWindow);
        if (!choice.keys.isEmpty())
            text += QLatin1Char('\t')
                  + QKeySequence(choice.keys.first()).toString(QKeySequence::NativeText);
        QAction* action = addAction(text);
        connect(action, &QAction::triggered, this,
                [&preferences, choice] { preferences.change(choice.edit); });
        if (!choice.chosen) continue;
        action->setCheckable(true);
        connect(this, &QMenu::aboutToShow, action, [&preferences, choice, action] {
            action->setChecked(choice.chosen(preferences.current()));
        });
    }
    QAction* note = addAction(QString());
    note->setEnabled(false);
    connect(this, &QMenu::aboutToShow, note, [&preferences, note] {
        note->setText(fontNote(preferences.current().fontScale));
        note->setVisible(!note->text().isEmpty());
    });
}

}  // namespace terratact
