// Round trip of the messages between console and robot through the frames of
// resources/dbc/terratact.dbc.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "core/terrain/bins.h"
#include "core/wire/can_codec.h"
#include "tests/support/bytes/dbc_frames.h"

namespace terratact {
namespace {

struct SentCommand {
    Command command;
    std::string name;
    std::vector<std::pair<std::string, double>> signals;
};

const std::vector<SentCommand>& commands()
{
    static const std::vector<SentCommand> all{
        {StopCommand{}, "Stop", {}},
        {ReleaseStopCommand{}, "ReleaseStop", {}},
        {ArmCommand{true}, "Arm", {{"Armed", 1.0}}},
        {ArmCommand{false}, "Arm", {{"Armed", 0.0}}},
        {HaltCommand{}, "Halt", {}},
        {DriveCommand{-0.25}, "Drive", {{"Speed", -0.25}}},
        {BeginAtemCommand{}, "BeginAtem", {}},
        {AbortAtemCommand{}, "AbortAtem", {}},
        {PressCommand{18.05}, "PressFlippers", {{"Torque", 18.05}}},
        {HoldFlippersCommand{0.7, -0.1}, "HoldFlippers", {{"Front", 0.7}, {"Rear", -0.1}}},
        {ProbeCommand{9}, "ProbeBin", {{"Bin", 9.0}, {"Side", 0.0}}},
        {ProbeCommand{9, ProbeSide::Right}, "ProbeBin", {{"Bin", 9.0}, {"Side", 2.0}}},
        {AdvanceCommand{0.1}, "Advance", {{"Distance", 0.1}}},
    };
    return all;
}

TEST(Commands, travelInTheirFramesWithEpochAndChallenge)
{
    std::set<std::size_t> kinds;
    for (const SentCommand& sent : commands()) {
        const CanFrame frame = frameOf(sent.command, 213, 42, 0xABCD);
        const DbcMessage& m = message(sent.name);
        EXPECT_EQ(frame.id, m.id) << sent.name;
        EXPECT_EQ(message(kindOf(sent.command)).name, sent.name);
        for (const auto& [name, value] : sent.signals)
            EXPECT_NEAR(physical(frame, m.signal(name)), value, 1e-9) << sent.name << "." << name;
        const Unpacked content = contentOf(frame);
        EXPECT_EQ(content.counter, 42);
        const auto got = commandOf(content);
        ASSERT_TRUE(got) << sent.name;
        EXPECT_EQ(got->command.index(), sent.command.index()) << sent.name;
        const bool hasEpoch = sent.name != "Stop" && sent.name != "HoldFlippers";
        EXPECT_EQ(got->epoch, hasEpoch ? std::optional<std::uint8_t>(213) : std::nullopt)
            << sent.name;
        const bool fresh = safety(sent.command) == 0 || sent.name == "Arm";
        EXPECT_EQ(got->challenge, fresh ? std::optional<std::uint16_t>(0xABCD) : std::nullopt)
            << sent.name;
        EXPECT_EQ(frameOf(got->command, 213, 42, 0xABCD), frame) << sent.name << " changed";
        kinds.insert(sent.command.index());
    }
    EXPECT_EQ(kinds.size(), std::variant_size_v<Command>) << "a command is missing here";
}

TEST(Commands, areRefusedBeyondTheirRange)
{
    for (const Command& command :
         {Command{DriveCommand{0.61}}, Command{DriveCommand{std::nan("")}},
          Command{PressCommand{0.0}}, Command{PressCommand{60.1}}, Command{ProbeCommand{-1}},
          Command{ProbeCommand{11}}, Command{ProbeCommand{9, static_cast<ProbeSide>(3)}},
          Command{AdvanceCommand{0.0}}, Command{AdvanceCommand{0.101}},
          Command{HoldFlippersCommand{3.2, 0.0}}, Command{HoldFlippersCommand{0.0, -3.2}}})
        EXPECT_THROW(static_cast<void>(frameOf(command, 1, 0)), std::invalid_argument)
            << command.index();
}

TEST(Heartbeats, carryTheirToken)
{
    const CanFrame asked = consoleHeartbeat(0xBEEF, 3);
    const CanFrame answered = robotHeartbeat(0xBEEF, 5, 0xCAFE);
    EXPECT_EQ(asked.id, message("ConsoleHeartbeat").id);
    EXPECT_EQ(answered.id, message("RobotHeartbeat").id);
    EXPECT_EQ(physical(asked, message("ConsoleHeartbeat").signal("Token")), 0xBEEF);
    EXPECT_EQ(tokenOf(contentOf(asked)), 0xBEEF);
    EXPECT_EQ(tokenOf(contentOf(answered)), 0xBEEF);
    EXPECT_EQ(physical(answered, message("RobotHeartbeat").signal("Challenge")), 0xCAFE);
    EXPECT_EQ(challengeOf(contentOf(answered)), 0xCAFE);
    EXPECT_FALSE(challengeOf(contentOf(asked)));
    EXPECT_FALSE(tokenOf(contentOf(frameOf(HaltCommand{}, 1, 1))));
    EXPECT_FALSE(commandOf(contentOf(asked)));
}

TEST(Status, travelsInItsFrame)
{
    const RobotStatus sent{.epoch = 250,
                           .activity = RobotActivity::Probing,
                           .refusal = Refusal::OutOfLimits,
                           .armed = true,
                           .exploring = true,
                           .lastCommand = FrameKind::ProbeBin,
                           .lastCounter = 99};
    const CanFrame frame = frameOf(sent, 7);
    const DbcMessage& m = message("RobotStatus");
    EXPECT_EQ(physical(frame, m.signal("Epoch")), 250.0);
    EXPECT_EQ(physical(frame, m.signal("Activity")), 4.0);
    EXPECT_EQ(physical(frame, m.signal("Refusal")), 8.0);
    EXPECT_EQ(physical(frame, m.signal("Armed")), 1.0);
    EXPECT_EQ(physical(frame, m.signal("Exploring")), 1.0);
    EXPECT_EQ(physical(frame, m.signal("LastCommand")), message("ProbeBin").id);
    EXPECT_EQ(physical(frame, m.signal("LastCounter")), 99.0);
    EXPECT_EQ(statusOf(contentOf(frame)), sent);
    for (const bool armed : {false, true})
        for (const bool exploring : {false, true}) {
            const RobotStatus status{.armed = armed, .exploring = exploring};
            EXPECT_EQ(statusOf(contentOf(frameOf(status, 0))), status);
        }
}

TEST(Status, isEmptyForOtherFramesAndEpochZero)
{
    EXPECT_FALSE(statusOf(contentOf(frameOf(HaltCommand{}, 1, 1))));
    EXPECT_THROW(static_cast<void>(frameOf(RobotStatus{.epoch = 0}, 0)), std::invalid_argument);
    CanFrame frame = frameOf(RobotStatus{}, 0);
    setBits(frame, message("RobotStatus").signal("LastCommand"), 5);
    seal(frame, message("RobotStatus"), 0);
    EXPECT_FALSE(statusOf(contentOf(frame)));
}

SensorLine fullLine()
{
    SensorLine line;
    line.odometry = SensorLine::Odometry{-12.345, 0.5};
    line.attitude = SensorLine::Attitude{0.2, -0.1};
    line.frontAngles = Pair{0.3, 0.31};
    line.rearAngles = Pair{-0.4, -0.41};
    line.frontCurrents = {1.5, 1.501};
    line.rearCurrents = {-2.5, 2.501};
    for (std::size_t set = 0; set < 4; ++set) {
        const double v = 0.625 * static_cast<double>(set + 1);
        line.voltages[set] = SensorLine::Three{v, v + 0.0625, v + 0.125};
    }
    line.arm = ArmReading{8, -0.1234, 0.0305, ProbeSide::Left};
    return line;
}

std::optional<SensorLine> read(SensorLineReader& reader, const SensorLine& line,
                               std::uint8_t counter)
{
    std::optional<SensorLine> got;
    for (const CanFrame& frame : framesOf(line, counter)) {
        EXPECT_FALSE(got) << "before the last frame";
        got = reader.add(contentOf(frame));
    }
    return got;
}

TEST(SensorLine, putsEveryNumberIntoItsSignal)
{
    const auto frames = framesOf(fullLine(), 9);
    const auto at = [&](const std::string& name, const std::string& signal) {
        for (const CanFrame& frame : frames)
            if (frame.id == message(name).id) return physical(frame, message(name).signal(signal));
        ADD_FAILURE() << "no " << name;
        return 0.0;
    };
    EXPECT_NEAR(at("Odometry", "Travelled"), -12.345, 1e-9);
    EXPECT_NEAR(at("Odometry", "Turned"), 0.5, 1e-9);
    EXPECT_NEAR(at("Attitude", "Pitch"), 0.2, 1e-9);
    EXPECT_NEAR(at("Attitude", "Roll"), -0.1, 1e-9);
    EXPECT_NEAR(at("FrontAngles", "Left"), 0.3, 1e-9);
    EXPECT_NEAR(at("FrontAngles", "Right"), 0.31, 1e-9);
    EXPECT_NEAR(at("RearAngles", "Left"), -0.4, 1e-9);
    EXPECT_NEAR(at("RearAngles", "Right"), -0.41, 1e-9);
    EXPECT_NEAR(at("FrontCurrents", "Left"), 1.5, 1e-9);
    EXPECT_NEAR(at("FrontCurrents", "Right"), 1.501, 1e-9);
    EXPECT_NEAR(at("RearCurrents", "Left"), -2.5, 1e-9);
    EXPECT_NEAR(at("RearCurrents", "Right"), 2.501, 1e-9);
    EXPECT_NEAR(at("LeftForces1To3", "Element1"), 0.625, 1e-9);
    EXPECT_NEAR(at("LeftForces1To3", "Element3"), 0.75, 1e-9);
    EXPECT_NEAR(at("LeftForces4To6", "Element5"), 1.3125, 1e-9);
    EXPECT_NEAR(at("RightForces1To3", "Element2"), 1.9375, 1e-9);
    EXPECT_NEAR(at("RightForces4To6", "Element6"), 2.625, 1e-9);
    EXPECT_NEAR(at("ArmResult", "Bin"), 8.0, 1e-9);
    EXPECT_NEAR(at("ArmResult", "Height"), -0.1234, 1e-9);
    EXPECT_NEAR(at("ArmResult", "Sd"), 0.0305, 1e-9);
    EXPECT_EQ(at("ArmResult", "Side"), 1.0);
    for (const CanFrame& frame : frames) EXPECT_EQ(frame.data[2], 9) << "one counter for all";
}

TEST(SensorLine, comesBackWholeOverEveryTurnOfTheCounter)
{
    SensorLineReader reader;
    for (int counter = 0; counter < 600; ++counter) {
        const auto got = read(reader, fullLine(), static_cast<std::uint8_t>(counter));
        ASSERT_TRUE(got);
        ASSERT_NEAR(got->frontAngles->right, 0.31, 1e-9);
        ASSERT_NEAR((*got->voltages[3])[2], 2.625, 1e-9);
        ASSERT_EQ(got->arm->bin, 8);
        ASSERT_EQ(got->arm->side, ProbeSide::Left);
        ASSERT_NEAR(got->odometry->travelled, -12.345, 1e-9);
    }
    EXPECT_EQ(reader.unfinished(), 0U);
}

TEST(SensorLine, marksWhatWasNotMeasured)
{
    SensorLineReader reader;
    ASSERT_TRUE(read(reader, fullLine(), 1));
    EXPECT_EQ(read(reader, SensorLine{}, 2), SensorLine{}) << "nothing of the line before";
}

TEST(SensorLine, keepsTheCurrentOfOneMotor)
{
    SensorLine line = fullLine();
    line.frontCurrents.left.reset();
    line.rearCurrents.right.reset();
    const CanFrame front = framesOf(line, 1)[4];
    const DbcMessage& m = message("FrontCurrents");
    ASSERT_EQ(front.id, m.id);
    EXPECT_EQ(physical(front, m.signal("Left")), 0.0);
    EXPECT_EQ(physical(front, m.signal("Measured")), 1.0);
    EXPECT_EQ(physical(front, m.signal("LeftMissing")), 1.0);
    EXPECT_EQ(physical(front, m.signal("RightMissing")), 0.0);
    SensorLineReader reader;
    const auto got = read(reader, line, 1);
    ASSERT_TRUE(got);
    EXPECT_FALSE(got->frontCurrents.left);
    EXPECT_NEAR(got->frontCurrents.right.value(), 1.501, 1e-9);
    EXPECT_NEAR(got->rearCurrents.left.value(), -2.5, 1e-9);
    EXPECT_FALSE(got->rearCurrents.right);
}

TEST(SensorLine, anAxleWithoutCurrentsHasNoOtherBit)
{
    SensorLine line = fullLine();
    line.frontCurrents = {};
    EXPECT_EQ(framesOf(line, 1)[4], pack({.kind = FrameKind::FrontCurrents, .counter = 1}));
}

TEST(MeasuredSignals, lackACurrentWhoseBitIsSet)
{
    const auto of = [](double measured, double left, double right) {
        return measuredSignals(
                   {.kind = FrameKind::RearCurrents, .values = {1.0, 1.0, measured, left, right}})
            .to_string();  // RightMissing, LeftMissing, Measured, Right, Left
    };
    EXPECT_EQ(of(1.0, 0.0, 0.0), "0011111");
    EXPECT_EQ(of(1.0, 1.0, 0.0), "0011110");
    EXPECT_EQ(of(1.0, 0.0, 1.0), "0011101");
    EXPECT_EQ(of(1.0, 1.0, 1.0), "0011100") << "as not measured";
    EXPECT_EQ(of(0.0, 0.0, 0.0), "0000100");
    EXPECT_EQ(of(0.0, 1.0, 0.0), "0000100");
    EXPECT_EQ(measuredSignals({.kind = FrameKind::Drive}).count(), 3U) << "no Measured: all";
}

TEST(Currents, ofAnOlderFrameReadAsBefore)
{
    CanFrame frame{.id = 0x025, .length = 8};  // of docs/can_demo.log, which version 3 wrote
    frame.data = {0x9A, 0x31, 0x00, 0x40, 0x06, 0xA4, 0x06, 0x01};
    const Unpacked content = contentOf(frame);
    EXPECT_NEAR(content.values[0], 1.6, 1e-9);
    EXPECT_NEAR(content.values[1], 1.7, 1e-9);
    EXPECT_EQ(measuredSignals(content).to_string(), "0011111");
    EXPECT_EQ(pack(content), frame) << "byte for byte";
}

TEST(SensorLine, isNeverMadeOfTwoLines)
{
    SensorLineReader reader;
    const auto first = framesOf(fullLine(), 1), second = framesOf(SensorLine{}, 2);
    for (std::size_t i = 0; i + 1 < first.size(); ++i)
        EXPECT_FALSE(reader.add(contentOf(first[i])));
    EXPECT_FALSE(reader.add(contentOf(second.back()))) << "the one missing, of another line";
    EXPECT_EQ(reader.unfinished(), 1U);
    for (std::size_t i = 0; i + 2 < second.size(); ++i)
        EXPECT_FALSE(reader.add(contentOf(second[i])));
    EXPECT_FALSE(reader.add(contentOf(frameOf(RobotStatus{}, 2)))) << "no sensor frame";
    EXPECT_TRUE(reader.add(contentOf(second[second.size() - 2])));
}

TEST(SensorLine, needsNoOdometryAndTakesNoOtherLines)
{
    SensorLineReader reader;
    const auto first = framesOf(fullLine(), 1), second = framesOf(fullLine(), 2);
    std::optional<SensorLine> got;
    for (std::size_t i = 1; i < first.size(); ++i) got = reader.add(contentOf(first[i]));
    ASSERT_TRUE(got) << "a robot without odometry";
    EXPECT_FALSE(got->odometry);
    EXPECT_FALSE(reader.add(contentOf(first.front()))) << "too late for its line";
    for (std::size_t i = 1; i < second.size(); ++i) got = reader.add(contentOf(second[i]));
    ASSERT_TRUE(got);
    EXPECT_FALSE(got->odometry) << "of the line before";
    EXPECT_EQ(reader.unfinished(), 0U);
}

/// The same of a robot with rear arrays and a free differential.
SensorLine longLine()
{
    SensorLine line = fullLine();
    for (std::size_t set = 4; set < 8; ++set) {
        const double v = 0.4 * static_cast<double>(set);
        line.voltages[set] = SensorLine::Three{v, v + 0.0625, v + 0.125};
    }
    line.differential = -0.25;
    return line;
}

constexpr LineExtent kLong{.rearForces = true, .differential = true};

TEST(SensorLine, hasTheFramesThatTheRobotSends)
{
    EXPECT_EQ(framesOf(longLine(), 1).size(), 11U);
    EXPECT_EQ(framesOf(longLine(), 1, {.rearForces = true}).size(), 15U);
    EXPECT_EQ(framesOf(longLine(), 1, {.differential = true}).size(), 12U);
    const auto frames = framesOf(longLine(), 9, kLong);
    ASSERT_EQ(frames.size(), 16U);
    const auto at = [&](std::size_t i, const std::string& name, const std::string& signal) {
        EXPECT_EQ(frames[i].id, message(name).id) << name;
        return physical(frames[i], message(name).signal(signal));
    };
    EXPECT_NEAR(at(11, "RearLeftForces1To3", "Element1"), 1.6, 1e-9);
    EXPECT_NEAR(at(12, "RearLeftForces4To6", "Element5"), 2.0625, 1e-9);
    EXPECT_NEAR(at(13, "RearRightForces1To3", "Element3"), 2.525, 1e-9);
    EXPECT_NEAR(at(14, "RearRightForces4To6", "Element6"), 2.925, 1e-9);
    EXPECT_NEAR(at(15, "Differential", "Angle"), -0.25, 1e-9);
}

TEST(SensorLine, needsEveryFrameOfItsExtent)
{
    const auto frames = framesOf(longLine(), 1, kLong);
    SensorLineReader reader(kLong);
    for (std::size_t i = 0; i + 1 < frames.size(); ++i)
        EXPECT_FALSE(reader.add(contentOf(frames[i]))) << i;
    const auto got = reader.add(contentOf(frames.back()));
    ASSERT_TRUE(got);
    EXPECT_NEAR((*got->voltages[7])[2], 2.925, 1e-9);
    EXPECT_NEAR(*got->differential, -0.25, 1e-9);
    EXPECT_FALSE(read(reader, longLine(), 2)) << "the robot does not send what its file promises";
    SensorLineReader shorter;
    const auto sides = framesOf(longLine(), 3, kLong);
    std::optional<SensorLine> line;
    for (const CanFrame& frame : sides)
        if (auto whole = shorter.add(contentOf(frame))) line = whole;
    ASSERT_TRUE(line) << "a file without these arrays ignores their frames";
    EXPECT_FALSE(line->voltages[4] || line->differential);
    EXPECT_EQ(shorter.unfinished(), 0U);
}

TEST(ArmResult, isNeverWithoutAnSd)
{
    SensorLine line;
    line.arm = ArmReading{3, 0.1, 0.0};
    EXPECT_THROW(static_cast<void>(framesOf(line, 0)), std::invalid_argument);
    CanFrame frame = blank(message("ArmResult"));
    setBits(frame, message("ArmResult").signal("Sd"), 0);
    setBits(frame, message("ArmResult").signal("Measured"), 1);
    seal(frame, message("ArmResult"), 0);
    EXPECT_EQ(faultOf(frame), FrameFault::OutOfRange);
}

}  // namespace
}  // namespace terratact
