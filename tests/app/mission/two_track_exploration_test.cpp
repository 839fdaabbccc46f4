// Tests explorations whose estimates are of both sides.
#include <cmath>

#include "app/mission/estimation.h"
#include "core/sim/ground/terrain_shapes.h"
#include "tests/support/benches/exploration_bench.h"
#include "tests/support/benches/simulated_exploration.h"

namespace terratact {
namespace {

/// Returns the fake estimate of both sides: the left side has the step, the right side is level.
TwoTrackEstimate unevenEstimate(const EstimateRequest& request)
{
    const bool isProbed = !request.arm.empty();
    TwoTrackEstimate both{.side = {isProbed ? probedEstimate() : stepEstimate(), stepEstimate()}};
    both.side[1].height.fill(-0.25);
    both.side[1].sd.fill(0.02);
    for (TerrainEstimate& side : both.side) {
        side.draws.assign(200, side.height);
        side.settings = request.settings;
    }
    for (std::size_t d = 0; d < 200; d += 2) both.side[0].draws[d][kBin06] += 0.09;
    both.side[0].warnings.push_back(Message::verbatim("the left side is odd"));
    return both;
}

struct UnevenBench : Bench {
    UnevenBench()
    {
        worker->load([this]() -> Result<LoadedModel> {
            return LoadedModel{.estimate =
                                   [this](const EstimateRequest& request, const Watch&) {
                                       const std::scoped_lock lock(mutex);
                                       asked = request;
                                       return unevenEstimate(request);
                                   },
                               .name = "both.ttm",
                               .details = {},
                               .hasTwoTracks = true};
        });
        EXPECT_TRUE(gui::eventually([this] { return events.contains("model both.ttm loaded"); }));
        SideForces known;
        known.left.fill(1.0);
        known.right.fill(1.0);
        setSides(telemetry, known);
        telemetry.roll = 0.2;
        tick(3);
    }
    bool says(const char* words) const { return events.join('\n').contains(words); }
};

TEST_F(UnevenBench, theProbeHasASide)
{
    ASSERT_NO_FATAL_FAILURE(propose());
    const ProbeProposal shown = *exploration->proposal();
    EXPECT_EQ(shown.side, ProbeSide::Left) << "the less certain one";
    EXPECT_EQ(shown.bin, kBin06);
    EXPECT_EQ(shown.sd, stepEstimate().sd[kBin06]);
    EXPECT_TRUE(says("probe proposed left at 0.6 m"));
    exploration->approve(shown.id);
    ASSERT_TRUE(reaches(AtemPhase::Probing));
    EXPECT_EQ(exploration->probingPlace(), (ProbePlace{kBin06, ProbeSide::Left}));
    (void)sent<ProbeCommand>();
    ASSERT_FALSE(all.empty());
    const auto& command = std::get<ProbeCommand>(all.back());
    EXPECT_EQ(command.bin, kBin06);
    EXPECT_EQ(command.side, ProbeSide::Left);

    telemetry.activity = RobotActivity::Probing;
    tick(3);
    telemetry.activity = RobotActivity::Pressed;
    telemetry.arm = ArmReading{.bin = kBin06, .height = -0.04, .sd = 0.03};
    tick(5);
    EXPECT_EQ(phase(), AtemPhase::Probing) << "a reading in the middle is no answer";
    telemetry.arm->side = ProbeSide::Left;
    ASSERT_TRUE(reaches(AtemPhase::Presenting));
    EXPECT_TRUE(says("arm left at 0.6 m: −0.04 m, inside the band shown before"));
    ASSERT_EQ(lastAsked().arm.size(), 1U);
    EXPECT_EQ(lastAsked().arm[0].side, ProbeSide::Left);
    ASSERT_EQ(exploration->estimation().ledger().entries().size(), 1U);
    EXPECT_TRUE(exploration->estimation().ledger().entries()[0].in80) << "of the left side";
}

TEST_F(UnevenBench, theVerdictIsOfEachSide)
{
    ASSERT_NO_FATAL_FAILURE(propose());
    const TwoTrackVerdict verdict = *exploration->estimation().verdict();
    EXPECT_FALSE(verdict.onePlane);
    EXPECT_EQ(verdict.side[0].stepVerdict, StepVerdict::Blocked);
    EXPECT_NE(verdict.side[1].stepVerdict, StepVerdict::Blocked);
    EXPECT_EQ(verdict.both, StepVerdict::Blocked);
    EXPECT_TRUE(says("left: the left side is odd"));
    EXPECT_TRUE(says("left: a step of more than"));
}

TEST_F(UnevenBench, rollGivesNoWarningBeforeAnExploration)
{
    const auto level = [this] { return exploration->preconditions().back().level; };
    EXPECT_EQ(level(), Precondition::Level::Met);
    Settings paper = exploration->options().settings;
    paper.method = Method::Pafc;
    exploration->setSettings(paper);
    tick(3);
    EXPECT_EQ(level(), Precondition::Level::Doubtful) << "this method estimates one plane";
    exploration->setSettings(Settings{});
    telemetry.sides = {};
    tick(3);
    EXPECT_EQ(level(), Precondition::Level::Doubtful) << "the sides are not known";
}

TEST_F(UnevenBench, anotherSideIsChosenByTheOperator)
{
    ASSERT_NO_FATAL_FAILURE(propose());
    exploration->choose(exploration->proposal()->id, {8, ProbeSide::Right});
    EXPECT_EQ(exploration->proposal()->side, ProbeSide::Right);
    EXPECT_EQ(exploration->proposal()->bin, 8);
    EXPECT_EQ(exploration->proposal()->height, -0.25);
    exploration->choose(exploration->proposal()->id, {kBin06, ProbeSide::Middle});
    EXPECT_EQ(exploration->proposal()->side, ProbeSide::Left) << "the less certain side";
}

TEST_F(UnevenBench, bothSidesAreRemembered)
{
    telemetry.travelled = 0.0;
    telemetry.turned = 0.0;
    ASSERT_NO_FATAL_FAILURE(propose());
    exploration->refuse(exploration->proposal()->id);
    ASSERT_TRUE(reaches(AtemPhase::Presenting));
    telemetry.activity = RobotActivity::Driving;
    telemetry.travelled = 0.1;
    tick(3);
    const SeenStrip seen = exploration->estimation().remembered();
    EXPECT_FALSE(seen.onePlane);
    ASSERT_EQ(seen.side[0].size(), std::size_t{kBins});
    EXPECT_NEAR(seen.side[0][8].x, 0.4, 1e-6);
    EXPECT_NEAR(seen.side[0][8].band.height, -0.05, 1e-9) << "the step is nearer now";
    EXPECT_NEAR(seen.side[1][8].band.height, -0.25, 1e-9);
}

/// The simulated robot before a kerb on its left side, with the shipped model.
struct KerbBench : testing::Test, SimulatedExploration {
    static constexpr double kKerb = 2.5, kHeight = 0.16;  // [m]

