#include "app/mission/preconditions.h"

#include <algorithm>
#include <cmath>

#include "app/display/format.h"
#include "app/display/translated.h"
#include "core/robot/side_plane.h"

namespace terratact {
namespace {

Precondition met(const Message& text)
{
    return {Precondition::Level::Met, text};
}

Precondition missing(const Message& text)
{
    return {Precondition::Level::Missing, text};
}

Precondition doubtful(const Message& text)
{
    return {Precondition::Level::Doubtful, text};
}

}  // namespace

Precondition Preconditions::telemetry(bool alive, bool logEnded)
{
    if (alive) return met(TR_NOOP("Preconditions", "telemetry is live"));
    return missing(logEnded ? TR_NOOP("Preconditions", "the log has ended")
                            : TR_NOOP("Preconditions", "no telemetry from the robot"));
}

Precondition Preconditions::stop(bool latched, bool releasing, bool telemetryFresh)
{
    if (!latched) return released(latched, telemetryFresh);
    return missing(
        releasing ? TR_NOOP("Preconditions", "STOP: release sent, not yet confirmed by the robot")
                  : TR_NOOP("Preconditions", "STOP is latched"));
}

Precondition Preconditions::released(bool latched, bool telemetryFresh)
{
    if (latched) return missing(TR_NOOP("Preconditions", "STOP is latched: release it first"));
    return telemetryFresh ? met(TR_NOOP("Preconditions", "STOP is not latched"))
                          : doubtful(TR_NOOP("Preconditions", "STOP: not known, no telemetry"));
}

Precondition Preconditions::bothSides()
{
    return met(TR_NOOP("Preconditions", "left and right are estimated separately"));
}

Precondition Preconditions::groundNotKnown()
{
    return doubtful(TR_NOOP("Preconditions", "left, right: not known, no telemetry"));
}

Precondition Preconditions::nothingToRelease()
{
    return missing(TR_NOOP("Preconditions", "there is no STOP to release"));
}

Precondition Preconditions::noProbeProposed()
{
    return missing(TR_NOOP("Preconditions", "no open question"));
}

Precondition Preconditions::odometry(bool reported)
{
    return reported ? met(TR_NOOP("Preconditions", "the robot reports odometry"))
                    : missing(TR_NOOP("Preconditions", "the robot reports no odometry"));
}

Precondition Preconditions::notExploring(bool explores)
{
    return explores
             ? missing(TR_NOOP("Preconditions", "An exploration is running: end it with Esc first"))
             : met(TR_NOOP("Preconditions", "nothing is being explored"));
}

Precondition Preconditions::stands(bool asThen)
{
    return asThen ? met(TR_NOOP("Preconditions",
                                "scene, settings and model are unchanged since the question"))
                  : missing(TR_NOOP("Preconditions",
                                    "scene, settings or model have changed since the question"));
}

Precondition Preconditions::armIsOut()
{
    return missing(
        TR_NOOP("Preconditions", "the arm is still out: wait until it is back, or press STOP"));
}

Precondition Preconditions::beyondTipping()
{
    return missing(TR_NOOP("Preconditions", "pitch or roll is beyond the tip-over angle: "
                                            "bring the robot back onto its tracks first"));
}

Precondition Preconditions::hadTelemetryGap()
{
    return missing(
        TR_NOOP("Preconditions", "the link was lost, the robot may have moved: explore again"));
}

Precondition Preconditions::pitchSuspected()
{
    return missing(
        TR_NOOP("Preconditions",
                "No probe: the pitch may be wrong, and the arm would touch another place"));
}

Precondition Preconditions::stopConfirmed(bool confirmed, bool telemetryFresh)
{
    if (!confirmed) return doubtful(TR_NOOP("Preconditions", "the robot has not confirmed STOP"));
    return telemetryFresh ? met(TR_NOOP("Preconditions", "the robot reports stopped"))
                          : doubtful(TR_NOOP("Preconditions",
                                             "the robot reported stopped, then telemetry ended"));
}

QList<Precondition> Preconditions::toArm(const CanView& view)
{
    QList<Precondition> list;
    for (const LinkNeed& need : armingNeeds(view)) {
        list << (need.met ? met(need.text) : missing(need.text));
    }
    return list;
}

Precondition Preconditions::arming(const std::optional<Message>& whyNot)
{
    if (!whyNot) return met(TR_NOOP("Preconditions", "the robot is armed"));
    return missing(*whyNot);
}

Precondition Preconditions::model(const ModelInUse& model)
{
    if (!model.trouble.empty())
        return missing(Message(TR_NOOP("Preconditions", "no model: %1"), model.trouble));
    if (model.name.isEmpty()) return missing(TR_NOOP("Preconditions", "the model is being loaded"));
    return met(Message(TR_NOOP("Preconditions", "model %1 is ready"), verbatim(model.name)));
}

std::array<PlanarGround::PlanarityWarning, PlanarGround::kKinds>
PlanarGround::warnings(const Measurement& m, const Settings& settings)
{
    const double asymmetry = flipperAsymmetry(m), differential = m.differential.value_or(0.0);
    return {
        PlanarityWarning{std::abs(m.roll), settings.rollLimit,
                         Message(TR_NOOP("PlanarGround", "roll %1: left and right ground differ"),
                                 verbatim(format::degrees(m.roll)))},
        PlanarityWarning{asymmetry, settings.asymmetryLimit,
                         Message(TR_NOOP("PlanarGround", "left and right flippers differ by %1"),
                                 verbatim(format::degrees(asymmetry)))},
        PlanarityWarning{std::abs(differential), kTurnedDifferential,
                         Message(TR_NOOP("PlanarGround", "the track differential has turned by %1"),
                                 verbatim(format::degrees(differential)))}};
}

SourceText PlanarGround::goneText(int kind)
{
    switch (kind) {
    case kRoll: return TR_NOOP("PlanarGround", "the roll is small again");
    case kAsymmetry: return TR_NOOP("PlanarGround", "left and right flippers agree again");
    default: return TR_NOOP("PlanarGround", "the track differential is back");
    }
}

QList<Precondition> PlanarGround::judge(const Measurement& m, const Settings& settings) const
{
    const auto all = warnings(m, settings);
    QList<Precondition> list;
    for (std::size_t kind = 0; kind < kKinds; ++kind)
        if (all[kind].stands())
            list << Precondition{overridden_[kind] ? Precondition::Level::Overridden
                                                   : Precondition::Level::Doubtful,
                                 all[kind].text};
    if (list.isEmpty()) list << met(TR_NOOP("PlanarGround", "left and right agree, roll is small"));
    return list;
}

std::vector<Message> PlanarGround::overrideWarnings(const Measurement& m, const Settings& settings)
{
    const auto all = warnings(m, settings);
    std::vector<Message> news;
    for (std::size_t kind = 0; kind < kKinds; ++kind) {
        if (overridden_[kind] || !all[kind].stands()) continue;
        overridden_[kind] = all[kind];
        news.push_back(all[kind].text);
    }
    return news;
}

std::vector<Message> PlanarGround::endOverrides(const Measurement& m, const Settings& settings)
{
    const auto stands = [](const auto& warning) { return warning.has_value(); };
    if (std::ranges::none_of(overridden_, stands))
        return {};  // quick exit, because this is called often
    const auto all = warnings(m, settings);
    std::vector<Message> reasons;
    for (std::size_t kind = 0; kind < kKinds; ++kind) {
        const PlanarityWarning& now = all[kind];
        const std::optional<PlanarityWarning>& then = overridden_[kind];
        if (!then) continue;
        const bool grew = now.size > then->size + now.limit;
        if (now.stands() && !grew) continue;
        reasons.push_back(
            grew ? Message(TR_NOOP("PlanarGround", "%1, more than what was overridden"), now.text)
                 : Message(goneText(static_cast<int>(kind))));
        overridden_[kind].reset();
    }
    return reasons;
}

std::vector<Message> PlanarGround::overridden() const
{
    std::vector<Message> list;
    for (const auto& warning : overridden_)
        if (warning) list.push_back(warning->text);
    return list;
}

}  // namespace terratact
