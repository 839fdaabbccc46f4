#pragma once

#include <cmath>
#include <functional>
#include <string>

#include "core/atem/arming.h"
#include "core/atem/atem_machine.h"
#include "core/sim/ground/terrain_shapes.h"
#include "core/sim/robot_on_bus.h"
#include "core/store/file_read.h"
#include "tests/support/absolem.h"
#include "tests/support/sessions/sessions.h"

namespace terratact {

/// Times [s] of the events in a simulated robot's session: an exploration with an approved probe.
struct RobotSessionTimes {
    static constexpr double kLinkUp = 0.2, kAlarm = 0.8, kAlarmGone = 1.2, kPressing = 1.4,
                            kScene = 1.6, kEstimate = 1.8, kProposing = 1.85, kMarker = 2.0,
                            kApproved = 2.2, kProbing = 2.25, kAgain = 2.6, kPresenting = 2.65,
                            kForgotten = 3.4;
};

/// Writes a session of `seconds` of the shipped robot, which stands still, in batches of 0.2 s. Other frames are added
/// until there are `framesPerSecond`. silent: times without frames.
inline Result<SessionWriter> robotSession(const std::string& path, double seconds,
                                          double framesPerSecond = 0.0,
                                          const std::function<bool(double)>& silent = {})
{
    using At = RobotSessionTimes;
    constexpr double kTick = 0.01;
    SessionStart start = someStart();
    start.robot = *readFile(TERRATACT_SOURCE_DIR "/resources/robots/absolem.toml", 1U << 16U);
    auto writer = SessionWriter::create(path, start);
    if (!writer) return writer;
    SimulatedRobot::Options simulation;
    simulation.startX = 1.0;
    RobotOnBus robot(absolem(), SimulatedRobot(absolem(), flatTerrain(5.0), simulation), {});

    std::int64_t event = 0, filler = 0;
    const auto log = [&](double at, EventKind kind, std::string_view subject,
                         std::string_view text = {}, std::optional<double> number = {}) {
        EventRow row{.id = ++event, .time = sessionTimeOf(at), .kind = kind};
        row.subject = subject;
        row.text = text;
        row.number = number;
        if (kind == EventKind::Decision) row.estimate = row.proposal = 1;
        (void)writer->add(row);
    };
    for (int tick = 0; tick * kTick < seconds; ++tick) {
        const double now = tick * kTick;
        const auto passes = [tick](double from) { return tick == std::lround(from / kTick); };
        if (tick == 0) {
            (void)writer->add(
                ModelRow{.id = 1, .name = "default.ttm", .hash = std::string(64, 'c')});
            log(0.0, EventKind::Session, "begun");
            log(0.0, EventKind::Phase, name(AtemPhase::Idle));
            log(0.0, EventKind::Arming, name(ArmingPhase::Disarmed));
        }
        if (passes(At::kLinkUp)) log(now, EventKind::Link, "up");
        if (passes(At::kAlarm)) log(now, EventKind::Alarm, "frames", "frames are lost", 3.0);
        if (passes(At::kAlarmGone)) log(now, EventKind::Alarm, "frames", "", 0.0);
        if (passes(At::kPressing)) log(now, EventKind::Phase, name(AtemPhase::Pressing));
        if (passes(At::kScene)) {
            SceneRow scene = someScene(1, sessionTimeOf(now));
            scene.measurement.travelled = 0.0;  // same as the telemetry
            (void)writer->add(scene);
        }
        if (passes(At::kEstimate)) {
            (void)writer->add(someEstimate(1, sessionTimeOf(now)));
            (void)writer->add(someProposal(sessionTimeOf(now)));
        }
        if (passes(At::kProposing)) log(now, EventKind::Phase, name(AtemPhase::ProposingProbe));
        if (passes(At::kMarker)) log(now, EventKind::Marker, "operator", "look here");
        if (passes(At::kApproved)) log(now, EventKind::Decision, "approve", "probe at 0.6 m");
        if (passes(At::kProbing)) log(now, EventKind::Phase, name(AtemPhase::Probing));
        if (passes(At::kAgain)) {
            EstimateRow again = someEstimate(2, sessionTimeOf(now));
            again.scene = 1;
            (void)writer->add(again);
        }
        if (passes(At::kPresenting)) log(now, EventKind::Phase, name(AtemPhase::Presenting));
        if (passes(At::kForgotten)) log(now, EventKind::Forgotten, "", "The robot has moved");
        if (!silent || !silent(now)) {
            for (const CanFrame& frame : robot.tick(now))
                (void)writer->add(FrameRow{.time = sessionTimeOf(now), .frame = frame});
            for (int k = 0; k < static_cast<int>(framesPerSecond * kTick); ++k) {
                FrameRow row = someFrame(++filler);
                row.frame.id = 0x700 + static_cast<std::uint32_t>(filler % 8);
                row.time = sessionTimeOf(now + 1e-4 * k);
                row.sent = false;
                (void)writer->add(row);
            }
        }
        if (tick % 20 == 19)
            if (const Status done = writer->commit(); !done) return done.error();
    }
    if (const Status done = writer->commit(); !done) return done.error();
    return writer;
}

}  // namespace terratact
