#pragma once

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include "core/atem/console_link.h"
#include "core/atem/probe/arm_choice.h"
#include "core/infer/estimator.h"
#include "core/infer/two_track_estimator.h"
#include "core/learn/model/file/model_file.h"
#include "core/log/session_writer.h"
#include "core/sim/ground/terrain_shapes.h"
#include "core/sim/robot_on_bus.h"
#include "core/sim/two_track_check.h"
#include "core/store/file_read.h"
#include "core/store/sha256.h"

/// Sessions of a simulated drive, recorded like by the console, in simulated time.
namespace terratact {

/// A console and a simulated robot on a bus without delay, with every frame recorded. Throws std::runtime_error if a
/// step fails.
class RecordedDrive {
public:
    static constexpr double kStep = 3.0;  ///< [m] position of the step

    struct Options {
        double startBefore = 0.9;  ///< [m] start of the robot's middle before the step
        std::int64_t later = 0;    ///< [s] shift of the calendar time
        double lie = 0.0;          ///< [m] added to the recorded heights
    };
    RecordedDrive(const std::string& path, const std::string& robotFile,
                  const std::string& modelFile, const Options& options)
        : robotText_(*readFile(robotFile, 65536)), model_(*robotModelFrom(robotFile, robotText_)),
          models_(readModel(modelFile)->data, model_),
          robot_(model_, robotBefore(options.startBefore), {}), console_(model_, {}),
          lie_(options.lie),
          writer_(begin(path, options.later)), modelRow_{.id = 1,
                                                         .name = "default.ttm",
                                                         .hash = *sha256OfFile(modelFile)}
    {
        require(writer_.add(modelRow_));
        event({.kind = EventKind::Session, .subject = "begun"});
    }

    void arm()
    {
        pass(2.5);
        console_.wantArming();
        pass(0.2);
        console_.confirmArming();
        pass(0.2);
        event({.kind = EventKind::Arming, .subject = "armed"});
    }

    /// Drives until the robot's middle is `before` [m] before the step.
    void driveTo(double before)
    {
        command(DriveCommand{0.3});
        for (int i = 0; i < 600 && robot_.robot().pose().base.x < kStep - before; ++i) pass(0.05);
        command(HaltCommand{});
        pass(0.3);
    }

    /// Explores, with a probe if one is proposed. Returns the id of the last estimate.
    std::int64_t explore(const Settings& settings)
    {
        command(BeginAtemCommand{});
        pass(0.1);
        command(PressCommand{18.0});
        waitFor([](const Measurement& m) { return m.activity == RobotActivity::Pressed; });
        SceneRow scene{.id = ++scenes_,
                       .time = now(),
                       .measurement = *latest_,
                       .truth = robot_.robot().truth(),
                       .sideTruth = {{robot_.robot().truth(ProbeSide::Left),
                                      robot_.robot().truth(ProbeSide::Right)}}};
        require(writer_.add(scene));
        EstimateRow first = estimate(scene, settings, EstimateRole::First, {});
        if (const auto place = chooseProbe(first.estimate, model_)) {
            propose(first, *place);
            command(ProbeCommand{place->bin, place->side});
            waitFor([](const Measurement& m) { return m.arm.has_value(); });
            first = estimate(scene, settings, EstimateRole::Again, {*latest_->arm});
        }
        command(AbortAtemCommand{});
        pass(0.3);
        return first.id;
    }

    /// Adds a marker, which ends a batch.
    void mark(const std::string& note) { event({.kind = EventKind::Marker, .text = note}); }

    void seal()
    {
        event({.kind = EventKind::Session, .subject = "ended"});
        require(writer_.seal());
    }

    void pass(double seconds)
    {
        for (int i = 0; i < static_cast<int>(std::lround(seconds / 0.01)); ++i) {
            time_ += 0.01;
            console_.operatorAlive(time_);
            toRobot(console_.tick(time_));
            toConsole(robot_.tick(time_));
            if (++ticks_ % 20 == 0) require(writer_.commit());
        }
    }

private:
    static SimulatedRobot robotBefore(double distance)
    {
        SimulatedRobot::Options options;
        options.startX = kStep - distance;
        options.probeSeconds = 2.0;
        static const RobotModel absolem =
            *readRobotModel(TERRATACT_SOURCE_DIR "/resources/robots/absolem.toml");
        return SimulatedRobot(absolem, stepTerrain(0.24, kStep, 6.0), options);
    }

