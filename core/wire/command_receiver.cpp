#include "core/wire/command_receiver.h"

#include <stdexcept>

namespace terratact {

CommandReceiver::CommandReceiver(std::uint8_t firstEpoch)
    : epoch_(firstEpoch), heartbeat_(layoutOf(FrameKind::ConsoleHeartbeat).dataId,
                                     {.stale = kHeartbeatLimit, .lost = kHeartbeatLimit})
{
    if (firstEpoch == 0) throw std::invalid_argument("CommandReceiver: no epoch is 0");
}

void CommandReceiver::disarm()
{
    armed_ = false;
    lastDrive_.reset();
    epoch_ = epoch_ == 255 ? std::uint8_t{1} : static_cast<std::uint8_t>(epoch_ + 1);
    counters_.fill(std::nullopt);
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
        return {.verdict = CommandVerdict::Heartbeat, .token = tokenOf(content)};
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
    if (received.epoch != epoch_) return CommandVerdict::WrongEpoch;
    if (kind == FrameKind::ReleaseStop) return std::nullopt;
    const bool alive = heartbeat_.state(now) == LinkState::Good;
    if (kind == FrameKind::Arm)
        return alive ? std::nullopt : std::optional(CommandVerdict::NoHeartbeat);
    return armed_ && alive ? std::nullopt : std::optional(CommandVerdict::NotArmed);
}

std::optional<CommandVerdict> CommandReceiver::outOfOrder(const Unpacked& content)
{
    auto& counter = counters_[static_cast<std::size_t>(content.kind)];
    const std::optional<std::uint8_t> before = counter;
    counter = content.counter;
    if (!before) return std::nullopt;
    const int delta = (content.counter - *before) & 0xFF;
    if (delta == 0) return CommandVerdict::Repeated;
    return delta > E2eReceiver::kMaxDelta ? std::optional(CommandVerdict::WrongSequence)
                                          : std::nullopt;
}

void CommandReceiver::obey(const Command& command, double now)
{
    if (const auto* arm = std::get_if<ArmCommand>(&command)) {
        disarm();  // whatever was armed before: a new epoch
        armed_ = arm->armed;
        return;
    }
    if (safety(command) > 0) lastDrive_.reset();
    if (std::holds_alternative<DriveCommand>(command)) lastDrive_ = now;
}

}  // namespace terratact
