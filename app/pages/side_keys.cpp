#include "app/pages/side_keys.h"

#include <QActionGroup>
#include <QCoreApplication>
#include <QMenu>
#include <array>

#include "app/shell/key_table.h"
#include "widgets/terrain/terrain_profile_view.h"

namespace terratact {
namespace {

struct SideKeyWords {
    Q_DECLARE_TR_FUNCTIONS(SideKeys)
};

struct SideChoice {
    ShownSides sides;
    Qt::Key key;  ///< with Alt
    const char* meaning;
    const char* withProbes;
};

constexpr std::array kSideChoices{
    SideChoice{ShownSides::Left, Qt::Key_L, QT_TRANSLATE_NOOP("SideKeys", "show the left side"),
               QT_TRANSLATE_NOOP("SideKeys", "show the left side, and probe there")},
    SideChoice{ShownSides::Right, Qt::Key_R, QT_TRANSLATE_NOOP("SideKeys", "show the right side"),
               QT_TRANSLATE_NOOP("SideKeys", "show the right side, and probe there")},
    SideChoice{ShownSides::Both, Qt::Key_B, QT_TRANSLATE_NOOP("SideKeys", "show both sides"),
               QT_TRANSLATE_NOOP("SideKeys", "show both sides, and probe the side in full")}};

}  // namespace

void addSideKeys(KeyTable& keys, TerrainProfileView& view, bool probes)
{
    for (const SideChoice& choice : kSideChoices)
        keys.add({.keys = {QKeyCombination(Qt::ALT, choice.key)},
                  .meaning = SideKeyWords::tr(probes ? choice.withProbes : choice.meaning),
                  .pressed = [&view, sides = choice.sides] { view.setShownSides(sides); },
                  .applies = [&view] { return view.isVisible(); }});
}

void addSideChoice(QMenu& menu, TerrainProfileView& view)
{
    auto* group = new QActionGroup(&menu);
    for (const SideChoice& choice : kSideChoices) {
        const QKeySequence key(QKeyCombination(Qt::ALT, choice.key));
        QAction* action = menu.addAction(QStringLiteral("%1 (%2)").arg(
            SideKeyWords::tr(choice.withProbes), key.toString(QKeySequence::NativeText)));
        action->setCheckable(true);
        group->addAction(action);
        QObject::connect(action, &QAction::triggered, &view,
                         [&view, sides = choice.sides] { view.setShownSides(sides); });
        QObject::connect(&menu, &QMenu::aboutToShow, action, [action, &view, sides = choice.sides] {
            action->setChecked(view.shownSides() == sides);
        });
    }
}

}  // namespace terratact
