#pragma once

#include <QString>
#include <optional>
#include <vector>

#include "app/pages/plots_state.h"

namespace terratact {

class PreferenceStore;

/// A saved choice of plots.
struct PlotSet {
    QString name;
    PlotRows rows;
    bool operator==(const PlotSet&) const = default;
};

/// Return a set as one line of JSON, and back; empty: it is no set. Names have 1 to 60 characters; more rows or
/// signals than plots can have are no set.
QString textOf(const PlotSet& set);
std::optional<PlotSet> plotSetFrom(const QString& text);

/// Name of the set of the plots that were shown last; it is not offered.
inline const QString kLastPlotSet = QStringLiteral("*");

/// Returns the saved sets in the preferences.
std::vector<PlotSet> savedPlotSets(const PreferenceStore& preferences);
/// Replaces the saved set of that name; without rows, removes it.
void savePlotSet(PreferenceStore& preferences, const PlotSet& set);

}  // namespace terratact
