#pragma once

#include <QList>
#include <array>
#include <optional>
#include <vector>

#include "app/display/precondition.h"
#include "app/link/can_source.h"
#include "app/mission/estimation.h"
#include "core/base/message.h"
#include "core/infer/estimate/settings.h"
#include "core/robot/measurement.h"

namespace terratact {

/// Preconditions of commands, as texts for the operator.
class Preconditions {
public:
    static Precondition telemetry(bool alive, bool logEnded);
    /// Without fresh telemetry, no condition that depends on the robot counts as met.
    static Precondition stop(bool latched, bool releasing,  ///< releasing: not yet confirmed
                             bool telemetryFresh);
    static Precondition bothSides();       ///< left and right are estimated each
    static Precondition groundNotKnown();  ///< ground and the robot's pose on it are unknown
    static Precondition
    arming(const std::optional<Message>& whyNot);  ///< empty: the robot is armed
    static Precondition model(const ModelInUse& model);
    /// STOP as a precondition of commands that it blocks.
    static Precondition released(bool latched, bool telemetryFresh);
    static Precondition nothingToRelease();
    static Precondition noProbeProposed();
    static Precondition notExploring(bool explores);
    static Precondition odometry(bool reported);  ///< the robot reports the way of its tracks
    /// The proposal still has the data that was shown with it.
    static Precondition stands(bool asThen);
    static Precondition armIsOut();         ///< the robot reports that it probes
    static Precondition beyondTipping();    ///< pitch or roll is beyond the angle of tipping over
    static Precondition hadTelemetryGap();  ///< telemetry was missing since the estimate
    static Precondition pitchSuspected();   ///< the arm would touch another place than is shown
    static Precondition stopConfirmed(bool confirmed, bool telemetryFresh);
    static QList<Precondition> toArm(const CanView& view);
};

/// The methods assume equal ground left and right (planar ground). If roll, flippers or a track differential contradict
/// that, the operator may override each contradiction at its present size. New contradictions, and growth beyond the
/// limit, are not covered.
class PlanarGround {
public:
    /// Returns a Doubtful or Overridden precondition per contradiction of the settings' limits; a single Met one
    /// without any.
    QList<Precondition> judge(const Measurement& measurement, const Settings& settings) const;

    /// Overrides all present contradictions. Returns the new ones as text.
    std::vector<Message> overrideWarnings(const Measurement& measurement, const Settings& settings);
    /// Ends overrides whose contradiction has ended or grown too much. Returns the reasons as text.
    std::vector<Message> endOverrides(const Measurement& measurement, const Settings& settings);
    /// Overridden contradictions as text, with their values at that time.
    std::vector<Message> overridden() const;

private:
    enum Kind { kRoll, kAsymmetry, kDifferential, kKinds };
    struct PlanarityWarning {
        double size = 0.0, limit = 0.0;  ///< [rad]
        Message text;
        bool stands() const { return size > limit; }
    };
    static std::array<PlanarityWarning, kKinds> warnings(const Measurement& measurement,
                                                         const Settings& settings);
    static SourceText goneText(int kind);

    std::array<std::optional<PlanarityWarning>, kKinds>
        overridden_;  ///< each at its size when overridden
};

}  // namespace terratact
