// Tests the memory of the way: what estimates use it, why they do not, and that a session repeats them.
#include "app/mission/way_memory.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "app/mission/memory_text.h"
#include "app/mission/session_event_logger.h"
#include "app/recording/session_folder.h"
#include "app/recording/session_recorder.h"
#include "app/recording/what_if.h"
#include "core/infer/estimate/felt_horizon.h"
#include "core/learn/model/file/model_file.h"
#include "core/sim/ground/terrain_shapes.h"
#include "core/store/file_read.h"
#include "core/trail/trail_file.h"
#include "tests/support/benches/simulated_exploration.h"
#include "tests/support/sessions/session_files.h"
#include "tests/support/sessions/sessions.h"
#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

const std::string kModels = TERRATACT_SOURCE_DIR "/resources/models/";

TerrainProfile rolling(double phase)
{
    std::vector<Vec2> points;
    for (double x = 0.0; x <= 10.0; x += 0.05)
        points.push_back({x, 0.04 * std::sin(2.1 * x + phase)});
    return TerrainProfile(points);
}

Exploration::Options byTrail()
{
    Exploration::Options options;
    options.settings.method = Method::Trail;
    return options;
}

SimulatedRobot::Options atStart()
{
    SimulatedRobot::Options options;
    options.startX = 1.5;
    options.probeSeconds = 0.4;
    return options;
}

TEST(MemoryText, CountsHowOftenBandsHeld)
{
    const Message words(TR_NOOP("terratact::Estimation", "no memory: %1"), verbatim("x"));
    EXPECT_EQ(withLedger(words, {}), words) << "nothing was touched again";
    StripLedger ledger;
    ledger.add(ScoredBy::Contact, {0.0, 0.01, -0.013, 0.013}, 0.0, 0.0);
    ledger.add(ScoredBy::Pass, {0.0, 0.01, -0.013, 0.013}, 0.1, 0.0);
    EXPECT_EQ(translated(withLedger(words, ledger)), "no memory: x · bands held: 1 of 2");
    EXPECT_EQ(translated(withLedger({}, ledger)), "bands held: 1 of 2");
}

struct OneGround : testing::Test, SimulatedExploration {
    OneGround() : SimulatedExploration(GroundLines({{0.0, rolling(0.0)}}), atStart(), byTrail())
    {
        begin();
    }
};

TEST_F(OneGround, ADriveIsRemembered)
{
    ASSERT_TRUE(explore()) << eventText();
    EXPECT_EQ(method(), Method::Local);
    EXPECT_EQ(memory(), "no memory: the way begins here");
    EXPECT_EQ(estimation().estimate()->side[0].warnings, std::vector<Message>{});
    driveBy(0.3);
    ASSERT_TRUE(explore()) << eventText();
    EXPECT_EQ(method(), Method::Trail);
    EXPECT_EQ(estimation().scene()->memory.history->presses, 1);
    EXPECT_NE(memory().find("m · earlier presses: 1"), std::string::npos) << memory();
    driveBy(0.4);
    driveBy(0.6);
    ASSERT_TRUE(explore()) << eventText();
    EXPECT_EQ(memory(), "memory: 1.20 m · earlier presses: 1")
        << "the other press lies too far behind";
    EXPECT_EQ(eventText().find("memory cleared"), std::string::npos) << eventText();
}

TEST_F(OneGround, LostTelemetryClearsTheMemory)
{
    driveBy(0.6);
    loseTelemetry(1.5);
    ASSERT_TRUE(explore()) << eventText();
    EXPECT_EQ(method(), Method::Local);
    EXPECT_EQ(memory().find("memory cleared: telemetry was missing"), 0U) << memory();
    EXPECT_NE(eventText().find("memory cleared"), std::string::npos);
    driveBy(0.3);
    ASSERT_TRUE(explore()) << eventText();
    EXPECT_EQ(method(), Method::Trail);
    EXPECT_LT(estimation().scene()->memory.history->way, 0.5);
}

TEST_F(OneGround, TurningOnTheSpotClearsTheMemory)
{
    driveBy(0.6);
    double turned = 0.0;
    change = [&turned](Measurement& line) { line.turned = line.turned.value_or(0.0) + turned; };
    for (int i = 0; i < 20; ++i) {
        turned += 0.05;
        tick();
    }
    ASSERT_TRUE(explore()) << eventText();
    EXPECT_EQ(method(), Method::Local);
    EXPECT_EQ(memory(), "memory cleared: the robot has turned");
}

TEST_F(OneGround, WithoutOdometryThereIsNoMemory)
{
    change = [](Measurement& line) { line.travelled.reset(); };
    driveBy(0.6);
    ASSERT_TRUE(explore()) << eventText();
    EXPECT_EQ(method(), Method::Local);
    EXPECT_EQ(memory(), "no memory: the robot reports no odometry");
}

