#include "app/figures/report/report_text.h"

#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "app/figures/wording.h"
#include "core/log/event_text.h"

namespace terratact {
namespace {

double inDegrees(double radians)
{
    return radians * 180.0 / std::numbers::pi;
}

SourceText readingAt(ProbeSide side)
{
    switch (side) {
    case ProbeSide::Left: return TR_NOOP("Report", "%1 m at %2 m left (sd %3 mm)");
    case ProbeSide::Right: return TR_NOOP("Report", "%1 m at %2 m right (sd %3 mm)");
    default: return TR_NOOP("Report", "%1 m at %2 m (sd %3 mm)");
    }
}

/// Returns the message, or the recorded name if it is nothing else.
Message nameOr(const Message& message, const std::string& recorded)
{
    const bool isName = message.context.empty() && message.arguments.empty() && !recorded.empty();
    return isName ? eventName(recorded) : message;
}

}  // namespace

Message settingsText(const Settings& s)
{
    std::vector<Message> parts{
        {TR_NOOP("Report", "method %1"), name(s.method)},
        {TR_NOOP("Report", "ceiling %1"), name(s.ceiling)},
        {TR_NOOP("Report", "contacts %1"), name(s.contacts)},
        {TR_NOOP("Report", "contact above %1 N"), s.forceThreshold},
        {TR_NOOP("Report", "contact sd %1 m"), s.contactSd},
        {s.stopEarly ? TR_NOOP("Report", "at most %1 draws")
                     : TR_NOOP("Report", "at most %1 draws (all)"),
         s.draws},
        {TR_NOOP("Report", "%1 chains"), s.chains},
        {TR_NOOP("Report", "burn-in %1"), s.burnIn},
        {TR_NOOP("Report", "scan %1"), name(s.scan)},
        {TR_NOOP("Report", "precision %1"), name(s.precision)},
        {TR_NOOP("Report", "inducing %1"), s.inducing},
        {TR_NOOP("Report", "seed %1"), s.seed},
        {TR_NOOP("Report", "probe above %1 m"), s.probeAbove},
    };
    return Message::listed(std::move(parts), ", ");
}

Message readingsText(const EstimateRow& row)
{
    if (row.readings.empty()) return TR_NOOP("Report", "none");
    std::vector<Message> parts;
    parts.reserve(row.readings.size());
    for (const ArmReading& r : row.readings)
        parts.emplace_back(readingAt(r.side), signedFixed(r.height, 3),
                           signedFixed(binCentre(r.bin), 1), fixed(1000.0 * r.sd, 0));
    return Message::listed(std::move(parts), ", ");
}

Message stepText(const Verdict& v, double limit)
{
    std::vector<Message> parts{
        {isClearToHorizon(v)
             ? TR_NOOP("Report", "%1: a step of more than %2 m up to there has probability %3 %")
             : TR_NOOP("Report", "%1: a step ahead of more than %2 m has probability %3 %"),
         stepVerdictMessage(v), fixed(limit, 2), fixed(100.0 * answeredBy(v).p, 0)}};
    if (v.shortfall != Shortfall::None) parts.emplace_back(describe(v.shortfall));
    if (!v.unfelt.empty()) parts.push_back(unfeltMessage(v));
    for (const WithholdReason reason : v.withheldFor) parts.emplace_back(describe(reason));
    return Message::listed(std::move(parts), "; ");
}

Message subjectMessage(const EventRow& event)
{
    if (event.subject.empty()) return TR_NOOP("Report", "marker");
    return nameOr(subjectOf(event), event.subject);
}

Message textMessage(const EventRow& event)
{
    if (event.kind == EventKind::Marker) return Message::verbatim(event.text);
    return nameOr(messageOf(event), event.text);
}

Message crossSlopeText(const CrossSlope& slope)
{
    return {TR_NOOP("Report",
                    "%1° (left higher) at %2 m; more than %3° to a side has probability %4 %"),
            signedFixed(inDegrees(slope.steepest), 1), signedFixed(binCentre(slope.bin), 1),
            fixed(inDegrees(slope.limit), 1), fixed(100.0 * slope.beyond.p, 0)};
}

}  // namespace terratact
