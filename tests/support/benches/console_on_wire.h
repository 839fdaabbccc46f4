#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <optional>
#include <vector>

#include "core/atem/console_link.h"
#include "core/sim/ground/terrain_shapes.h"
#include "core/sim/robot_on_bus.h"
#include "tests/support/absolem.h"

namespace terratact {

inline SimulatedRobot robotBefore(double distance)
{
    SimulatedRobot::Options options;
    options.startX = 3.0 - distance;
    options.probeSeconds = 2.0;
    return SimulatedRobot(absolem(), stepTerrain(0.24, 3.0, 6.0), options);
}

/// A console and a simulated robot on a bus without delay, unless `delays` is set; time is simulated.
struct Wire : testing::Test {
    explicit Wire(RobotOnBus::Options options = {})
        : robot(absolem(), robotBefore(1.5), options), console(absolem(), {})
    {
    }

    void toRobot(const std::vector<CanFrame>& frames)
    {
        for (const CanFrame& frame : frames) {
            sent.push_back(frame);
            console.receive(frame, true, now);
            if (cut || (lose && lose(frame))) continue;
            if (!delays) arrive(frame);
            for (const double delay : delays ? delays(frame) : std::vector<double>{})
                onTheWay.push_back({now + delay, frame});
        }
    }
    /// Delivers a frame at the robot.
    void arrive(const CanFrame& frame) { toConsole(robot.receive(frame, now)); }
    void arriveDue()
    {
        std::ranges::stable_sort(onTheWay, {}, &Late::due);
        std::size_t due = 0;
        for (; due < onTheWay.size() && onTheWay[due].due <= now; ++due) {
            const CanFrame frame = onTheWay[due].frame;
            arrive(frame);
        }
        onTheWay.erase(onTheWay.begin(), onTheWay.begin() + static_cast<std::ptrdiff_t>(due));
    }
    void toConsole(const std::vector<CanFrame>& frames)
    {
        for (const CanFrame& frame : frames) {
            if (cut) continue;
            if (const auto measurement = console.receive(frame, false, now)) latest = measurement;
        }
    }
    /// Advances time in ticks of 10 ms.
    void pass(double seconds)
    {
        for (int i = 0; i < static_cast<int>(seconds / 0.01 + 0.5); ++i) {
            now += 0.01;
            arriveDue();
            if (operatorThere) console.operatorAlive(now);
            toRobot(console.tick(now));
            toConsole(robot.tick(now));
        }
    }
    GateRefusal command(const Command& command)
    {
        const auto answer = console.send(command, now);
        if (const auto* frame = std::get_if<CanFrame>(&answer)) {
            toRobot({*frame});
            return GateRefusal::None;
        }
        const auto* refusal = std::get_if<GateRefusal>(&answer);
        return refusal ? *refusal : GateRefusal::None;  // it waits for the robot's next answer
    }
    void arm()
    {
        pass(2.5);
        console.wantArming();
        pass(0.2);
        console.confirmArming();
        pass(0.2);
        ASSERT_EQ(phase(), ArmingPhase::Armed) << describe(console.view(now).arming.cause).english;
    }
    void beginProbe(int bin)
    {
        arm();
        command(BeginAtemCommand{});
        pass(0.1);
        command(PressCommand{18.0});
        ASSERT_TRUE(does(RobotActivity::Pressed, 15.0));
        console.approve({bin}, now);
        ASSERT_EQ(command(ProbeCommand{bin}), GateRefusal::None);
    }
    double x() const { return robot.robot().pose().base.x; }  ///< [m] position of the robot
    ArmingPhase phase() const { return console.view(now).arming.phase; }
    DisarmCause cause() const { return console.view(now).arming.cause; }
    RobotActivity activity() const { return robot.robot().activity(); }
    bool does(RobotActivity wanted, double seconds)
    {
        for (double t = 0.0; t < seconds; t += 0.05) {
            pass(0.05);
            if (latest && latest->activity == wanted) return true;
        }
        return false;
    }

    double now = 100.0;
    RobotOnBus robot;
    ConsoleLink console;
    std::optional<Measurement> latest;
    std::vector<CanFrame> sent;
    bool cut = false, operatorThere = true;
    std::function<bool(const CanFrame&)> lose;
    /// Returns the delays [s] of each copy of a frame to the robot; none: the frame is lost.
    std::function<std::vector<double>(const CanFrame&)> delays;
    struct Late {
        double due;
        CanFrame frame;
    };
    std::vector<Late> onTheWay;
};

}  // namespace terratact
