// Tests what a record of the way keeps of felt ground and of readings of the arm.
#include "tests/core/trail/trail_record_fixture.h"

namespace terratact {
namespace {

TEST_F(TrailRecordTest, PressedGroundIsFeltEarlier)
{
    drive(0.6);
    record.addScene(pressFlat());
    const TrailHistory none = record.before(line);
    EXPECT_TRUE(feelsNothing(none.ground[0])) << "a scene is no memory of itself";
    drive(0.15, 0.01);
    // Pressed from 0.24 to 0.56 m, 0.15 m ago. Slip takes 0.015 m from both ends: 0.105 … 0.395 m.
    const TrailHistory history = record.before(line);
    for (const TrailGround& ground : history.ground) {
        EXPECT_EQ(ground.felt[4], 0b1111000000);
        EXPECT_EQ(ground.felt[5], kAllCells);
        EXPECT_EQ(ground.felt[6], kAllCells);
        EXPECT_EQ(ground.felt[7], 0b0000001111);
        EXPECT_EQ(ground.felt[8], 0);
    }
}

TEST_F(TrailRecordTest, OneSidesPressIsFeltThereAlone)
{
    drive(0.6);
    Measurement scene = pressFlat();
    SideForces sides = scene.sides;
    sides.right.fill(0.0);
    setSides(scene, sides);
    record.addScene(scene);
    drive(0.15, 0.01);
    const TrailHistory history = record.before(line);
    EXPECT_EQ(history.ground[1].felt[6], kAllCells);
    EXPECT_EQ(history.ground[2].felt[6], 0);
    EXPECT_EQ(history.ground[0].felt[6], 0) << "one plane is felt where both sides were";
}

TEST_F(TrailRecordTest, ReversingRemembersNoBinOfUnknownHeight)
{
    drive(0.6);
    record.addScene(pressFlat());
    drive(-0.25, 0.01);  // what was pressed lies at 0.5 … 0.8 m now
    const TrailHistory history = record.before(line);
    EXPECT_EQ(history.ground[1].felt[9], 0);
    EXPECT_EQ(history.ground[1].felt[10], 0);
    EXPECT_EQ(history.ground[1].felt[8], 0) << "the networks do not get its height";
}

TEST_F(TrailRecordTest, TurningMovesFeltGroundOutOfTheWay)
{
    drive(0.6);
    record.addScene(pressFlat());
    *line.turned += 0.02;
    drive(0.1, 0.01);
    const TrailHistory ahead = record.before(line);
    EXPECT_FALSE(feelsNothing(ahead.ground[1]));
    *line.turned += 0.05;
    drive(0.1, 0.01);
    const TrailHistory aside = record.before(line);
    EXPECT_GT(aside.presses, 0) << "the way is known still";
    for (const TrailGround& ground : aside.ground) EXPECT_TRUE(feelsNothing(ground));
}

TEST_F(TrailRecordTest, WithoutAHeadingNothingFeltIsKept)
{
    line.turned.reset();
    drive(0.6);
    record.addScene(pressFlat());
    drive(0.1, 0.01);
    const TrailHistory history = record.before(line);
    EXPECT_GT(history.presses, 0);
    for (const TrailGround& ground : history.ground) EXPECT_TRUE(feelsNothing(ground));
}

TEST_F(TrailRecordTest, ASuspectedSensorFeltNothing)
{
    drive(0.6);
    record.addScene(pressFlat());
    record.addArm(pressFlat(), {.bin = 10, .height = -0.4, .sd = 0.01});
    record.forgetFelt();
    drive(0.1, 0.01);
    const TrailHistory history = record.before(line);
    for (const TrailGround& ground : history.ground) {
        EXPECT_TRUE(feelsNothing(ground));
        EXPECT_EQ(ground.armSd[9], 0.0);
    }
}

TEST_F(TrailRecordTest, ASuddenTiltOfTheSceneCounts)
{
    drive(0.6);
    record.addScene(pressFlat());
    drive(0.1, 0.01);
    Measurement tilted = line;
    tilted.pitch = 0.4;
    const TrailHistory history = record.before(tilted);
    for (const TrailGround& ground : history.ground) EXPECT_TRUE(feelsNothing(ground));
}

TEST_F(TrailRecordTest, ReadingsThatDifferLeaveTheLowerHeight)
{
    drive(0.6);
    record.addScene(press());
    record.addArm(press(), {.bin = 10, .height = -0.6, .sd = 0.01, .side = ProbeSide::Left});
    drive(0.04, 0.01);
    record.addScene(press());
    record.addArm(press(), {.bin = 10, .height = -0.2, .sd = 0.01, .side = ProbeSide::Left});
    drive(0.03, 0.01);
    record.addScene(press());
    record.addArm(press(), {.bin = 10, .height = -0.2, .sd = 0.01, .side = ProbeSide::Left});
    drive(0.04, 0.01);
    const TrailHistory history = record.before(line);
    const TrailGround& ground = history.ground[1];
    EXPECT_NEAR(ground.armHeight[9], -0.6, 1e-6);
    EXPECT_NEAR(ground.armSd[9], 0.4, 0.01);
    EXPECT_EQ(ground.felt[9], 0);
}

TEST_F(TrailRecordTest, ExploringAgainInPlaceKeepsTheReading)
{
    drive(0.6);
    record.addScene(press());
    record.addArm(press(), {.bin = 10, .height = -0.6, .sd = 0.01, .side = ProbeSide::Left});
    record.addScene(pressFlat());
    EXPECT_EQ(record.armHere().size(), 1U);
    drive(0.1, 0.01);
    const TrailHistory history = record.before(line);
    EXPECT_NEAR(history.ground[1].armHeight[9], -0.6, 1e-6);
    record.addScene(pressFlat());
    EXPECT_TRUE(record.armHere().empty()) << "that scene was not probed";
}

TEST_F(TrailRecordTest, SmallStepsAddUpAndDropTheReading)
{
    drive(0.6);
    record.addScene(press());
    record.addArm(press(), {.bin = 10, .height = -0.6, .sd = 0.01, .side = ProbeSide::Left});
    drive(0.012, 0.012);
    record.addScene(pressFlat());
    EXPECT_EQ(record.armHere().size(), 1U);
    drive(0.012, 0.012);
    record.addScene(pressFlat());
    EXPECT_TRUE(record.armHere().empty()) << "2.4 cm from where the arm measured";
}

TEST_F(TrailRecordTest, ExploringAgainTurnedDropsTheReading)
{
    drive(0.6);
    record.addScene(press());
    record.addArm(press(), {.bin = 10, .height = -0.6, .sd = 0.01, .side = ProbeSide::Left});
    *line.turned += 0.05;  // 4 cm sideways at the reading
    record.addScene(pressFlat());
    EXPECT_TRUE(record.armHere().empty());
    *line.turned -= 0.05;
    drive(0.1, 0.01);
    const TrailHistory history = record.before(line);
    EXPECT_EQ(history.ground[1].armSd[9], 0.0);
}

TEST_F(TrailRecordTest, AnUncertainHeightIsNotFelt)
{
    drive(0.6);
    record.addScene(pressFlat());
    drive(0.1, 0.01);
    const TrailHistory sure = record.before(line);
    EXPECT_FALSE(feelsNothing(sure.ground[0]));
    line.pitch = 0.3;  // the point that the robot turned about is not known
    drive(0.02, 0.01);
    line.pitch = 0.0;
    drive(0.02, 0.01);
    const TrailHistory unsure = record.before(line);
    EXPECT_TRUE(feelsNothing(unsure.ground[0]));
}

TEST_F(TrailRecordTest, AnArmReadingMovesWithTheGround)
{
    drive(0.6);
    const Measurement scene = press();
    record.addScene(scene);
    record.addArm(scene, {.bin = 10, .height = -0.5, .sd = 0.01, .side = ProbeSide::Left});
    record.addArm(scene, {.bin = 10, .height = -0.4, .sd = 0.01, .side = ProbeSide::Left});
    const TrailHistory none = record.before(scene);
    EXPECT_EQ(none.ground[1].armSd[10], 0.0) << "a scene is no memory of itself";
    drive(0.1, 0.01);
    const TrailHistory history = record.before(line);
    EXPECT_NEAR(history.ground[1].armHeight[9], -0.4, 1e-6) << "the later reading counts";
    EXPECT_GT(history.ground[1].armSd[9], 0.01);
    EXPECT_LT(history.ground[1].armSd[9], 0.02);
    EXPECT_EQ(history.ground[1].felt[9], 0) << "a point is no stretch: a fall may begin beside it";
    EXPECT_EQ(history.ground[1].armSd[10], 0.0);
    EXPECT_EQ(history.ground[0].armSd[9], 0.0) << "one plane takes readings in the middle";
    const TrailHistory other = record.before(line);
    EXPECT_EQ(other.ground[2].armSd[9], 0.0) << "the right side was not probed";
    drive(0.04, 0.01);
    const TrailHistory beside = record.before(line);
    const TrailGround& ground = beside.ground[1];
    EXPECT_GT(ground.armSd[9], 0.014);
}

}  // namespace
}  // namespace terratact
