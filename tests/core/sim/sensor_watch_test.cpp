#include "core/robot/watch/sensor_watch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <random>
#include <vector>

#include "core/log/session_reader.h"
#include "core/robot/robot_model.h"
#include "core/sim/fault_matrix.h"
#include "core/sim/fault_trial.h"
#include "core/sim/ground/random_terrain.h"
#include "core/sim/sensor_fault.h"
#include "core/sim/watched_drive.h"
#include "core/wire/telemetry_listener.h"
#include "tests/support/absolem.h"

namespace terratact {
namespace {

/// Three drives of different ground and style, made once.
const std::vector<std::vector<WatchedLine>>& drives()
{
    static const auto made = [] {
        std::vector<std::vector<WatchedLine>> drives;
        for (const unsigned seed : {3U, 4U, 8U}) {
            std::mt19937_64 rng(seed);
            const TerrainProfile ground = randomVariedTerrain(rng);
            WatchedStyle style;
            style.flippers = randomDriveStyle(rng);
            style.period = 0.1;
            drives.push_back(driveWithTelemetry(absolem(), ground, style, seed));
        }
        return drives;
    }();
    return made;
}

int noticedOn(std::string_view fault)
{
    int noticed = 0;
    for (std::size_t k = 0; k < drives().size(); ++k)
        noticed += watchFault(drives()[k], absolem(), fault, k).noticed ? 1 : 0;
    return noticed;
}

class TriedFaults : public testing::TestWithParam<TriedFault> {};

TEST_P(TriedFaults, AreNoticedOrNamedInTheLimits)
{
    const TriedFault& tried = GetParam();
    if (tried.fault.empty() || !tried.limit.empty()) return;
    EXPECT_EQ(noticedOn(tried.fault), static_cast<int>(drives().size())) << tried.words;
}

INSTANTIATE_TEST_SUITE_P(All, TriedFaults,
                         testing::ValuesIn(triedFaults().begin(), triedFaults().end()));

TEST(FaultMatrix, NoticesEachFaultOrGivesTheReason)
{
    const auto cells = faultMatrix();
    EXPECT_EQ(cells.size(), 29 * matrixKinds().size());  // 2 + 4 + 4 + 6 + 12 + 1 sensors
    std::size_t noticed = 0;
    for (const MatrixCell& cell : cells) {
        if (!cell.reason.empty()) continue;
        ++noticed;
        EXPECT_GE(noticedOn(cell.fault), 2) << cell.fault;
    }
    EXPECT_GT(noticed, cells.size() / 3);
}

TEST(SensorWatch, IsSilentOnHealthyDrives)
{
    EXPECT_EQ(noticedOn(""), 0);
}

TEST(SensorWatch, IsSilentForAnHourOfHealthyTelemetry)
{
    double seconds = 0.0;
    SensorWatch watch(absolem());
    double from = 0.0;
    std::mt19937_64 rng(21);
    while (seconds < 3600.0) {
        WatchedStyle style;
        style.flippers = randomDriveStyle(rng);
        style.standing = 20.0;  // with a probe now and then
        style.period = 0.1;
        const auto lines = driveWithTelemetry(absolem(), randomVariedTerrain(rng), style, rng());
        for (const WatchedLine& line : lines) {
            Measurement sensed = line.measurement;
            sensed.time += from;
            watch.add(sensed);
            ASSERT_TRUE(watch.standing().empty())
                << describe(watch.standing().front()).english() << " at " << sensed.time;
        }
        seconds += lines.back().measurement.time;
        from += lines.back().measurement.time + 2.0;  // another robot, another ground
    }
}

TEST(SensorWatch, IsSilentOverTheShippedSession)
{
    auto session = SessionReader::open(TERRATACT_SOURCE_DIR "/resources/sessions/demo.tts");
    ASSERT_TRUE(session) << session.error().text;
    TelemetryListener listener(absolem());
    SensorWatch watch(absolem());
    int lines = 0;
    for (std::size_t batch = 0; batch < session->batches().size(); ++batch)
        for (const FrameRow& row : session->frames(batch)) {
            const auto line = listener.receive(row.frame, secondsOf(row.time));
            if (!line) continue;
            ++lines;
            watch.add(*line);
            ASSERT_TRUE(watch.standing().empty())
                << describe(watch.standing().front()).english() << " at " << line->time;
        }
    EXPECT_GT(lines, 1000);
}

TEST(SensorWatch, NamesTheSensorAndTheKind)
{
    const WatchedFault watched = watchFault(drives()[0], absolem(), "stuck:pitch", 0);
    ASSERT_FALSE(watched.first.empty());
    EXPECT_EQ(watched.first.front().sensor, Sensor::Pitch);
    EXPECT_EQ(watched.first.front().trouble, SensorTrouble::Stuck);
    SensorSuspicion later = watched.first.front();
    later.amount = 12.0;
    later.way = 0.6;
    EXPECT_EQ(describe(later).english(),
              "pitch angle: not changed for 12 s while the robot drove 0.6 m, stuck?");
}

TEST(SensorWatch, DoesNotBlameAMissingCurrent)
{
    SensorWatch watch(absolem());
    for (const WatchedLine& line : drives()[0]) {
        Measurement sensed = line.measurement;
        MotorCurrents currents = motorCurrents(sensed);
        currents[0].reset();
        setCurrents(sensed, currents);
        watch.add(sensed);
        for (const SensorSuspicion& s : watch.standing())
            ASSERT_NE(kindOf(s.sensor), SensorKind::Current) << describe(s).english();
    }
}

TEST(SensorWatch, DoesNotBlameLostSensors)
{
    for (const char* fault : {"lost:front-left-current", "lost:forces"})
        EXPECT_EQ(noticedOn(fault), 0) << fault;
}

/// Adds a press of 2 s that begins at `start` [s] and returns the suspected sensors. `change` changes a line that
/// rested for so long [s].
std::vector<Sensor> addPress(SensorWatch& watch, double start,
                             const std::function<void(Measurement&, double)>& change)
{
    for (int k = 0; k < 60; ++k) {
        Measurement line;
        line.time = start + 0.05 * k;
        line.activity = k < 10 ? RobotActivity::Halted
                      : k < 20 ? RobotActivity::Pressing
                               : RobotActivity::Pressed;
        setCurrents(line, {1.5, 1.5, 0.0, 0.0});
        line.force.fill(4.0);
        change(line, 0.05 * (k - 20));
        watch.add(line);
    }
    std::vector<Sensor> suspected;
    for (const SensorSuspicion& each : watch.standing()) suspected.push_back(each.sensor);
    return suspected;
}

std::vector<Sensor> suspectedInAPress(const std::function<void(Measurement&, double)>& change)
{
    SensorWatch watch(absolem());
    return addPress(watch, 0.0, change);
}

TEST(SensorWatch, AMissingCurrentClearsNoSuspicion)
{
    const auto from = [](double since, std::optional<double> current) {
        return [=](Measurement& line, double rested) {
            if (rested >= since) setCurrents(line, {current, 1.5, 0.0, 0.0});
        };
    };
    SensorWatch watch(absolem());
    const auto isSuspected = [&](double start, double since, std::optional<double> current) {
        const auto suspected = addPress(watch, start, from(since, current));
        return std::ranges::count(suspected, Sensor::FrontLeftCurrent) == 1;
    };
    EXPECT_TRUE(isSuspected(0.0, 0.3, 0.0));
    EXPECT_TRUE(isSuspected(3.0, -9.0, std::nullopt));
    EXPECT_FALSE(isSuspected(6.0, -9.0, 1.5));
}

TEST(SensorWatch, AReadingThatGetsLostInAPressIsNotLate)
{
    const auto lateFrom = [](double current, double force) {
        return suspectedInAPress([=](Measurement& line, double rested) {
            if (rested < 0.3) return;
            setCurrents(line, {current, 1.5, 0.0, 0.0});
            line.force[5] = force;
        });
    };
    EXPECT_EQ(lateFrom(1.5, 4.0).size(), 0U);
    EXPECT_EQ(lateFrom(0.0, 4.0), std::vector{Sensor::FrontLeftCurrent});
    EXPECT_EQ(lateFrom(1.5, 18.0).size(), 6U) << "the forces";
    const auto suspected = suspectedInAPress([](Measurement& line, double rested) {
        if (rested < 0.3) return;
        setCurrents(line, {std::nullopt, 1.5, 0.0, 0.0});
        line.force.fill(0.0);
        line.missing |= MissingFeatures(0b111111U << kFirstForceFeature);
    });
    EXPECT_TRUE(suspected.empty());
}

TEST(SensorWatch, ForcesNeedAllElementsToBeWithoutLoad)
{
    const auto unloaded = [](std::size_t missing) {
        return suspectedInAPress([missing](Measurement& line, double) {
            line.force.fill(0.0);
            for (std::size_t e = 0; e < missing; ++e) line.missing[kFirstForceFeature + e] = true;
        });
    };
    EXPECT_EQ(unloaded(0).size(), 6U);
    EXPECT_TRUE(unloaded(1).empty()) << "it may carry the load";
    EXPECT_TRUE(unloaded(6).empty());
}

TEST(SensorWatch, ClearsASensorThatRecovers)
{
    SensorWatch watch(absolem());
    const auto& lines = drives()[0];
    FaultySensors faulty(*sensorFaultFrom("stuck:pitch"), absolem(), 1);
    const double mended = 10.0;
    bool stood = false;
    for (const WatchedLine& line : lines) {
        const bool isFaulty = line.measurement.time < mended;
        watch.add(isFaulty ? faulty.apply(line.measurement) : line.measurement);
        stood = stood || !watch.standing().empty();
        if (line.measurement.time > mended + StuckWatch::kHold + 5.0) break;
    }
    EXPECT_TRUE(stood);
    EXPECT_TRUE(watch.standing().empty());
}

TEST(SensorWatch, RestartsWhenTimeGoesBack)
{
    SensorWatch watch(absolem());
    FaultySensors faulty(*sensorFaultFrom("stuck:pitch"), absolem(), 1);
    for (const WatchedLine& line : drives()[0]) watch.add(faulty.apply(line.measurement));
    ASSERT_FALSE(watch.standing().empty());
    Measurement early = drives()[0].front().measurement;
    early.time = -5.0;
    watch.add(early);
    EXPECT_TRUE(watch.standing().empty());
}

TEST(SensorWatch, DoesNotCallAMissingRollStuck)
{
    SensorWatch watch(absolem());
    for (const WatchedLine& line : drives()[0]) {
        Measurement m = line.measurement;
        m.roll = 0.0;
        watch.add(m);
        ASSERT_TRUE(watch.standing().empty());
    }
}

/// Suspicions of a press whose front flippers go from one pair of angles [rad] to another.
std::vector<SensorSuspicion> suspicionsOfPress(std::array<double, 2> from, std::array<double, 2> to)
{
    SensorWatch watch(absolem());
    std::vector<SensorSuspicion> all;
    for (int k = 0; k < 40; ++k) {
        Measurement line;
        line.time = 0.05 * k;
        line.activity = k < 10 ? RobotActivity::Halted
                      : k < 20 ? RobotActivity::Pressing
                               : RobotActivity::Pressed;
        const auto& angles = k < 10 ? from : to;
        line.frontLeft = angles[0];
        line.frontRight = angles[1];
        line.frontLeftCurrent = line.frontRightCurrent = k < 20 ? 0.0 : 1.5;
        watch.add(line);
        for (const SensorSuspicion& each : watch.standing()) all.push_back(each);
    }
    std::erase_if(all, [](const auto& each) { return each.trouble != SensorTrouble::Flipped; });
    return all;
}

TEST(SensorWatch, AFlipperThatAKerbLiftsIsNotFlipped)
{
    EXPECT_TRUE(suspicionsOfPress({0.7, 0.7}, {0.9, -0.2}).empty());
    EXPECT_TRUE(suspicionsOfPress({0.5, -0.1}, {0.7, -0.2}).empty());
}

TEST(SensorWatch, AFlippedFrontAngleIsNamed)
{
    const auto one = suspicionsOfPress({-0.7, 0.7}, {0.2, -0.2});
    ASSERT_FALSE(one.empty());
    EXPECT_EQ(one.front().sensor, Sensor::FrontLeft);
    EXPECT_FALSE(suspicionsOfPress({-0.7, -0.7}, {0.2, 0.2}).empty());
}

TEST(SensorWatch, RefusesATimeThatIsNotFinite)
{
    SensorWatch watch(absolem());
    Measurement m;
    m.time = NAN;
    EXPECT_THROW(watch.add(m), std::invalid_argument);
}

}  // namespace
}  // namespace terratact
