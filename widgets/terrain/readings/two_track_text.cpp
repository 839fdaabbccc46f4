#include "widgets/terrain/readings/two_track_text.h"

#include <QCoreApplication>
#include <QStringList>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "app/display/format.h"
#include "app/display/place_text.h"
#include "core/robot/attitude.h"
#include "widgets/terrain/readings/verdict_strip.h"

namespace terratact {
namespace {

struct TwoTrackWords {
    Q_DECLARE_TR_FUNCTIONS(TwoTrackVerdict)
};

constexpr std::array kBothSides{Side::Left, Side::Right};
const QString kDot = QStringLiteral(" · ");

const Verdict& of(const TwoTrackVerdict& verdict, Side side)
{
    return verdict.side[indexOf(side)];
}

QString answerOfSide(const Verdict& verdict)
{
    QString answer = VerdictStrip::answerOf(verdict);
    if (verdict.stepVerdict != StepVerdict::Blocked) return answer;
    return TwoTrackWords::tr("%1 at %2")
        .arg(answer, format::signedLength(binCentre(verdict.likeliest + 1), 1));
}

/// Returns the answer and its distance [m] in few characters: "✘ BLOCKED 0.4".
QString shortAnswerOfSide(const Verdict& verdict)
{
    Verdict plain = verdict;
    plain.touchRecorded = false;  // CLEAR without its horizon
    QString answer = VerdictStrip::answerOf(plain) + QLatin1Char(' ');
    if (verdict.stepVerdict == StepVerdict::Blocked)
        return answer + format::lengthNumber(binCentre(verdict.likeliest + 1), 1);
    return isClearToHorizon(verdict) ? answer + format::lengthNumber(verdict.horizon, 2)
                                     : answer.trimmed();
}

/// Returns the texts of both sides, each with its letter; equal texts once. Sides without a text are left out.
QString perSide(const std::array<QString, 2>& texts)
{
    if (texts[0] == texts[1]) return texts[0];
    QStringList parts;
    for (const Side side : kBothSides)
        if (const QString& text = texts[indexOf(side)]; !text.isEmpty())
            parts << TwoTrackWords::tr("%1: %2").arg(sideLetter(side), text);
    return parts.join(kDot);
}

bool isTooSteep(const TwoTrackVerdict& verdict)
{
    return verdict.crossSlope.beyond.p >= kClearBelow;
}

/// Returns the reason of an answer for the robot that no side gives.
QString jointReason(const TwoTrackVerdict& verdict)
{
    const bool isBlocked = verdict.both == StepVerdict::Blocked;
    if (isTooSteep(verdict))
        return isBlocked ? TwoTrackWords::tr("the cross slope ahead may tip the robot over")
                         : TwoTrackWords::tr("the cross slope ahead is not decided");
    return isBlocked ? TwoTrackWords::tr("a step on one of the sides is almost certain")
                     : TwoTrackWords::tr("each side alone is clear, both together are not");
}

QString whyOfSide(const Verdict& side, bool isBrief, bool isOfTwo)
{
    if (side.stepVerdict == StepVerdict::CannotTell && isBrief)
        return VerdictStrip::brieflyOf(side, isOfTwo);
    return VerdictStrip::whyOf(side);
}

}  // namespace

QString sidesText(const TwoTrackVerdict& verdict, bool isShort)
{
    const auto answerOf = isShort ? shortAnswerOfSide : answerOfSide;
    const std::array answers{answerOf(verdict.side[0]), answerOf(verdict.side[1])};
    if (answers[0] == answers[1])
        return verdict.both == verdict.side[0].stepVerdict
                 ? QString()
                 : TwoTrackWords::tr("each side %1").arg(answers[0]);
    if (isShort) {
        const QString line = TwoTrackWords::tr("L %1 · R %2").arg(answers[0], answers[1]);
        return line.back().isDigit() ? line + QLatin1Char(' ') + format::lengthUnit() : line;
    }
    return TwoTrackWords::tr("left %1 · right %2").arg(answers[0], answers[1]);
}

QString eitherText(const TwoTrackVerdict& verdict, double limit)
{
    const auto shown = [](const StepProbability& p) {
        return format::probability(p.p, p.monteCarloSd);
    };
    const QString height = format::length(limit, 2);
    if (verdict.both == StepVerdict::Clear)
        return TwoTrackWords::tr("P(step > %1) L %2, R %3")
            .arg(height, shown(verdict.side[0].toHorizon), shown(verdict.side[1].toHorizon));
    return (format::isExtremeProbability(verdict.either.p)
                ? TwoTrackWords::tr("P(step > %1, L or R): %2")
                : TwoTrackWords::tr("P(step > %1, L or R) = %2"))
        .arg(height, shown(verdict.either));
}

QString crossSlopeText(const TwoTrackVerdict& verdict)
{
    const CrossSlope& slope = verdict.crossSlope;
    const double tipsOver = slope.limit + kRedReserve;
    if (!(slope.limit > 0.0) || !(std::abs(slope.steepest) > tipsOver - kAmberReserve)) return {};
    return TwoTrackWords::tr("cross slope %1 of %2, %3 up")
        .arg(format::plainAngle(std::abs(slope.steepest), 0), format::plainAngle(tipsOver, 0),
             sideLetter(slope.steepest > 0.0 ? Side::Left : Side::Right));
}

QString whyText(const TwoTrackVerdict& verdict, bool isBrief)
{
    const bool withheld = isWithheld(verdict);
    const auto gives = [&](const Verdict& side) {  // the robot's answer is this side's
        return withheld ? !side.withheldFor.empty() : side.stepVerdict == verdict.both;
    };
    QStringList parts;
    if (const QString slope = crossSlopeText(verdict); !slope.isEmpty()) parts << slope;
    if (std::ranges::none_of(verdict.side, gives)) parts << jointReason(verdict);
    // The line of both sides states where a step is.
    const bool isSaid =
        verdict.both == StepVerdict::Blocked && isBrief && !sidesText(verdict).isEmpty();
    const auto textsOf = [&](bool isOfTwo) {
        std::array<QString, 2> texts;
        for (const Side side : kBothSides)
            if (gives(of(verdict, side)) && !isSaid)
                texts[indexOf(side)] = whyOfSide(of(verdict, side), isBrief, isOfTwo);
        return texts;
    };
    std::array<QString, 2> texts = textsOf(false);
    if (texts[0] != texts[1] && std::ranges::all_of(verdict.side, gives)) texts = textsOf(true);
    if (const QString sides = perSide(texts); !sides.isEmpty()) parts << sides;
    return parts.join(kDot);
}

}  // namespace terratact
