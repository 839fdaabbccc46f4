// The history of estimates at the console's window.
#include "app/console/main_window.h"
#include "app/console/past/history_control.h"
#include "app/console/profile_menu.h"
#include "widgets/base/elided_label.h"
#include "widgets/terrain/terrain_profile_view.h"

namespace terratact {

void MainWindow::addHistory()
{
    history_ = std::make_unique<HistoryControl>(*exploration_, *this);
    connect(history_.get(), &HistoryControl::happened, this, &MainWindow::log);
    connect(profileMenu_, &ProfileMenu::historyWanted, history_.get(), &HistoryControl::open);
    connect(terrain(), &TerrainProfileView::binChosen, this, [this](ProbePlace place) {
        if (!asksInPast()) exploration_->askProbe(place);
    });
}

/// Returns true, and reports it, if a bin was chosen in a picture of the past: no probe goes there.
bool MainWindow::asksInPast()
{
    if (!history_->showsPast()) return false;
    showWhyNot({TR_NOOP("terratact::MainWindow",
                        "no probe requested: the picture shows an earlier estimate")});
    return true;
}

void MainWindow::askProbe()
{
    if (asksInPast()) return;
    const auto best = exploration_->bestProbe();
    if (const auto selected = terrain()->selectedPlace())
        exploration_->askProbe(*selected);
    else if (best)
        exploration_->askProbe({best->bin, best->side});
    else if (const Message why = exploration_->whyNoBestProbe(); !why.empty())
        log(why, EventSeverity::Warning);
    else
        log(TR_NOOP("terratact::MainWindow", "no bin is selected: point at a bin first"),
            EventSeverity::Warning);
}

void MainWindow::showHistory(TerrainViewState& viewState)
{
    history_->apply(viewState);
    const QString text = history_->banner();
    if (text.isEmpty() && !pastBanner_) return;
    if (!pastBanner_) pastBanner_ = addBanner();
    if (pastBanner_->text() != text) pastBanner_->setText(text);
    pastBanner_->setVisible(!text.isEmpty());
}

}  // namespace terratact
