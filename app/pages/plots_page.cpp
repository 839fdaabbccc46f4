#include "app/pages/plots_page.h"

#include <QPushButton>
#include <QVBoxLayout>

#include "app/runtime/steady_now.h"
#include "app/shell/console_window.h"
#include "app/shell/key_table.h"
#include "widgets/base/navigation_rail.h"

namespace terratact {

PlotsPage::PlotsPage(PlotSource& source, PreferenceStore& preferences, PlotsPanel::Kind kind,
                     QWidget* parent)
    : Page(parent), panel_(new PlotsPanel(source, preferences, kind, this))
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(panel_);
}

void PlotsPage::dockIn(ConsoleWindow& window)
{
    const auto places = [this, &window] { place(window); };
    connect(panel_, &PlotsPanel::dockWanted, this, places);
    connect(window.rail(), &NavigationRail::pageChosen, this, places);
}

void PlotsPage::place(ConsoleWindow& window)
{
    const bool isHere = window.rail()->chosen() == window.rail()->pageOf(kPlotsKey);
    const bool docks = panel_->dockButton()->isChecked() && !isHere;
    if (docks == (panel_->parentWidget() != this)) return;
    panel_->setDocked(docks);
    if (docks) {
        window.setDock(panel_);
        return;
    }
    window.setDock(nullptr);
    layout()->addWidget(panel_);
    panel_->show();
}

void PlotsPage::addKeys(KeyTable& keys)
{
    keys.add({{QKeyCombination(Qt::CTRL, Qt::Key_P)},
              tr("plots below every page, and back"),
              [this] { panel_->dockButton()->toggle(); }});
}

void PlotsPage::showEvent(QShowEvent* event)
{
    Page::showEvent(event);
    panel_->refresh(steadyNow(), true);
}

}  // namespace terratact
