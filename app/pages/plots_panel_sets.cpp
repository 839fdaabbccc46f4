// The saved sets of the plots.
#include <QComboBox>
#include <utility>

#include "app/pages/plot_sets.h"
#include "app/pages/plots_panel.h"
#include "app/shell/preferences/preference_store.h"

namespace terratact {

void PlotsPanel::showSets()
{
    const QString entered = sets_->currentText();
    sets_->clear();
    for (const PlotSet& set : savedPlotSets(preferences_))
        if (set.name != kLastPlotSet) sets_->addItem(set.name);
    sets_->setCurrentIndex(-1);
    sets_->setEditText(entered);
}

void PlotsPanel::useSet(const QString& name)
{
    for (PlotSet& set : savedPlotSets(preferences_))
        if (set.name == name.simplified()) state_.setRows(std::move(set.rows));
    full_.clear();
    chosenChanged();
}

void PlotsPanel::saveSet()
{
    const QString name = sets_->currentText().simplified();
    if (name.isEmpty() || name == kLastPlotSet) {
        full_ = tr("Enter a name for the set first");
        return showNote();
    }
    full_ = state_.rows().empty() ? tr("There is no plot to save") : tr("Saved: %1").arg(name);
    if (!state_.rows().empty()) savePlotSet(preferences_, {name, state_.rows()});
    showSets();
    showNote();
}

void PlotsPanel::deleteSet()
{
    const QString name = sets_->currentText().simplified();
    if (name.isEmpty() || name == kLastPlotSet) return;
    savePlotSet(preferences_, {name, {}});
    sets_->setEditText({});
    showSets();
    full_ = tr("Deleted: %1").arg(name);
    showNote();
}

}  // namespace terratact
