#include "app/mission/text/comparison_text.h"

#include <cmath>

#include "app/display/format.h"
#include "app/display/translated.h"

namespace terratact {
namespace {

constexpr double kAlike = 0.005;  // relative difference that is shown as 0 %

QString millimetres(double metres)
{
    return format::number(1000.0 * metres, 1);
}

ComparisonWords::Row inMillimetres(const QString& what, double before, double after)
{
    return {what, millimetres(before), millimetres(after),
            format::signedNumber(1000.0 * (after - before), 1)};
}

ComparisonWords::Row inPercent(const QString& what, double before, double after)
{
    return {what, format::percent(before), format::percent(after),
            format::signedNumber(100.0 * (after - before), 0)};
}

}  // namespace

QList<ComparisonWords::Row> ComparisonWords::rows(const ModelComparison& c)
{
    const MethodSummary &before = c.before, &after = c.after;
    return {
        inMillimetres(tr("median error near [mm]"), before.near.median, after.near.median),
        inMillimetres(tr("mean error near [mm]"), before.near.mean, after.near.mean),
        inMillimetres(tr("CRPS near [mm]"), before.near.crps, after.near.crps),
        inPercent(tr("80 % band near holds [%]"), before.near.coverage, after.near.coverage),
        inMillimetres(tr("median error, all bins [mm]"), before.all.median, after.all.median),
        inMillimetres(tr("mean error, all bins [mm]"), before.all.mean, after.all.mean),
        inMillimetres(tr("CRPS, all bins [mm]"), before.all.crps, after.all.crps),
        inPercent(tr("80 % band, all bins holds [%]"), before.all.coverage, after.all.coverage),
    };
}

QString ComparisonWords::sentence(const ModelComparison& c)
{
    const double change = c.before.near.mean > 0.0
                            ? (c.after.near.mean - c.before.near.mean) / c.before.near.mean
                            : 0.0;
    const QString scenes = QString::number(c.scenes);
    const QString meanError =
        std::abs(change) < kAlike
            ? tr("Near the robot the new model has the same mean error as the old one on %1 scenes")
                  .arg(scenes)
        : change < 0.0
            ? tr("Near the robot the new model's mean error is %1 % smaller on %2 scenes")
                  .arg(format::percent(-change), scenes)
            : tr("Near the robot the new model's mean error is %1 % larger on %2 scenes")
                  .arg(format::percent(change), scenes);
    return tr("%1; its 80 % bands there cover %2 % of the true heights, the old model's %3 %.")
        .arg(meanError, format::percent(c.after.near.coverage),
             format::percent(c.before.near.coverage));
}

QString ComparisonWords::caution(const ModelComparison& c)
{
    QStringList cautions;
    if (c.newTrained > 0)
        cautions << tr("The new model was trained on %1 of these %2 scenes or near copies, so its "
                       "error looks too small. Choose scenes it has not seen.")
                        .arg(c.newTrained)
                        .arg(c.scenes);
    if (c.oldTrained > 0)
        cautions << tr("The old model was trained on %1 of these %2 scenes or near copies, so its "
                       "error looks too small.")
                        .arg(c.oldTrained)
                        .arg(c.scenes);
    if (!c.nearDifference)
        cautions << tr("Too few drives: the difference may be chance.");
    else if (c.nearDifference->low <= 0.0 && c.nearDifference->high >= 0.0)
        cautions << tr("The difference may be chance: 95 % interval %1 … %2 mm.")
                        .arg(format::signedNumber(1000.0 * c.nearDifference->low, 1),
                             format::signedNumber(1000.0 * c.nearDifference->high, 1));
    if (c.tried < c.inFile)
        cautions << tr("%1 of the file's %2 scenes, evenly picked.").arg(c.tried).arg(c.inFile);
    if (c.scenes < c.tried)
        cautions << tr("%1 scenes left out that only one model or none could estimate (only the "
                       "old %2, only the new %3): %4.")
                        .arg(c.tried - c.scenes)
                        .arg(c.onlyBefore)
                        .arg(c.onlyAfter)
                        .arg(translated(c.whyNot));
    return cautions.join(QLatin1Char(' '));
}

}  // namespace terratact