TEST_F(OneGround, ASuspectedPitchIsNotRemembered)
{
    driveBy(0.3);
    suspicions = {{.sensor = Sensor::Pitch}};
    driveBy(0.3);
    ASSERT_TRUE(explore()) << eventText();
    EXPECT_EQ(method(), Method::Local);
    EXPECT_EQ(memory(), "no memory: the odometry or the pitch is suspected");
    suspicions.clear();
    driveBy(0.3);
    ASSERT_TRUE(explore()) << eventText();
    EXPECT_EQ(method(), Method::Trail);
    EXPECT_LT(estimation().scene()->memory.history->way, 0.5);
}

TEST_F(OneGround, ASuspectedPitchLeavesTheStrip)
{
    ASSERT_TRUE(explore()) << eventText();
    driveBy(0.1);
    EXPECT_FALSE(estimation().remembered().isEmpty());
    suspicions = {{.sensor = Sensor::Pitch}};
    driveBy(0.3);
    ASSERT_TRUE(explore()) << eventText();
    EXPECT_TRUE(estimation().remembered().isEmpty());
    EXPECT_EQ(estimation().strip().sections().size(), 1U) << "the estimate has no place";
}

TEST_F(OneGround, AMissingCurrentKeepsTheMemoryUnused)
{
    change = [](Measurement& line) { line.missing[kFrontCurrentFeature] = true; };
    driveBy(0.6);
    ASSERT_TRUE(explore()) << eventText();
    EXPECT_EQ(memory(), "no memory but of the arm: a current or a force was not measured");
}

TEST_F(OneGround, ForgettingForgetsTheWay)
{
    driveBy(0.6);
    ASSERT_TRUE(explore()) << eventText();
    ASSERT_EQ(method(), Method::Trail);
    const std::string before = memory();
    const auto shown = estimation().estimate();
    exploration.forgetResult();
    tick();
    EXPECT_EQ(memory(), "");
    exploration.restoreResult();
    tick();
    EXPECT_EQ(memory(), before);
    EXPECT_EQ(estimation().estimate(), shown);
    driveBy(0.3);
    ASSERT_TRUE(explore()) << eventText();
    EXPECT_GT(estimation().scene()->memory.history->way, 0.8) << "the way is back, too";
    exploration.forgetResult();
    tick(3);
    ASSERT_TRUE(explore()) << eventText();
    EXPECT_EQ(method(), Method::Local);
    EXPECT_EQ(memory(), "memory cleared: the remembered ground was cleared");
}

TEST_F(OneGround, AnotherMethodHasNothingToSay)
{
    exploration.setSettings({});
    driveBy(0.6);
    ASSERT_TRUE(explore()) << eventText();
    EXPECT_EQ(method(), Method::Local);
    EXPECT_EQ(memory(), "");
    EXPECT_TRUE(estimation().scene()->memory.history) << "a review may use it";
}

TEST(WayMemory, AModelWithoutNetworksHasNoMemory)
{
    SimulatedExploration bench(GroundLines({{0.0, rolling(0.0)}}), atStart(), byTrail(),
                               kModels + "one_plane.ttm");
    bench.begin();
    bench.driveBy(0.6);
    ASSERT_TRUE(bench.explore()) << bench.eventText();
    EXPECT_EQ(bench.method(), Method::Local);
    EXPECT_EQ(bench.memory(),
              "no memory: the model has no networks for it (one_plane.ttn is not beside it)");
}

TEST(WayMemory, BrokenNetworksAreNamed)
{
    TemporaryDirectory directory;
    std::filesystem::copy_file(kModels + "default.ttm", directory.file("own.ttm"));
    std::ofstream(directory.file("own.ttn")) << "no networks";
    const LoadedTrail trail = trailBeside(directory.file("own.ttm"), absolem());
    EXPECT_FALSE(trail.model);
    EXPECT_NE(trail.about.trouble.english().find("own.ttn"), std::string::npos)
        << trail.about.trouble.english();
    EXPECT_TRUE(modelFileLoader(directory.file("own.ttm"), absolem())()) << "the model serves";
}

TEST(WayMemory, NetworksServeRobotsOfTheSameShape)
{
    RobotModel other = absolem();
    other.armSd += 0.01;
    EXPECT_TRUE(fitSameNetworks(absolem(), other));
    other.rear.tipRadius += 0.001;
    EXPECT_FALSE(fitSameNetworks(absolem(), other));
    other = absolem();
    other.elementShare[2] += 0.01;
    EXPECT_FALSE(fitSameNetworks(absolem(), other));
}

