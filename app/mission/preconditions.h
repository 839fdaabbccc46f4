#pragma once

#include <QCoreApplication>
#include <QList>
#include <QString>
#include <QStringList>
#include <array>
#include <optional>

#include "app/link/can_source.h"
#include "app/mission/estimation.h"
#include "core/infer/estimate/settings.h"
#include "core/robot/measurement.h"
#include "widgets/control/atem_panel.h"

namespace terratact {

/// What has to be so before a command may leave, in the operator's words.
class Preconditions {
    Q_DECLARE_TR_FUNCTIONS(Preconditions)
public:
    static Precondition telemetry(bool alive, bool logEnded);
    /// heard: the robot's telemetry is live.  Without it nothing of the robot's own is known, and nothing is said to be
    /// met that only the robot knows.
    static Precondition stop(bool latched, bool releasing,  ///< releasing: not yet confirmed
                             bool heard);
    static Precondition groundNotKnown();               ///< nor how the robot stands on it
    static Precondition arming(const QString& whyNot);  ///< empty: the robot is armed
    static Precondition model(const ModelInUse& model);
    static Precondition released(bool latched, bool heard);  ///< STOP, for what it forbids at once
    static Precondition nothingToRelease();
    static Precondition noProbeProposed();
    static Precondition notExploring(bool explores);
    static Precondition stands(bool asThen);  ///< what was shown with a proposal
    static Precondition armIsOut();           ///< the robot says that it probes
    static Precondition wasUnheard();         ///< the robot, since then
    static Precondition stopConfirmed(bool confirmed, bool heard);
    static QList<Precondition> toArm(const CanView& view);
};

/// The method takes the ground as the same left and right.  Where roll or flippers speak against that, the operator
/// may take each such doubt upon himself, as large as it is then: not one that comes later, nor one that grows by more
/// than its limit.
class PlanarGround {
    Q_DECLARE_TR_FUNCTIONS(PlanarGround)
public:
    /// One for each doubt by the limits of the settings, Doubtful or Overridden; a single Met one where there is none.
    QList<Precondition> judge(const Measurement& measurement, const Settings& settings) const;

    /// Overrides every doubt there is.  Those that were not yet, in words.
    QStringList overrideDoubts(const Measurement& measurement, const Settings& settings);
    /// Ends the overrides whose doubt is gone or has grown too much.  Why each has ended, in words.
    QStringList endOverrides(const Measurement& measurement, const Settings& settings);
    QStringList overridden() const;  ///< what, in words, with the values of then

private:
    enum Kind { kRoll, kAsymmetry, kKinds };
    struct Doubt {
        double size = 0.0, limit = 0.0;  ///< [rad]
        QString text;
        bool stands() const { return size > limit; }
    };
    static std::array<Doubt, kKinds> doubts(const Measurement& measurement,
                                            const Settings& settings);
    static QString goneWords(int kind);

    std::array<std::optional<Doubt>, kKinds> overridden_;  ///< each as it was then
};

}  // namespace terratact
