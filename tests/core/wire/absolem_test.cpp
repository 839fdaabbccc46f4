#include "core/wire/absolem.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <numbers>
#include <random>
#include <stdexcept>

#include "core/wire/absolem_text.h"

namespace terratact {
namespace {

using Kind = AbsolemFrame::Kind;
using Node = AbsolemNode;
using Verdict = AbsolemVerdict;

constexpr double kPi = std::numbers::pi;

CanFrame bytes(std::uint32_t id, std::initializer_list<std::uint8_t> content)
{
    CanFrame frame{.id = id, .length = static_cast<std::uint8_t>(content.size())};
    std::copy(content.begin(), content.end(), frame.data.begin());
    return frame;
}

std::uint32_t idOf(Node node, std::uint32_t base)
{
    return base + static_cast<std::uint32_t>(node);
}

CanFrame query(Node node, const char* command, std::uint8_t index = 0)
{
    return bytes(idOf(node, 0x300), {static_cast<std::uint8_t>(command[0]),
                                     static_cast<std::uint8_t>(command[1]), index, 0x40});
}

CanFrame reply(Node node, const char* command, std::uint32_t value, std::uint8_t type = 0,
               std::uint8_t index = 0)
{
    return bytes(idOf(node, 0x280),
                 {static_cast<std::uint8_t>(command[0]), static_cast<std::uint8_t>(command[1]),
                  index, type, static_cast<std::uint8_t>(value),
                  static_cast<std::uint8_t>(value >> 8U), static_cast<std::uint8_t>(value >> 16U),
                  static_cast<std::uint8_t>(value >> 24U)});
}

struct OnAbsolemsBus : testing::Test {
    AbsolemListener listener;
    double now = 50.0;