/// Explores and probes the ground at 0.6 m.
void exploreAndProbe(SimulatedExploration& bench)
{
    bench.exploration.askProbe({9});
    if (!bench.reaches(AtemPhase::ProposingProbe)) throw std::runtime_error(bench.eventText());
    bench.exploration.approve(bench.exploration.proposal()->id);
    EXPECT_TRUE(bench.reaches(AtemPhase::Presenting)) << bench.eventText();
    EXPECT_EQ(bench.estimation().readings().size(), 1U) << bench.eventText();
}

bool remembersAProbe(const SceneRow& scene)
{
    return scene.memory && std::ranges::any_of(scene.memory->ground, [](const TrailGround& ground) {
               return std::ranges::any_of(ground.armSd, [](double sd) { return sd > 0.0; });
           });
}

/// Records a drive with estimates and a probe, and opens the session.
SessionReader recorded(SimulatedExploration& bench, const std::string& folder)
{
    SessionStart start = someStart();
    start.robot = *readFile(TERRATACT_SOURCE_DIR "/resources/robots/absolem.toml", 1U << 16U);
    {
        const auto recorder = std::make_shared<SessionRecorder>(
            SessionRecorder::Options{.folder = folder, .start = start, .patience = kBusyDisk});
        SessionEventLogger logger(recorder, bench.exploration, bench.worker, nullptr);
        bench.begin();
        EXPECT_TRUE(bench.explore()) << bench.eventText();
        bench.driveBy(0.3);
        exploreAndProbe(bench);
        bench.exploration.request();  // in place: the reading still counts
        EXPECT_TRUE(bench.reaches(AtemPhase::Estimating)) << bench.eventText();
        EXPECT_TRUE(bench.explore()) << bench.eventText();
        for (const double way : {0.1, 0.3}) {
            bench.driveBy(way);
            EXPECT_TRUE(bench.explore()) << bench.eventText();
        }
    }
    const auto files = sessionsIn(folder);
    if (files.size() != 1) throw std::runtime_error("one session is expected");
    auto reader = SessionReader::open(files[0]);
    if (!reader) throw std::runtime_error(reader.error().text);
    return std::move(*reader);
}

void expectRepeated(SessionReader& session)
{
    Models models(readModel(kModels + "default.ttm")->data, absolem());
    models.trail =
        std::make_shared<const TrailModel>(std::move(readTrail(kModels + "default.ttn")->data));
    EXPECT_EQ(session.models().at(0).trailName, "default.ttn");
    int remembering = 0, probed = 0, probedBefore = 0, afterAProbe = 0;
    for (const EstimateRow& row : session.estimates()) {
        const Settings& settings = row.estimate.side[0].settings;
        remembering += settings.method == Method::Trail ? 1 : 0;
        const auto before = recordedEstimate(session, row);
        const auto again = estimateAgain(session, row, models, settings);
        ASSERT_TRUE(before && again);
        EXPECT_TRUE(isTouchRecorded(before->side[0]) && isTouchRecorded(before->side[1]));
        probed += row.readings.empty() ? 0 : 1;
        probedBefore += row.role == EstimateRole::First && !row.readings.empty() ? 1 : 0;
        afterAProbe += remembersAProbe(*session.scene(row.scene)) ? 1 : 0;
        const Measurement& scene = session.scene(row.scene)->measurement;
        EXPECT_EQ(differencesBetween(*before, *again, absolem(), scene, row.stepLimit).match,
                  Match::Identical)
            << row.id;
        if (settings.method != Method::Trail) continue;
        Settings local = settings;
        local.method = Method::Local;
        const auto other = estimateAgain(session, row, models, local);
        ASSERT_TRUE(other);
        EXPECT_NE(other->side[0].height, again->side[0].height) << "the memory counts";
    }
    EXPECT_EQ(remembering, 5);
    EXPECT_EQ(probed, 2);
    EXPECT_EQ(probedBefore, 1) << "the first estimate after a press in place";
    EXPECT_GE(afterAProbe, 1) << "the arm's reading is carried along the way";
}

TEST(RecordedMemory, EstimatesOfOnePlaneAreRepeatedBitForBit)
{
    TemporaryDirectory directory;
    SimulatedExploration bench(GroundLines({{0.0, rolling(0.0)}}), atStart(), byTrail());
    SessionReader session = recorded(bench, directory.file("sessions"));
    expectRepeated(session);
}

TEST(RecordedMemory, EstimatesOfTwoTracksAreRepeatedBitForBit)
{
    TemporaryDirectory directory;
    SimulatedExploration bench(GroundLines({{0.2, rolling(0.0)}, {-0.2, rolling(1.0)}}), atStart(),
                               byTrail());
    SessionReader session = recorded(bench, directory.file("sessions"));
    EXPECT_FALSE(session.estimates().back().estimate.onePlane);
    expectRepeated(session);
}

}  // namespace
}  // namespace terratact
