#include "app/pages/plot_sets.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QStringList>
#include <algorithm>
#include <utility>

#include "app/shell/preferences/preference_store.h"

namespace terratact {
namespace {

constexpr qsizetype kMaxSetName = 60, kMaxSignalKey = 200;

bool isKey(const QJsonValue& value)
{
    const QString key = value.toString();
    return value.isString() && !key.isEmpty() && key.size() <= kMaxSignalKey;
}

}  // namespace

QString textOf(const PlotSet& set)
{
    QJsonArray rows;
    for (const auto& row : set.rows) {
        QJsonArray keys;
        for (const std::string& key : row) keys.append(QString::fromStdString(key));
        rows.append(keys);
    }
    const QJsonObject object{{QStringLiteral("name"), set.name}, {QStringLiteral("rows"), rows}};
    return QString::fromUtf8(QJsonDocument(object).toJson(QJsonDocument::Compact));
}

std::optional<PlotSet> plotSetFrom(const QString& text)
{
    const QJsonObject object = QJsonDocument::fromJson(text.toUtf8()).object();
    PlotSet set{object.value(QStringLiteral("name")).toString().simplified(), {}};
    if (set.name.isEmpty() || set.name.size() > kMaxSetName) return std::nullopt;
    const QJsonArray rows = object.value(QStringLiteral("rows")).toArray();
    if (static_cast<std::size_t>(rows.size()) > PlotsState::kMaxRows) return std::nullopt;
    for (const QJsonValue row : rows) {
        const QJsonArray keys = row.toArray();
        if (keys.isEmpty() || static_cast<std::size_t>(keys.size()) > PlotsState::kMaxInRow
            || !std::all_of(keys.begin(), keys.end(), isKey))
            return std::nullopt;
        std::vector<std::string>& made = set.rows.emplace_back();
        for (const QJsonValue key : keys) made.push_back(key.toString().toStdString());
    }
    return set;
}

std::vector<PlotSet> savedPlotSets(const PreferenceStore& preferences)
{
    std::vector<PlotSet> sets;
    for (const QString& text : preferences.current().plotSets)
        if (auto set = plotSetFrom(text)) sets.push_back(std::move(*set));
    return sets;
}

void savePlotSet(PreferenceStore& preferences, const PlotSet& set)
{
    std::vector<PlotSet> sets = savedPlotSets(preferences);
    std::erase_if(sets, [&](const PlotSet& s) { return s.name == set.name; });
    if (!set.rows.empty()) sets.push_back(set);
    QStringList texts;
    for (const PlotSet& s : sets) texts << textOf(s);
    while (texts.size() > kMaxPlotSets) texts.removeFirst();
    preferences.change([&texts](Preferences& p) { p.plotSets = texts; });
}

}  // namespace terratact
