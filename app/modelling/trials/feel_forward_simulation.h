#pragma once

#include <optional>

#include "app/modelling/trials/feel_forward_trials.h"
#include "core/atem/advance_watch.h"
#include "core/atem/feel_forward.h"
#include "core/sim/simulated_robot.h"
#include "core/trail/trail_record.h"

namespace terratact {

/// One drive of a trial, step by step: the state machine of the console, its estimates, and a simulated robot.
class FeelForwardSimulation {
public:
    FeelForwardSimulation(const EstimatorBundle& bundle, const FeelForwardTrial& trial,
                          GroundLines ground, const SimulatedRobot::Options& options);

    /// Drives until the drive ends.
    FeelForwardCounts run();

private:
    void hold();  ///< runs the loop until it ends
    void follow();
    void tick(bool begins);
    AtemInput poll() const;
    void enter(AtemPhase phase);
    void estimate();
    void judgeGround();  ///< counts falls, collisions and touches of the present pose
    bool driveByHand();  ///< returns false if the drive ends here
    bool isStepNear() const;
    bool flipperTouches() const;

    const EstimatorBundle& bundle_;
    const FeelForwardTrial& trial_;
    SimulatedRobot robot_;
    Measurement line_;
    TrailRecord way_;  ///< fed for the method Trail alone
    double now_ = 0.0;
    AtemState state_;
    std::optional<TwoTrackVerdict> verdict_;
    std::optional<AdvanceWatch> advance_;
    double advancedFrom_ = 0.0;
    bool touched_ = false;  ///< in this advance
    FeelForwardCounts counts_;
};

}  // namespace terratact