    Verdict receive(const CanFrame& frame) { return listener.receive(frame, now).verdict; }
    Verdict ask(Node node, const char* command, std::uint32_t value, std::uint8_t type = 0,
                std::uint8_t index = 0)
    {
        EXPECT_EQ(receive(query(node, command, index)), Verdict::Passed);
        now += 0.001;
        return receive(reply(node, command, value, type, index));
    }
    Verdict askPosition(Node node, std::int32_t counts)
    {
        return ask(node, "px", static_cast<std::uint32_t>(counts));
    }
    Verdict askCurrent(Node node, float current, std::uint8_t type = 0x80)
    {
        return ask(node, "iq", std::bit_cast<std::uint32_t>(current), type);
    }
    std::uint64_t count(Verdict verdict) const
    {
        return listener.counters()[static_cast<std::size_t>(verdict)];
    }
    const AbsolemState& state() const { return listener.state(); }
};

TEST_F(OnAbsolemsBus, everyFlipperThatTheRobotRaisesIsUp)
{
    // The robot raises all flippers to 135° at start-up: front joints to -135°, rear joints to
    // +135°. The drives on the left count in the opposite direction.
    const std::int32_t counts = 2250;
    EXPECT_EQ(askPosition(Node::FrontRight, -counts), Verdict::Used);
    EXPECT_EQ(askPosition(Node::FrontLeft, counts), Verdict::Used);
    EXPECT_EQ(askPosition(Node::RearRight, counts), Verdict::Used);
    EXPECT_EQ(askPosition(Node::RearLeft, -counts), Verdict::Used);
    for (const auto& flipper :
         {state().frontLeft, state().frontRight, state().rearLeft, state().rearRight}) {
        ASSERT_TRUE(flipper.angle);
        EXPECT_NEAR(flipper.angle->value, 0.75 * kPi, 1e-12);
    }
    EXPECT_EQ(state().rearLeft.angle->time, now);
}

TEST_F(OnAbsolemsBus, anAngleIsCountsOver6000WithinHalfATurn)
{
    askPosition(Node::RearRight, 1);
    EXPECT_NEAR(state().rearRight.angle->value, 2.0 * kPi / 6000.0, 1e-15);
    askPosition(Node::RearRight, 6000 + 1500);
    EXPECT_NEAR(state().rearRight.angle->value, 0.5 * kPi, 1e-12);
    askPosition(Node::RearRight, -6000 * 3 - 1);
    EXPECT_NEAR(state().rearRight.angle->value, -2.0 * kPi / 6000.0, 1e-12);
    EXPECT_EQ(askPosition(Node::RearRight, 1'000'000), Verdict::Used);
    EXPECT_EQ(askPosition(Node::RearRight, 1'000'001), Verdict::OutOfRange);
    EXPECT_EQ(askPosition(Node::RearRight, std::numeric_limits<std::int32_t>::min()),
              Verdict::OutOfRange);
}

TEST_F(OnAbsolemsBus, aCurrentThatTurnsAFlipperDownIsPositive)
{
    // Positive current turns towards positive counts, which is up for the first two drives.
    EXPECT_EQ(askCurrent(Node::FrontLeft, 1.5F), Verdict::Used);
    EXPECT_EQ(askCurrent(Node::RearRight, 1.5F), Verdict::Used);
    EXPECT_EQ(askCurrent(Node::FrontRight, 1.5F), Verdict::Used);
    EXPECT_EQ(askCurrent(Node::RearLeft, 1.5F), Verdict::Used);
    EXPECT_EQ(state().frontLeft.current->value, -1.5);
    EXPECT_EQ(state().rearRight.current->value, -1.5);
    EXPECT_EQ(state().frontRight.current->value, 1.5);
    EXPECT_EQ(state().rearLeft.current->value, 1.5);
    EXPECT_EQ(askCurrent(Node::RearLeft, 2.5F, 0), Verdict::Used)
        << "a float, whatever its type bit says: the robot does the same";
    EXPECT_EQ(state().rearLeft.current->value, 2.5);
}

TEST_F(OnAbsolemsBus, currentsThatCannotBeAreNotUsed)
{
    const float infinity = std::numeric_limits<float>::infinity();
    for (const float current : {std::nanf(""), infinity, -infinity, 50.5F, -1e30F})
        EXPECT_EQ(askCurrent(Node::FrontLeft, current), Verdict::OutOfRange) << current;
    EXPECT_FALSE(state().frontLeft.current);
    EXPECT_EQ(count(Verdict::OutOfRange), 5U);
}

TEST_F(OnAbsolemsBus, tracksHaveNoFlipperAngleButADrive)
{
    const AbsolemState before = state();
    EXPECT_EQ(askPosition(Node::TrackLeft, 100), Verdict::Passed);
    EXPECT_EQ(askCurrent(Node::Core, 1.0F), Verdict::Passed);
    EXPECT_EQ(state(), before);
    EXPECT_EQ(ask(Node::TrackLeft, "sr", 0x10), Verdict::Used);
    EXPECT_EQ(ask(Node::TrackLeft, "mf", 0x8), Verdict::Used);
    EXPECT_EQ(state().drives[5].statusRegister->value, 0x10U);
    EXPECT_EQ(state().drives[5].motorFault->value, 0x8U);
    EXPECT_FALSE(state().emergencyStop);
    EXPECT_EQ(ask(Node::TrackLeft, "ib", 1, 0, 16), Verdict::Used);
    EXPECT_TRUE(state().emergencyStop->value);
    EXPECT_EQ(ask(Node::TrackLeft, "ib", 0, 0, 16), Verdict::Used);
    EXPECT_FALSE(state().emergencyStop->value);
}

TEST_F(OnAbsolemsBus, statusWordsComeUnasked)
{
    EXPECT_EQ(receive(bytes(0x184, {0x37, 0x02})), Verdict::Used);
    EXPECT_EQ(state().drives[3].statusWord->value, 0x0237);
    EXPECT_EQ(receive(bytes(0x184, {0x37})), Verdict::WrongLength);
    EXPECT_EQ(receive(bytes(0x000, {0x01, 0x00, 0x00, 0x00})), Verdict::Passed);
    EXPECT_EQ(receive(bytes(0x000, {})), Verdict::WrongLength);
}

TEST_F(OnAbsolemsBus, aReplyNeedsTheHeaderOfItsRequest)
{
    EXPECT_EQ(receive(reply(Node::RearRight, "px", 7)), Verdict::NotAsked);
    receive(query(Node::RearRight, "px"));
    EXPECT_EQ(receive(reply(Node::RearRight, "iq", 7)), Verdict::NotAsked) << "another command";
    EXPECT_EQ(receive(reply(Node::RearRight, "px", 7, 0, 1)), Verdict::NotAsked) << "another index";
    EXPECT_EQ(receive(reply(Node::RearRight, "px", 7, 1)), Verdict::NotAsked) << "index 256";
    EXPECT_EQ(receive(reply(Node::RearLeft, "px", 7)), Verdict::NotAsked) << "another node";
    EXPECT_FALSE(state().rearRight.angle);
    EXPECT_EQ(receive(reply(Node::RearRight, "px", 7)), Verdict::Used);
    EXPECT_EQ(receive(reply(Node::RearRight, "px", 8)), Verdict::NotAsked) << "a second answer";
    receive(query(Node::RearRight, "px"));
    now += 0.11;
    EXPECT_EQ(receive(reply(Node::RearRight, "px", 7)), Verdict::NotAsked) << "too late";
    receive(query(Node::RearRight, "px"));
    now -= 1.0;
    EXPECT_EQ(receive(reply(Node::RearRight, "px", 7)), Verdict::NotAsked) << "before it was asked";
}

TEST_F(OnAbsolemsBus, capitalsAnswerLowerCaseAndSettingAnswersToo)
{
    receive(query(Node::RearRight, "px"));
    EXPECT_EQ(receive(reply(Node::RearRight, "PX", 7)), Verdict::Used);
    const CanFrame set = bytes(0x302, {'p', 'x', 0, 0, 0xDC, 0x05, 0, 0});
    EXPECT_EQ(receive(set), Verdict::Passed);
    EXPECT_EQ(receive(reply(Node::RearRight, "PX", 1500)), Verdict::Used);
    EXPECT_NEAR(state().rearRight.angle->value, 0.5 * kPi, 1e-12);
}

TEST_F(OnAbsolemsBus, aRefusalIsNoValue)
{
    // The manual's example: BG with its motor off is answered by error 58.
    EXPECT_EQ(ask(Node::RearRight, "bg", 0x3A, 0x40), Verdict::Refused);
    EXPECT_EQ(ask(Node::RearRight, "px", 0x3A, 0x40), Verdict::Refused);
    EXPECT_FALSE(state().rearRight.angle);
}

TEST_F(OnAbsolemsBus, echoedTypeBitIsNoRefusal)
{
    EXPECT_EQ(ask(Node::RearRight, "px", 1500, 0x40), Verdict::Used)
        << "no error code is as large as that";
    EXPECT_EQ(ask(Node::RearRight, "px", 200, 0x40), Verdict::Used) << "and now it is known";
    EXPECT_EQ(ask(Node::RearLeft, "px", 200, 0x40), Verdict::Refused) << "of that drive only";
}

TEST_F(OnAbsolemsBus, anIntegerMayNotComeAsAFloat)
{
    EXPECT_EQ(ask(Node::RearRight, "px", 0x3F80'0000, 0x80), Verdict::WrongType);
    EXPECT_EQ(ask(Node::RearRight, "sr", 0x3F80'0000, 0x80), Verdict::WrongType);
    EXPECT_FALSE(state().rearRight.angle);
}

TEST_F(OnAbsolemsBus, unknownCommandsAndFramesAreCounted)
{
    EXPECT_EQ(ask(Node::RearRight, "zz", 1), Verdict::UnknownCommand);
    EXPECT_EQ(ask(Node::RearRight, "um", 5), Verdict::Passed);
    EXPECT_EQ(ask(Node::RearRight, "px", 1, 0, 3), Verdict::UnknownCommand) << "there is no PX[3]";
    EXPECT_EQ(receive(bytes(0x308, {'p', 'x', 0, 0x40})), Verdict::UnknownId) << "no eighth node";
    EXPECT_EQ(receive(bytes(0x280, {'p', 'x', 0, 0x40})), Verdict::UnknownId) << "nor a node 0";
    EXPECT_EQ(receive(bytes(0x705, {0x05})), Verdict::UnknownId);
    EXPECT_EQ(receive(bytes(0x302, {'p', 'x', 0})), Verdict::WrongLength);
    EXPECT_EQ(receive(bytes(0x302, {'p', 'x', 0, 0, 1})), Verdict::WrongLength);
    EXPECT_EQ(receive(bytes(0x282, {'p', 'x', 0, 0})), Verdict::WrongLength)
        << "a reply has a value";
    EXPECT_EQ(receive(bytes(0x302, {'p', '1', 0, 0x40})), Verdict::NotACommand);
    EXPECT_EQ(receive(bytes(0x302, {0, 0, 0, 0x40})), Verdict::NotACommand);
    for (const int kind : {0, 1, 2, 3}) {
        CanFrame frame = query(Node::RearRight, "px");
        frame.extended = kind == 0;
        frame.remote = kind == 1;
        frame.error = kind == 2;
        frame.fd = kind == 3;
        EXPECT_EQ(receive(frame), Verdict::NotClassicData);
    }
    EXPECT_EQ(count(Verdict::UnknownId), 3U);
    EXPECT_EQ(count(Verdict::WrongLength), 3U);
    EXPECT_EQ(count(Verdict::NotClassicData), 4U);
    EXPECT_THROW(listener.receive(CanFrame{}, std::nan("")), std::invalid_argument);
}

TEST_F(OnAbsolemsBus, aLineOfSensorsHoldsWhatIsFreshOnBothSides)
{
    askPosition(Node::FrontLeft, 600);
    askPosition(Node::FrontRight, -600);
    askCurrent(Node::FrontLeft, -2.0F);
    askCurrent(Node::FrontRight, 1.0F);
    askPosition(Node::RearLeft, 0);
    SensorLine line = sensorLineOf(state(), now, 0.25);
    ASSERT_TRUE(line.frontAngles);
    EXPECT_NEAR(line.frontAngles->left, 0.2 * kPi, 1e-12);
    EXPECT_NEAR(line.frontAngles->right, 0.2 * kPi, 1e-12);
    EXPECT_EQ(line.frontCurrents, (AxleCurrents{2.0, 1.0}));
    EXPECT_FALSE(line.rearAngles) << "of the right one nothing is known";
    EXPECT_EQ(line.rearCurrents, AxleCurrents{});
    EXPECT_FALSE(line.attitude || line.voltages[0] || line.arm) << "nothing of it is on this bus";
    EXPECT_FALSE(sensorLineOf(state(), now + 0.3, 0.25).frontAngles);
    now += 0.3;
    askPosition(Node::FrontRight, -600);
    EXPECT_FALSE(sensorLineOf(state(), now, 0.25).frontAngles) << "the left one is old";
    askPosition(Node::FrontLeft, 600);
    EXPECT_TRUE(sensorLineOf(state(), now, 0.25).frontAngles);
    EXPECT_EQ(sensorLineOf(state(), now, 0.25).frontCurrents, AxleCurrents{});
    askCurrent(Node::FrontLeft, -2.0F);
    EXPECT_EQ(sensorLineOf(state(), now, 0.25).frontCurrents, (AxleCurrents{.left = 2.0}));
}

TEST(AbsolemFrames, areDecodedAsInTheManual)
{
    // Examples of MAN-CAN301IG, chapter 9: AC=150000, the query of ET[992] and its reply,
    // CL[1]=1.0.
    const auto frame = [](const CanFrame& f) { return std::get<AbsolemFrame>(absolemFrame(f)); };
    const AbsolemFrame set = frame(bytes(0x302, {0x41, 0x43, 0, 0, 0xF0, 0x49, 0x02, 0}));
    EXPECT_EQ(set.kind, Kind::Set);
    EXPECT_EQ(set.name(), "AC");
    EXPECT_EQ(set.asInt(), 150'000);
    const AbsolemFrame asked = frame(bytes(0x302, {0x45, 0x54, 0xE0, 0x43, 0, 0, 0, 0}));
    EXPECT_EQ(asked.kind, Kind::Query);
    EXPECT_EQ(asked.name(), "ET[992]");
    const AbsolemFrame answer = frame(bytes(0x282, {0x45, 0x54, 0xE0, 0x03, 0x79, 0x7D, 0, 0}));
    EXPECT_EQ(answer.kind, Kind::Reply);
    EXPECT_EQ(answer.name(), "ET[992]");
    EXPECT_EQ(answer.asInt(), 32'121);
    const AbsolemFrame real = frame(bytes(0x307, {0x43, 0x4C, 1, 0x80, 0, 0, 0x80, 0x3F}));
    EXPECT_EQ(real.kind, Kind::Set);
    EXPECT_TRUE(real.isFloat);
    EXPECT_EQ(real.asFloat(), 1.0F);
    EXPECT_EQ(real.node, Node::FrontLeft);
}

TEST(AbsolemFrames, anyBytesAreCountedAndGivePossibleValues)
{
    std::mt19937 random(7);
    AbsolemListener listener;
    constexpr std::string_view kLetters = "pxiqsrmfPXIQibzz";
    std::uint64_t taken = 0;
    std::uint32_t node = 0;
    std::size_t command = 0;
    for (int i = 0; i < 100'000; ++i) {
        const bool isReply = i % 2 == 1;
        if (!isReply || random() % 8 == 0) {
            node = static_cast<std::uint32_t>(random() % 9);
            command = 2 * (random() % (kLetters.size() / 2));
        }
        const auto value = static_cast<std::uint32_t>(random());
        const std::uint32_t small = random() % 2 == 0 ? value >> 14U : 0x4000'0000U | value >> 8U;
        CanFrame frame = bytes((isReply ? 0x280U : 0x300U) + node,
                               {static_cast<std::uint8_t>(kLetters[command]),
                                static_cast<std::uint8_t>(kLetters[command + 1]), 0, 0});
        frame.length = isReply ? 8 : 4;
        if (!isReply) frame.data[3] = 0x40;
        for (std::size_t byte = 0; isReply && byte < 4; ++byte)
            frame.data[4 + byte] = static_cast<std::uint8_t>((random() % 4 == 0 ? value : small)
                                                             >> (8U * static_cast<unsigned>(byte)));
        if (random() % 4 == 0) frame.data[random() % 8] = static_cast<std::uint8_t>(random());
        if (random() % 8 == 0) frame.length = static_cast<std::uint8_t>(random() % 9);
        listener.receive(frame, 0.0001 * i);
        ++taken;
    }
    std::uint64_t counted = 0;
    for (const std::uint64_t n : listener.counters()) counted += n;
    EXPECT_EQ(counted, taken);
    EXPECT_GT(listener.counters()[static_cast<std::size_t>(Verdict::Used)], 100U);
    for (const auto& flipper : {listener.state().frontLeft, listener.state().rearRight}) {
        ASSERT_TRUE(flipper.angle && flipper.current);
        EXPECT_LE(std::abs(flipper.angle->value), kPi);
        EXPECT_LE(std::abs(flipper.current->value), 50.0);
    }
}

TEST(AbsolemWords, nameBitsAndShowTheRest)
{
    using Phrases = std::vector<std::string>;
    EXPECT_EQ(statusWordPhrases(0x0027),
              (Phrases{"ready to switch on", "switched on", "operation enabled", "no quick stop"}));
    EXPECT_EQ(statusWordPhrases(0x8008), (Phrases{"fault", "other bits 0x8000"}));
    EXPECT_EQ(statusRegisterPhrases(0), Phrases{});
    EXPECT_EQ(statusRegisterPhrases(0x0000'8290 | (1U << 13U)),
              (Phrases{"motor on", "current limit", "moving", "position mode"}));
    EXPECT_EQ(statusRegisterPhrases(0b0011), Phrases{"under-voltage"});
    EXPECT_EQ(statusRegisterPhrases(0b0101), Phrases{"over-voltage"});
    EXPECT_EQ(statusRegisterPhrases(0b1011), Phrases{"short circuit"});
    EXPECT_EQ(statusRegisterPhrases(0b1101), Phrases{"overheated"});
    EXPECT_EQ(statusRegisterPhrases(0b0111), Phrases{"drive status 3"});
    EXPECT_EQ(statusRegisterPhrases((1U << 6U) | (1U << 28U)),
              (Phrases{"motor failure", "stopped by a limit"}));
    EXPECT_EQ(motorFaultPhrases(0), Phrases{});
    EXPECT_EQ(motorFaultPhrases(0x8), Phrases{"peak current exceeded"});
    EXPECT_EQ(motorFaultPhrases(0x2'0100),
              (Phrases{"position error over its limit", "other bits 0x20000"}));
    EXPECT_EQ(unitModeWord(1), "torque");
    EXPECT_EQ(unitModeWord(4), "unit 4");
}

TEST(AbsolemWords, describeEveryNodeAndVerdict)
{
    for (std::size_t node = 1; node <= kAbsolemNodes; ++node)
        EXPECT_FALSE(describe(static_cast<Node>(node)).empty());
    for (std::size_t verdict = 0; verdict < kAbsolemVerdicts; ++verdict)
        EXPECT_FALSE(describe(static_cast<Verdict>(verdict)).empty());
    EXPECT_THROW(describe(static_cast<Node>(0)), std::invalid_argument);
    EXPECT_THROW(describe(static_cast<Verdict>(kAbsolemVerdicts)), std::invalid_argument);
}

}  // namespace
}  // namespace terratact
