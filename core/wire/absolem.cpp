#include "core/wire/absolem.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string_view>

namespace terratact {
namespace {

using Kind = AbsolemFrame::Kind;
using Mnemonic = std::array<char, 2>;

constexpr std::uint32_t kStatusBase = 0x180, kReplyBase = 0x280, kRequestBase = 0x300;
constexpr std::uint8_t kIndexBits = 0x3F, kFlagBit = 0x40, kFloatBit = 0x80;
constexpr double kPatience = 0.1;  // [s] longest wait for a reply; the robot itself waits 0.01 s
constexpr double kMaxCounts = 1'000'000;  // modulus that the driver sets (XM)
constexpr double kMaxCurrent = 50.0;      // [A] the drive's peak limit is 16 A
constexpr std::uint16_t kEmergencyInput = 16;

constexpr Mnemonic kPositionReply{'P', 'X'}, kCurrent{'I', 'Q'}, kStatusReply{'S', 'R'},
    kFaultReply{'M', 'F'}, kInput{'I', 'B'};
// Further commands of the robot's driver, whose values are not kept.
constexpr std::string_view kOthers =
    "PA SP JV VX BG AN EC MS UM CL PL UI MO AC DC EF ER GS HM HP KI KP PM "
    "SF SV TR UF XC XM ";

std::size_t indexOf(AbsolemNode node)
{
    return static_cast<std::size_t>(node) - 1;
}

std::optional<AbsolemNode> nodeOf(std::uint32_t id, std::uint32_t base)
{
    if (id <= base || id > base + kAbsolemNodes) return std::nullopt;
    return static_cast<AbsolemNode>(id - base);
}

std::uint32_t littleEndian(const CanFrame& frame, std::size_t first, std::size_t count)
{
    std::uint32_t bits = 0;
    for (std::size_t i = first + count; i > first; --i) bits = (bits << 8U) | frame.data[i - 1];
    return bits;
}

bool isLetter(char c)
{
    return c >= 'A' && c <= 'Z';
}

char capital(std::uint8_t byte)
{
    const char c = static_cast<char>(byte);
    return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
}

bool isOneOfOthers(const Mnemonic& command)
{
    const char word[]{command[0], command[1], ' ', '\0'};
    return kOthers.find(word) != std::string_view::npos;
}

std::variant<AbsolemFrame, AbsolemVerdict> twoBytes(const CanFrame& frame, Kind kind,
                                                    AbsolemNode node)
{
    if (frame.length < 2) return AbsolemVerdict::WrongLength;
    AbsolemFrame got;
    got.kind = kind;
    got.node = node;
    got.bits = littleEndian(frame, 0, 2);
    return got;
}

std::variant<AbsolemFrame, AbsolemVerdict> interpreted(const CanFrame& frame, bool isReply,
                                                       AbsolemNode node)
{
    const bool isShort = frame.length == 4 && !isReply;
    if (!isShort && frame.length != 8) return AbsolemVerdict::WrongLength;
    AbsolemFrame got;
    got.node = node;
    got.command = {capital(frame.data[0]), capital(frame.data[1])};
    if (!isLetter(got.command[0]) || !isLetter(got.command[1])) return AbsolemVerdict::NotACommand;
    const std::uint8_t type = frame.data[3];
    got.index = static_cast<std::uint16_t>(frame.data[2] | ((type & kIndexBits) << 8U));
    got.isFloat = (type & kFloatBit) != 0;
    got.flagged = (type & kFlagBit) != 0;
    got.kind = isReply ? Kind::Reply : isShort || got.flagged ? Kind::Query : Kind::Set;
    if (got.kind != Kind::Query) got.bits = littleEndian(frame, 4, 4);
    return got;
}

// Returns 1 if the tip rises with the counts of the flipper's encoder, −1 if it falls. All joints
// turn about the axis to the left: with the angle a front flipper's tip moves down and a rear one's
// up. The motors on the left are mounted mirrored.
std::optional<double> upwards(AbsolemNode node)
{
    switch (node) {
    case AbsolemNode::FrontLeft:
    case AbsolemNode::RearRight: return 1.0;
    case AbsolemNode::FrontRight:
    case AbsolemNode::RearLeft: return -1.0;
    case AbsolemNode::Core:
    case AbsolemNode::TrackLeft:
    case AbsolemNode::TrackRight: break;
    }
    return std::nullopt;
}

AbsolemState::Flipper* flipperOf(AbsolemState& state, AbsolemNode node)
{
    switch (node) {
    case AbsolemNode::FrontLeft: return &state.frontLeft;
    case AbsolemNode::FrontRight: return &state.frontRight;
    case AbsolemNode::RearLeft: return &state.rearLeft;
    case AbsolemNode::RearRight: return &state.rearRight;
    case AbsolemNode::Core:
    case AbsolemNode::TrackLeft:
    case AbsolemNode::TrackRight: break;
    }
    return nullptr;
}

AbsolemVerdict keepAngle(AbsolemState& state, const AbsolemFrame& reply, double now)
{
    const double counts = reply.asInt();
    if (std::abs(counts) > kMaxCounts) return AbsolemVerdict::OutOfRange;
    AbsolemState::Flipper* flipper = flipperOf(state, reply.node);
    if (!flipper) return AbsolemVerdict::Passed;
    constexpr double kTurn = 2.0 * std::numbers::pi;
    const double angle = *upwards(reply.node) * counts * kTurn / kFlipperCounts;
    flipper->angle = {std::remainder(angle, kTurn), now};
    return AbsolemVerdict::Used;
}

AbsolemVerdict keepCurrent(AbsolemState& state, const AbsolemFrame& reply, double now)
{
    const double current = reply.asFloat();
    // true for NaN, too
    if (!(std::abs(current) <= kMaxCurrent)) return AbsolemVerdict::OutOfRange;
    AbsolemState::Flipper* flipper = flipperOf(state, reply.node);
    if (!flipper) return AbsolemVerdict::Passed;
    flipper->current = {-*upwards(reply.node) * current, now};
    return AbsolemVerdict::Used;
}

std::optional<double> freshValue(const std::optional<Dated<double>>& dated, double oldest)
{
    return dated && dated->time >= oldest ? std::optional(dated->value) : std::nullopt;
}

std::optional<Pair> freshPair(const std::optional<Dated<double>>& left,
                              const std::optional<Dated<double>>& right, double oldest)
{
    const auto l = freshValue(left, oldest), r = freshValue(right, oldest);
    return l && r ? std::optional(Pair{*l, *r}) : std::nullopt;
}

}  // namespace

std::string describe(AbsolemNode node)
{
    switch (node) {
    case AbsolemNode::Core: return "core";
    case AbsolemNode::RearRight: return "rear right flipper";
    case AbsolemNode::TrackRight: return "right track";
    case AbsolemNode::FrontRight: return "front right flipper";
    case AbsolemNode::RearLeft: return "rear left flipper";
    case AbsolemNode::TrackLeft: return "left track";
    case AbsolemNode::FrontLeft: return "front left flipper";
    }
    throw std::invalid_argument("describe: no such AbsolemNode");
}

std::string describe(AbsolemVerdict verdict)
{
    switch (verdict) {
    case AbsolemVerdict::Used: return "used";
    case AbsolemVerdict::Passed: return "in order";
    case AbsolemVerdict::UnknownId: return "unknown identifier";
    case AbsolemVerdict::NotClassicData: return "no standard data frame";
    case AbsolemVerdict::WrongLength: return "wrong length";
    case AbsolemVerdict::NotACommand: return "no command of two letters";
    case AbsolemVerdict::UnknownCommand: return "unknown command";
    case AbsolemVerdict::NotAsked: return "answers no request";
    case AbsolemVerdict::Refused: return "refused by the drive";
    case AbsolemVerdict::WrongType: return "a float where an integer is expected";
    case AbsolemVerdict::OutOfRange: return "a value is beyond its range";
    }
    throw std::invalid_argument("describe: no such AbsolemVerdict");
}

std::string AbsolemFrame::name() const
{
    std::string text(command.begin(), command.end());
    if (index != 0) text.append("[").append(std::to_string(index)).append("]");
    return text;
}

std::int32_t AbsolemFrame::asInt() const
{
    return std::bit_cast<std::int32_t>(bits);
}

float AbsolemFrame::asFloat() const
{
    return std::bit_cast<float>(bits);
}

std::variant<AbsolemFrame, AbsolemVerdict> absolemFrame(const CanFrame& frame)
{
    if (frame.extended || frame.remote || frame.error || frame.fd)
        return AbsolemVerdict::NotClassicData;
    if (frame.id == 0) return twoBytes(frame, Kind::NetworkCommand, AbsolemNode::Core);
    if (const auto node = nodeOf(frame.id, kStatusBase))
        return twoBytes(frame, Kind::StatusWord, *node);
    if (const auto node = nodeOf(frame.id, kReplyBase)) return interpreted(frame, true, *node);
    if (const auto node = nodeOf(frame.id, kRequestBase)) return interpreted(frame, false, *node);
    return AbsolemVerdict::UnknownId;
}

SensorLine sensorLineOf(const AbsolemState& state, double now, double limit)
{
    const double oldest = now - limit;
    SensorLine line;
    line.frontAngles = freshPair(state.frontLeft.angle, state.frontRight.angle, oldest);
    line.rearAngles = freshPair(state.rearLeft.angle, state.rearRight.angle, oldest);
    line.frontCurrents = {freshValue(state.frontLeft.current, oldest),
                          freshValue(state.frontRight.current, oldest)};
    line.rearCurrents = {freshValue(state.rearLeft.current, oldest),
                         freshValue(state.rearRight.current, oldest)};
    return line;
}

AbsolemListener::Received AbsolemListener::receive(const CanFrame& frame, double now)
{
    if (!std::isfinite(now))
        throw std::invalid_argument("AbsolemListener: the time must be finite");
    const std::variant<AbsolemFrame, AbsolemVerdict> got = absolemFrame(frame);
    Received received;
    if (const auto* fault = std::get_if<AbsolemVerdict>(&got)) {
        received.verdict = *fault;
    } else {
        received.frame = std::get<AbsolemFrame>(got);
        received.verdict = follow(*received.frame, now);
    }
    ++counters_[static_cast<std::size_t>(received.verdict)];
    return received;
}

AbsolemVerdict AbsolemListener::follow(const AbsolemFrame& frame, double now)
{
    switch (frame.kind) {
    case Kind::NetworkCommand: return AbsolemVerdict::Passed;
    case Kind::StatusWord:
        state_.drives[indexOf(frame.node)].statusWord = {static_cast<std::uint16_t>(frame.bits),
                                                         now};
        return AbsolemVerdict::Used;
    case Kind::Query:
    case Kind::Set:
        nodes_[indexOf(frame.node)].asked = Request{frame.command, frame.index, now};
        return AbsolemVerdict::Passed;
    case Kind::Reply: return receiveReply(frame, now);
    }
    return AbsolemVerdict::Passed;
}

AbsolemVerdict AbsolemListener::receiveReply(const AbsolemFrame& reply, double now)
{
    Node& node = nodes_[indexOf(reply.node)];
    const std::optional<Request> asked = node.asked;
    const bool isAnswer = asked && asked->command == reply.command && asked->index == reply.index
                       && now >= asked->time && now - asked->time <= kPatience;
    if (!isAnswer) return AbsolemVerdict::NotAsked;
    node.asked.reset();  // each request has one reply
    const bool isErrorCode = reply.bits > 0 && reply.bits <= 0xFF;
    if (reply.flagged && !isErrorCode) node.echoes = true;
    if (reply.flagged && !node.echoes) return AbsolemVerdict::Refused;
    return keep(reply, now);
}

AbsolemVerdict AbsolemListener::keep(const AbsolemFrame& reply, double now)
{
    AbsolemState::Drive& drive = state_.drives[indexOf(reply.node)];
    const bool isEmergency = reply.command == kInput && reply.index == kEmergencyInput;
    if (reply.command == kCurrent && reply.index == 0)
        return keepCurrent(state_, reply,
                           now);  // the type bit is ignored, as the robot does
    const bool isKept = isEmergency
                     || (reply.index == 0
                         && (reply.command == kPositionReply || reply.command == kStatusReply
                             || reply.command == kFaultReply));
    if (!isKept)
        return isOneOfOthers(reply.command) ? AbsolemVerdict::Passed
                                            : AbsolemVerdict::UnknownCommand;
    if (reply.isFloat) return AbsolemVerdict::WrongType;
    if (reply.command == kPositionReply) return keepAngle(state_, reply, now);
    if (isEmergency)
        state_.emergencyStop = {reply.bits != 0, now};
    else if (reply.command == kStatusReply)
        drive.statusRegister = {reply.bits, now};
    else
        drive.motorFault = {reply.bits, now};
    return AbsolemVerdict::Used;
}

}  // namespace terratact
