#include "app/preconditions.h"

#include <cmath>

#include "widgets/words.h"

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

}  // namespace

Precondition Preconditions::telemetry(bool alive, bool logEnded)
{
    if (alive) return met(tr("telemetry is live"));
    return missing(logEnded ? tr("the log has ended") : tr("no telemetry from the robot"));
}

Precondition Preconditions::stop(bool latched, bool releasing)
{
    if (!latched) return met(tr("STOP is not latched"));
    return missing(releasing ? tr("STOP: release sent, not yet confirmed by the robot")
                             : tr("STOP is latched"));
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

Precondition PlanarGround::judge(const Measurement& m, const Settings& settings) const
{
    const double asymmetry = flipperAsymmetry(m);
    const auto doubtful =
        overridden_ ? Precondition::Level::Overridden : Precondition::Level::Doubtful;
    if (std::abs(m.roll) > settings.rollLimit)
        return {doubtful, tr("roll %1: left and right ground differ").arg(words::degrees(m.roll))};
    if (asymmetry > settings.asymmetryLimit)
        return {doubtful,
                tr("left and right flippers differ by %1").arg(words::degrees(asymmetry))};
    return met(tr("left and right agree, roll is small"));
}

}  // namespace terratact
