#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <thread>
#include <utility>
#include <variant>

#include "app/link/robot_in_process.h"
#include "app/link/robot_service.h"
#include "core/sim/robot_on_bus.h"
#include "core/wire/can_codec.h"
#include "drivers/memory_bus.h"

namespace terratact {

/// Telemetry values that replace the robot's true ones.
struct Staging {
    std::optional<RobotActivity> activity{};  ///< reported activity
    std::optional<RobotActivity> lasts{};     ///< repeated forever once the robot does it
    std::optional<Refusal> refuses{};         ///< reported as refusal of each command
    std::optional<bool> explores{};           ///< reported exploration state
    bool isDisarmed = false;                  ///< reports disarmed
    bool isUnfeeling = false;  ///< force elements: left 2 open, left 3 saturated, right 4 short
    double pitch = 0.0, roll = 0.0;        ///< [rad] added
    double twist = 0.0;                    ///< [rad] added between left and right front flipper
    std::optional<double> pitchStuckAt{};  ///< [rad] constant reported pitch
    bool isMute = false;                   ///< sends nothing
    bool isNumb = false;                   ///< sends only status and heartbeat
};

/// A simulated robot with staged telemetry, in its own thread at the end "robot" of a MemoryBus.
/// The bus must outlive it. clock: the robot's monotonic clock [s].
class StagedRobot {
public:
    StagedRobot(MemoryBus& bus, const RobotModel& model, const SimulatedRobot& robot,
                const RobotOnBus::Options& options, const std::function<double()>& clock)
        : robot_(model, robot, options), truth_(trueHeights(robot)),
          end_(*this, bus.join("robot", 0)), thread_([this, clock](const std::stop_token& stop) {
              const auto keepTruth = [this] {
                  const std::scoped_lock lock(mutex_);
                  truth_ = trueHeights(robot_.robot());
              };
              (void)serveRobot(  // a MemoryBus never fails
                  end_, robot_, [&] { return !stop.stop_requested(); }, [](const std::string&) {},
                  keepTruth, clock);
          })
    {
    }

    void stage(const Staging& staging)
    {
        const std::scoped_lock lock(mutex_);
        staging_ = staging;
        lasting_ = false;
    }
    /// Returns the true bin heights at the pose of the newest sample; callable from any thread.
    TrueHeights truth() const
    {
        const std::scoped_lock lock(mutex_);
        return truth_;
    }

private:
    /// The robot's end of the bus; it stages outgoing frames.
    class End final : public CanBus {
    public:
        End(StagedRobot& robot, std::unique_ptr<CanBus> bus) : robot_(robot), bus_(std::move(bus))
        {
        }
        std::string name() const override { return bus_->name(); }
        BusState state() const override { return bus_->state(); }
        BusCounters counters() const override { return bus_->counters(); }
        Result<std::size_t> receive(std::span<BusFrame> frames,
                                    std::chrono::milliseconds patience) override
        {
            return bus_->receive(frames, patience);
        }
        Status send(const CanFrame& frame) override
        {
            const auto staged = robot_.staged(frame);
            return staged ? bus_->send(*staged) : Done{};
        }

    private:
        StagedRobot& robot_;
        std::unique_ptr<CanBus> bus_;
    };

    std::optional<CanFrame> staged(const CanFrame& frame)
    {
        const std::scoped_lock lock(mutex_);
        if (staging_.isMute) return std::nullopt;
        const auto unpacked = unpack(frame);
        Unpacked content = std::get<Unpacked>(unpacked);
        const bool beats =
            content.kind == FrameKind::RobotStatus || content.kind == FrameKind::RobotHeartbeat;
        if (staging_.isNumb && !beats) return std::nullopt;
        if (const auto status = statusOf(content))
            return frameOf(stagedStatus(*status), content.counter);
        if (content.kind == FrameKind::Attitude) {
            content.values[0] = staging_.pitchStuckAt.value_or(content.values[0] + staging_.pitch);
            content.values[1] += staging_.roll;
        } else if (content.kind == FrameKind::FrontAngles) {
            content.values[0] += 0.5 * staging_.twist;
            content.values[1] -= 0.5 * staging_.twist;
        }
        const auto volts = [&](FrameKind of, std::size_t element, double voltage) {
            if (staging_.isUnfeeling && content.kind == of) content.values[element] = voltage;
        };
        volts(FrameKind::LeftForces1To3, 1, 0.0);
        volts(FrameKind::LeftForces1To3, 2, 4.85);
        volts(FrameKind::RightForces4To6, 0, 5.0);
        return pack(content);
    }
    RobotStatus stagedStatus(RobotStatus status)
    {
        lasting_ = lasting_ || (staging_.lasts && status.activity == *staging_.lasts);
        if (lasting_) status.activity = *staging_.lasts;
        status.activity = staging_.activity.value_or(status.activity);
        status.refusal = staging_.refuses.value_or(status.refusal);
        status.armed = status.armed && !staging_.isDisarmed;
        status.exploring = staging_.explores.value_or(status.exploring);
        return status;
    }

    RobotOnBus robot_;  // used by the thread only

    mutable std::mutex mutex_;  // guards the members below
    Staging staging_;
    bool lasting_ = false;
    TrueHeights truth_;

    End end_;
    std::jthread thread_;  // last member: the thread starts after all others exist
};

}  // namespace terratact