    SessionWriter begin(const std::string& path, std::int64_t later) const
    {
        auto writer =
            SessionWriter::create(path, {.wallTime = (1'793'000'000 + later) * 1'000'000'000,
                                         .program = "terratact-console test",
                                         .source = "SIMULATED ROBOT",
                                         .bus = "can0",
                                         .transmits = true,
                                         .robot = robotText_,
                                         .robotHash = sha256Hex(robotText_)});
        if (!writer) throw std::runtime_error(writer.error().text);
        return std::move(*writer);
    }

    static void require(const Status& status)
    {
        if (!status) throw std::runtime_error(status.error().text);
    }

    SessionTime now() const { return sessionTimeOf(time_); }

    void record(const CanFrame& frame, bool sent)
    {
        require(writer_.add(FrameRow{.time = now(), .frame = frame, .sent = sent}));
    }
    void toRobot(const std::vector<CanFrame>& frames)
    {
        for (const CanFrame& frame : frames) {
            record(frame, true);
            console_.receive(frame, true, time_);
            toConsole(robot_.receive(frame, time_));
        }
    }
    void toConsole(const std::vector<CanFrame>& frames)
    {
        for (const CanFrame& frame : frames) {
            record(frame, false);
            if (const auto measured = console_.receive(frame, false, time_)) latest_ = measured;
        }
    }

    void command(const Command& command)
    {
        const auto answer = console_.send(command, time_);
        if (!std::holds_alternative<CanFrame>(answer))
            throw std::runtime_error(describe(std::get<GateRefusal>(answer)).english);
        toRobot({std::get<CanFrame>(answer)});
    }

    template <class Condition>
    void waitFor(Condition wanted)
    {
        for (int i = 0; i < 600; ++i) {
            pass(0.05);
            if (latest_ && wanted(*latest_)) return;
        }
        throw std::runtime_error("the simulated robot does not do as told");
    }

    EstimateRow estimate(const SceneRow& scene, const Settings& settings, EstimateRole role,
                         std::vector<ArmReading> readings)
    {
        pass(0.1);
        EstimateRow row{.id = ++estimates_,
                        .time = now(),
                        .scene = scene.id,
                        .model = modelRow_.id,
                        .role = role,
                        .seconds = 0.1,
                        .readings = std::move(readings)};
        row.estimate = estimateMeasured(scene.measurement, row.readings, model_, models_, settings);
        writePosteriorCheck(row.estimate, scene.measurement, model_);
        for (TerrainEstimate& side : row.estimate.side)
            for (double& height : side.height) height += lie_;
        require(writer_.add(row));
        return row;
    }

    void propose(const EstimateRow& row, ProbePlace place)
    {
        const auto i = static_cast<std::size_t>(place.bin);
        const TerrainEstimate& e = sideOf(row.estimate, place.side);
        require(writer_.add(ProposalRow{.id = ++proposals_,
                                        .time = now(),
                                        .estimate = row.id,
                                        .bin = place.bin,
                                        .side = place.side,
                                        .height = e.height[i],
                                        .q10 = e.q10[i],
                                        .q90 = e.q90[i],
                                        .sd = e.sd[i],
                                        .limit = e.settings.probeAbove,
                                        .armSd = model_.armSd,
                                        .seconds = 2.0,
                                        .stepLimit = row.stepLimit,
                                        .grounds = std::string(64, 'b')}));
        pass(0.5);
        event({.kind = EventKind::Decision,
               .subject = "approve",
               .text = "probe of bin " + std::to_string(place.bin),
               .number = static_cast<double>(place.bin),
               .estimate = row.id,
               .proposal = proposals_,
               .shown = "sd " + std::to_string(e.sd[i]) + " m"});
        console_.approve({place.bin, place.side}, time_);
    }

    void event(EventRow row)
    {
        row.id = ++events_;
        row.time = now();
        require(writer_.add(row));
        require(writer_.commit());
    }

    std::string robotText_;
    RobotModel model_;
    Models models_;
    RobotOnBus robot_;
    ConsoleLink console_;
    double lie_;
    SessionWriter writer_;
    ModelRow modelRow_;
    double time_ = 0.0;  ///< [s]
    int ticks_ = 0;
    std::int64_t scenes_ = 0, estimates_ = 0, proposals_ = 0, events_ = 0;
    std::optional<Measurement> latest_;
};

/// Records a drive to a step with two explorations, each with a probe. The first is by `pafc` on flat ground, the
/// second by `local` before the step. Sealed.
inline void recordDrive(const std::string& path, const RecordedDrive::Options& options = {})
{
    RecordedDrive drive(path, TERRATACT_SOURCE_DIR "/resources/robots/absolem.toml",
                        TERRATACT_SOURCE_DIR "/resources/models/default.ttm", options);
    drive.arm();
    drive.driveTo(0.6);
    drive.explore({.method = Method::Pafc, .draws = 64, .burnIn = 8, .inducing = 100, .seed = 7});
    drive.mark("before the step, \"closer\" now");
    drive.driveTo(0.47);
    drive.explore({.seed = 8});
    drive.seal();
}

/// Records a drive to the step with an exploration every few centimetres. Contacts then lie where an earlier estimate
/// was sampled. Sealed.
inline void recordShortMoves(const std::string& path, std::int64_t later = 0)
{
    RecordedDrive drive(path, TERRATACT_SOURCE_DIR "/resources/robots/absolem.toml",
                        TERRATACT_SOURCE_DIR "/resources/models/default.ttm", {.later = later});
    drive.arm();
    std::uint64_t seed = 0;
    for (const double before : {0.62, 0.57, 0.52, 0.47}) {
        drive.driveTo(before);
        drive.explore({.seed = ++seed});
    }
    drive.seal();
}

}  // namespace terratact
