#include "app/mission/text/preset_text.h"

#include <QCoreApplication>
#include <algorithm>

#include "app/display/format.h"
#include "app/display/translated.h"

namespace terratact {
namespace {

struct PresetWords {
    Q_DECLARE_TR_FUNCTIONS(PresetWords)
};

/// The numbers of a preset as text.
struct CostWords {
    QString name, milliseconds, error, off, converged;
};

CostWords costText(const PresetCost& cost)
{
    return {translated(describe(cost.preset)), format::number(cost.milliseconds, 1),
            format::number(cost.errorMm, 0), format::number(cost.offMm, 1),
            format::number(100.0 * cost.converged, 0)};
}

template <class Show>
QStringList ofEach(Method method, std::span<const PresetCost> costs, const QString& unmeasured,
                   const Show& show)
{
    QStringList lines;
    // The trade-off measures single scenes. Trail takes as long there, and its errors are no larger.
    if (method == Method::Trail) method = Method::Local;
    for (const QualityPreset preset : kQualityPresets) {
        const auto cost = std::find_if(costs.begin(), costs.end(), [&](const PresetCost& c) {
            return c.method == method && c.preset == preset;
        });
        lines << (cost == costs.end() ? unmeasured.arg(translated(describe(preset)))
                                      : show(costText(*cost)));
    }
    return lines;
}

}  // namespace

QStringList presetLines(Method method, std::span<const PresetCost> costs)
{
    const QString unmeasured = PresetWords::tr("%1: not measured (terratact tradeoff)");
    return ofEach(method, costs, unmeasured, [method](const CostWords& cost) {
        return isClosedForm(method)
                 ? PresetWords::tr("%1: %2 ms, exact quantiles by a formula, mean error %3 mm")
                       .arg(cost.name, cost.milliseconds, cost.error)
                 : PresetWords::tr(
                       "%1: %2 ms, quantiles ± %3 mm from a long run, mean error %4 mm; chains "
                       "converge in %5 % of scenes, and only these have a verdict")
                       .arg(cost.name, cost.milliseconds, cost.off, cost.error, cost.converged);
    });
}

QStringList presetEntries(Method method, std::span<const PresetCost> costs)
{
    const QString unmeasured = PresetWords::tr("%1: not measured");
    return ofEach(method, costs, unmeasured, [method](const CostWords& cost) {
        return isClosedForm(method)
                 ? PresetWords::tr("%1: %2 ms, %3 mm (exact)")
                       .arg(cost.name, cost.milliseconds, cost.error)
                 : PresetWords::tr("%1: %2 ms, %3 mm (± %4 mm), %5 % converge")
                       .arg(cost.name, cost.milliseconds, cost.error, cost.off, cost.converged);
    });
}

}  // namespace terratact
