#include "app/console/profile_menu.h"

#include <QActionGroup>

#include "app/display/format.h"
#include "app/mission/exploration.h"
#include "app/mission/text/method_text.h"
#include "app/pages/side_keys.h"
#include "widgets/base/tips.h"
#include "widgets/terrain/terrain_profile_view.h"

namespace terratact {

ProfileMenu::ProfileMenu(TerrainProfileView& view, Exploration& exploration, QWidget* parent)
    : QMenu(parent), draws_(addAction(tr("Some of the draws as thin lines (D)")))
{
    draws_->setCheckable(true);
    connect(draws_, &QAction::toggled, &view, &TerrainProfileView::setDrawsShown);
    addSeparator();
    addSideChoice(*this, view);
    addSeparator();
    offerSecondMethods(exploration);
    addSeparator();
    connect(addAction(tr("Estimates of this run … (Ctrl+H)")), &QAction::triggered, this,
            &ProfileMenu::historyWanted);
    restore_ = addAction(tr("Restore the hidden estimate (Ctrl+Z)"));
    connect(restore_, &QAction::triggered, &exploration, &Exploration::restoreResult);
    connect(this, &QMenu::aboutToShow, this,
            [this, &exploration] { restore_->setEnabled(exploration.canRestore()); });
}

void ProfileMenu::offerSecondMethods(Exploration& exploration)
{
    QAction* title = addAction(tr("A second method beside it"));
    title->setEnabled(false);  // addSection() shows no title with a style sheet
    auto* group = new QActionGroup(this);
    setToolTipsVisible(true);
    const auto offer = [&](const QString& text, std::optional<Method> method) {
        QAction* action = addAction(text);
        if (method) setTip(*action, methodUses(*method));
        action->setCheckable(true);
        action->setChecked(method == exploration.estimation().secondMethod());
        group->addAction(action);
        connect(action, &QAction::triggered, &exploration,
                [&exploration, method] { exploration.setSecondMethod(method); });
    };
    offer(tr("none"), std::nullopt);
    for (const Method method : offeredMethods()) offer(format::text(name(method)), method);
}

}  // namespace terratact