    static TerrainProfile kerb()
    {
        return TerrainProfile({{0.0, 0.0}, {kKerb - 0.001, 0.0}, {kKerb, kHeight}, {6.0, kHeight}});
    }
    static SimulatedRobot::Options at(double x)
    {
        SimulatedRobot::Options options;
        options.startX = x;
        options.probeSeconds = 0.4;
        return options;
    }
    KerbBench()
        : SimulatedExploration(GroundLines({{0.2, kerb()}, {-0.2, flatTerrain(6.0)}}), at(1.96))
    {
        begin();
    }
};

TEST_F(KerbBench, aKerbOnTheLeftBlocksTheLeftSide)
{
    exploration.request();
    ASSERT_TRUE(reaches(AtemPhase::ProposingProbe) || reaches(AtemPhase::Presenting))
        << eventText();
    const TwoTrackEstimate& estimate = *exploration.estimation().estimate();
    EXPECT_FALSE(estimate.onePlane);
    const TwoTrackVerdict verdict = *exploration.estimation().verdict();
    EXPECT_EQ(describe(verdict).find("left BLOCKED at +0.6 m · right CLEAR to +0.55 m"), 0U)
        << describe(verdict) << '\n'
        << eventText();
    EXPECT_EQ(verdict.both, StepVerdict::Blocked);
    EXPECT_EQ(eventText().find("the same left and right"), std::string::npos) << eventText();
}

TEST_F(KerbBench, theArmTouchesTheSideThatWasAsked)
{
    exploration.askProbe({10, ProbeSide::Right});
    ASSERT_TRUE(reaches(AtemPhase::ProposingProbe)) << eventText();
    EXPECT_EQ(exploration.proposal()->side, ProbeSide::Right);
    const TerrainEstimate shown = exploration.estimation().estimate()->side[1];
    exploration.approve(exploration.proposal()->id);
    ASSERT_TRUE(reaches(AtemPhase::Presenting)) << eventText();
    const TwoTrackEstimate& estimate = *exploration.estimation().estimate();
    EXPECT_EQ(estimate.side[1].origin[10], Origin::Arm);
    EXPECT_EQ(estimate.side[0].origin[10], Origin::Sampled);
    const double truth = robot.stance().truth(ProbeSide::Right)[10];
    ASSERT_EQ(exploration.estimation().readings().size(), 1U);
    EXPECT_NEAR(exploration.estimation().readings()[0].height, truth, 0.12);
    const auto& reading = exploration.estimation().readings()[0];
    ASSERT_EQ(exploration.estimation().ledger().entries().size(), 1U);
    EXPECT_NEAR(exploration.estimation().ledger().entries()[0].z,
                (reading.height - shown.mean[10]) / std::hypot(shown.sd[10], reading.sd), 1e-9)
        << "the band of the side that was touched";
    EXPECT_NE(eventText().find("arm right at 0.7 m"), std::string::npos) << eventText();
}

}  // namespace
}  // namespace terratact
