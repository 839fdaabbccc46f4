#include "app/console/past/past_text.h"

#include <QStringList>

#include "app/display/format.h"
#include "app/display/place_text.h"
#include "app/mission/estimate_history.h"
#include "widgets/terrain/readings/verdict_strip.h"

namespace terratact {
namespace {

QString answerText(StepVerdict answer)
{
    Verdict plain;
    plain.stepVerdict = answer;
    return VerdictStrip::answerOf(plain);
}

}  // namespace

QString PastText::time(const PastEstimate& past)
{
    return past.at.toString(QStringLiteral("HH:mm:ss"));
}

QString PastText::verdict(const PastEstimate& past)
{
    if (!past.verdict) return tr("no verdict");
    const TwoTrackVerdict& verdict = *past.verdict;
    const QString limit = format::length(past.stepLimit, 2);
    if (verdict.onePlane)
        return tr("%1 for steps above %2").arg(VerdictStrip::answerOf(verdict.side[0]), limit);
    return tr("%1 for steps above %2 (left %3, right %4)")
        .arg(answerText(verdict.both), limit, VerdictStrip::answerOf(verdict.side[0]),
             VerdictStrip::answerOf(verdict.side[1]));
}

QString PastText::origin(const PastEstimate& past)
{
    const QString method = format::text(name(past.estimate->side[0].settings.method));
    return past.hasReading ? tr("press and probe, method %1").arg(method)
                           : tr("press, method %1").arg(method);
}

QString PastText::error(const PastEstimate& past)
{
    QStringList parts;
    if (past.errors.size() == 1)
        parts << tr("error %1 against the truth").arg(format::length(past.errors[0].rms, 3));
    else if (past.errors.size() == 2)
        parts << tr("error left %1, right %2 against the truth")
                     .arg(format::length(past.errors[0].rms, 3),
                          format::length(past.errors[1].rms, 3));
    for (const PastEstimate::Probed& probed : past.probed)
        parts << tr("error %1 %2, measured later by the arm")
                     .arg(format::length(probed.error, 3), placeText(probed.place));
    return parts.isEmpty() ? tr("error not known") : parts.join(QStringLiteral(" · "));
}

QString PastText::note(const PastEstimate& past)
{
    return tr("shown: estimate of %1, not the present one").arg(time(past));
}

}  // namespace terratact
