#include "app/mission/preconditions.h"

#include <algorithm>
#include <cmath>

#include "app/display/format.h"

namespace terratact {
namespace {

Precondition met(const QString& text)
{
    return {Precondition::Level::Met, text};
}

Precondition missing(const QString& text)
{
    return {Precondition::Level::Missing, text};
}

Precondition doubtful(const QString& text)
{
    return {Precondition::Level::Doubtful, text};
}

}  // namespace

Precondition Preconditions::telemetry(bool alive, bool logEnded)
{
    if (alive) return met(tr("telemetry is live"));
    return missing(logEnded ? tr("the log has ended") : tr("no telemetry from the robot"));
}

Precondition Preconditions::stop(bool latched, bool releasing, bool telemetryFresh)
{
    if (!latched) return released(latched, telemetryFresh);
    return missing(releasing ? tr("STOP: release sent, not yet confirmed by the robot")
                             : tr("STOP is latched"));
}

Precondition Preconditions::released(bool latched, bool telemetryFresh)
{
    if (latched) return missing(tr("STOP is latched: release it first"));
    return telemetryFresh ? met(tr("STOP is not latched"))
                          : doubtful(tr("STOP: not known, no telemetry"));
}

Precondition Preconditions::groundNotKnown()
{
    return doubtful(tr("left, right: not known, no telemetry"));
}

Precondition Preconditions::nothingToRelease()
{
    return missing(tr("there is no STOP to release"));
}

Precondition Preconditions::noProbeProposed()
{
    return missing(tr("no probe is proposed"));
}

Precondition Preconditions::notExploring(bool explores)
{
    return explores ? missing(tr("An exploration is running: end it with Esc first"))
                    : met(tr("nothing is being explored"));
}

Precondition Preconditions::stands(bool asThen)
{
    return asThen ? met(tr("scene, settings and model are unchanged since the question"))
                  : missing(tr("scene, settings or model have changed since the question"));
}

Precondition Preconditions::armIsOut()
{
    return missing(tr("the arm is still out: wait until it is back, or press STOP"));
}

Precondition Preconditions::hadTelemetryGap()
{
    return missing(tr("the link was lost, the robot may have moved: explore again"));
}

Precondition Preconditions::pitchSuspected()
{
    return missing(tr("No probe: the pitch may be wrong, and the arm would touch another place"));
}

Precondition Preconditions::stopConfirmed(bool confirmed, bool telemetryFresh)
{
    if (!confirmed) return doubtful(tr("the robot has not confirmed STOP"));
    return telemetryFresh ? met(tr("the robot reports stopped"))
                          : doubtful(tr("the robot reported stopped, then telemetry ended"));
}

QList<Precondition> Preconditions::toArm(const CanView& view)
{
    QList<Precondition> list;
    for (const LinkNeed& need : armingNeeds(view)) {
        const QString text = format::sentence(need.text);
        list << (need.met ? met(text) : missing(text));
    }
    return list;
}

Precondition Preconditions::arming(const QString& whyNot)
{
    if (whyNot.isEmpty()) return met(tr("the robot is armed"));
    return missing(whyNot);
}

Precondition Preconditions::model(const ModelInUse& model)
{
    if (!model.trouble.isEmpty()) return missing(tr("no model: %1").arg(model.trouble));
    if (model.name.isEmpty()) return missing(tr("the model is being loaded"));
    return met(tr("model %1 is ready").arg(model.name));
}

std::array<PlanarGround::PlanarityWarning, PlanarGround::kKinds>
PlanarGround::warnings(const Measurement& m, const Settings& settings)
{
    const double asymmetry = flipperAsymmetry(m);
    return {
        PlanarityWarning{std::abs(m.roll), settings.rollLimit,
                         tr("roll %1: left and right ground differ").arg(format::degrees(m.roll))},
        PlanarityWarning{
            asymmetry, settings.asymmetryLimit,
            tr("left and right flippers differ by %1").arg(format::degrees(asymmetry))}};
}

QString PlanarGround::goneWords(int kind)
{
    return kind == kRoll ? tr("the roll is small again")
                         : tr("left and right flippers agree again");
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
    if (list.isEmpty()) list << met(tr("left and right agree, roll is small"));
    return list;
}

QStringList PlanarGround::overrideWarnings(const Measurement& m, const Settings& settings)
{
    const auto all = warnings(m, settings);
    QStringList news;
    for (std::size_t kind = 0; kind < kKinds; ++kind) {
        if (overridden_[kind] || !all[kind].stands()) continue;
        overridden_[kind] = all[kind];
        news << all[kind].text;
    }
    return news;
}

QStringList PlanarGround::endOverrides(const Measurement& m, const Settings& settings)
{
    const auto stands = [](const auto& warning) { return warning.has_value(); };
    if (std::ranges::none_of(overridden_, stands))
        return {};  // quick exit, because this is called often
    const auto all = warnings(m, settings);
    QStringList reasons;
    for (std::size_t kind = 0; kind < kKinds; ++kind) {
        const PlanarityWarning& now = all[kind];
        const std::optional<PlanarityWarning>& then = overridden_[kind];
        if (!then) continue;
        const bool grew = now.size > then->size + now.limit;
        if (now.stands() && !grew) continue;
        reasons << (grew ? tr("%1, more than what was overridden").arg(now.text)
                         : goneWords(static_cast<int>(kind)));
        overridden_[kind].reset();
    }
    return reasons;
}

QStringList PlanarGround::overridden() const
{
    QStringList list;
    for (const auto& warning : overridden_)
        if (warning) list << warning->text;
    return list;
}

}  // namespace terratact
