#include "core/wire/command_receiver.h"

#include <algorithm>
#include <stdexcept>

namespace terratact {
namespace {

bool isYoung(double given, double now)
{
    return now >= given && now - given <= CommandReceiver::kChallengeLife;
}

}  // namespace

CommandReceiver::CommandReceiver(std::uint8_t firstEpoch, std::uint16_t firstChallenge)
    : epoch_(firstEpoch), heartbeat_(layoutOf(FrameKind::ConsoleHeartbeat).dataId,
                                     {.stale = kHeartbeatLimit, .lost = kHeartbeatLimit}),
      nextChallenge_(firstChallenge)
{
    if (firstEpoch == 0) throw std::invalid_argument("CommandReceiver: no epoch is 0");
    if (firstChallenge == 0) throw std::invalid_argument("CommandReceiver: no challenge is 0");
}

// Returns the newest challenge again if it is young, so that fast heartbeats do not use up the
// numbers.
std::uint16_t CommandReceiver::give(double now)
{
    std::erase_if(challenges_, [now](const Challenge& c) { return !isYoung(c.given, now); });
    if (!challenges_.empty() && now - challenges_.back().given < kChallengePeriod)
        return challenges_.back().number;
    challenges_.push_back({.number = nextChallenge_, .given = now});
    if (++nextChallenge_ == 0) nextChallenge_ = 1;
    return challenges_.back().number;
}

bool CommandReceiver::isFresh(std::optional<std::uint16_t> challenge, double now) const
{
    return std::ranges::any_of(challenges_, [&](const Challenge& c) {
        return c.number == challenge && isYoung(c.given, now);
    });
}

// Voids everything that was sent before.
void CommandReceiver::forget()
{
    challenges_.clear();
    counters_.fill(std::nullopt);
}

void CommandReceiver::disarm()
{
    armed_ = false;
    lastDrive_.reset();
    epoch_ = epoch_ == 255 ? std::uint8_t{1} : static_cast<std::uint8_t>(epoch_ + 1);
    forget();
}

CommandReceiver::Silence CommandReceiver::tick(double now)
{
    if (armed_ && heartbeat_.state(now) != LinkState::Good) {
        disarm();
        return Silence::OfConsole;
    }
    const bool ranOut = lastDrive_ && !(now - *lastDrive_ <= kDriveLimit);
    if (!ranOut) return Silence::None;
    lastDrive_.reset();
    forget();
    return Silence::OfDrive;
}

CommandReceiver::Answer CommandReceiver::receive(const CanFrame& frame, double now)
{
    if (meansStop(frame)) {
        disarm();
        return {.verdict = CommandVerdict::Accepted,
                .command = StopCommand{},
                .kind = FrameKind::Stop,
                .counter = frame.data[2]};
    }
    const auto unpacked = unpack(frame);
    if (const auto* fault = std::get_if<FrameFault>(&unpacked)) {
        const bool foreign =
            *fault == FrameFault::UnknownId || *fault == FrameFault::NotClassicData;
        return {.verdict = foreign ? CommandVerdict::NotACommand : CommandVerdict::Malformed};
    }
    const auto& content = std::get<Unpacked>(unpacked);
    if (content.kind == FrameKind::ConsoleHeartbeat) return heartbeat(frame, content, now);
    const std::optional<ReceivedCommand> received = commandOf(content);
    if (!received) return {.verdict = CommandVerdict::NotACommand};
    return judge(content, *received, now);
}

CommandReceiver::Answer CommandReceiver::heartbeat(const CanFrame& frame, const Unpacked& content,
                                                   double now)
{
    switch (heartbeat_.receive(bytesOf(frame), now)) {
    case FrameCheck::Ok:
    case FrameCheck::SomeLost:
        return {.verdict = CommandVerdict::Heartbeat,
                .token = tokenOf(content),
                .challenge = give(now)};
    case FrameCheck::Repeated: return {.verdict = CommandVerdict::Repeated};
    case FrameCheck::WrongSequence: return {.verdict = CommandVerdict::WrongSequence};
    case FrameCheck::WrongCrc: break;
    }
    return {.verdict = CommandVerdict::Malformed};
}

CommandReceiver::Answer CommandReceiver::judge(const Unpacked& content,
                                               const ReceivedCommand& received, double now)
{
    Answer answer{.kind = content.kind, .counter = content.counter};
    if (safety(received.command) == 0) {
        std::optional<CommandVerdict> refusal = refusalOf(content.kind, received, now);
        if (!refusal) refusal = outOfOrder(content);
        if (refusal) {
            answer.verdict = *refusal;
            return answer;
        }
    }
    obey(received.command, now);
    answer.verdict = CommandVerdict::Accepted;
    answer.command = received.command;
    return answer;
}

std::optional<CommandVerdict>
CommandReceiver::refusalOf(FrameKind kind, const ReceivedCommand& received, double now)
{
    if (received.epoch.value_or(epoch_) != epoch_) return CommandVerdict::WrongEpoch;
    const bool alive = heartbeat_.state(now) == LinkState::Good;
    if (kind == FrameKind::Arm && !alive) return CommandVerdict::NoHeartbeat;
    const bool needsArming = kind != FrameKind::Arm && kind != FrameKind::ReleaseStop;
    if (needsArming && !(armed_ && alive)) return CommandVerdict::NotArmed;
    return isFresh(received.challenge, now) ? std::nullopt : std::optional(CommandVerdict::TooLate);
}

std::optional<CommandVerdict> CommandReceiver::outOfOrder(const Unpacked& content)
{
    auto& counter = counters_[static_cast<std::size_t>(content.kind)];
    const int delta = counter ? (content.counter - *counter) & 0xFF : 1;
    if (delta == 0) return CommandVerdict::Repeated;
    if (delta > 0x7F) return CommandVerdict::WrongSequence;  // an old one, which changes nothing
    counter = content.counter;
    return delta > E2eReceiver::kMaxDelta ? std::optional(CommandVerdict::WrongSequence)
                                          : std::nullopt;
}

void CommandReceiver::obey(const Command& command, double now)
{
    if (const auto* arm = std::get_if<ArmCommand>(&command)) {
        disarm();  // ends an earlier arming and begins a new epoch
        armed_ = arm->armed;
        return;
    }
    if (safety(command) > 0) {
        lastDrive_.reset();
        forget();
    }
    if (std::holds_alternative<DriveCommand>(command)) lastDrive_ = now;
}

}  // namespace terratact
