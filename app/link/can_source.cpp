#include "app/link/can_source.h"

#include <algorithm>
#include <span>
#include <thread>
#include <utility>

namespace terratact {
namespace {

using namespace std::chrono_literals;

constexpr std::chrono::milliseconds kTurn{10};  // half the period of drive commands

std::optional<Command> commandIn(const CanFrame& frame)
{
    const auto unpacked = unpack(frame);
    const auto* content = std::get_if<Unpacked>(&unpacked);
    const auto received = content ? commandOf(*content) : std::nullopt;
    return received ? std::optional(received->command) : std::nullopt;
}

}  // namespace

CanSource::CanSource(std::unique_ptr<CanBus> bus, const RobotModel& robot, const Options& options)
    : bus_(std::move(bus)), options_(options), waits_(options.waits), link_(robot, options.link)
{
}

std::string CanSource::name() const
{
    return options_.name.empty() ? bus_->name() : options_.name;
}

Result<std::optional<Sample>> CanSource::next(std::chrono::milliseconds patience)
{
    if (waits_) {
        std::this_thread::sleep_for(std::min(patience, kTurn));
        return std::optional<Sample>{};
    }
    const auto end = std::chrono::steady_clock::now() + patience;
    while (true) {
        if (auto sample = consumePending()) return sample;
        const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(
            end - std::chrono::steady_clock::now());
        const auto count = bus_->receive(frames_, std::clamp(left, 0ms, kTurn));
        work();
        tap_.tick(options_.clock());
        if (!count) return count.error();
        const auto received = std::span<const BusFrame>(frames_).first(*count);
        if (options_.received && !received.empty()) options_.received(received);
        pending_.insert(pending_.end(), frames_.begin(),
                        frames_.begin() + static_cast<std::ptrdiff_t>(*count));
        waiting_ = pending_.size();
        mostWaiting_ = std::max<std::size_t>(mostWaiting_, waiting_);
        if (*count > 0 || left > 0ms) continue;
        if (auto what = trouble()) return Error{*std::move(what)};
        return std::optional<Sample>{};
    }
}

bool CanSource::ended() const
{
    return options_.mode == Mode::Replay && bus_->state() == BusState::Ended;
}

std::optional<Message> CanSource::trouble() const
{
    const BusState state = bus_->state();
    if (state == BusState::Up) return std::nullopt;
    return describe(state, bus_->name());
}

std::optional<Message> CanSource::whyNotTransmitting() const
{
    switch (options_.mode) {
    case Mode::Transmit: break;
    case Mode::Listen:
        return Message(TR_NOOP("BusWords", "%1 is receive-only: start the console with --transmit"),
                       name());
    case Mode::Replay: return Message(TR_NOOP("BusWords", "%1 takes no commands"), name());
    }
    return std::nullopt;
}

std::optional<Sample> CanSource::consumePending()
{
    const std::scoped_lock lock(mutex_);
    while (!pending_.empty()) {
        const BusFrame received = pending_.front();
        pending_.pop_front();
        const auto measurement = link_.receive(received.frame, received.echo, received.time);
        tap_.add(received, link_.telemetry().judged());
        if (!measurement) continue;
        Sample sample{
            .measurement = *measurement, .truth = {}, .forces = link_.telemetry().forces()};
        if (options_.truth) {
            const TrueHeights truth = options_.truth();
            sample.truth = truth.middle;
            sample.sideTruth = truth.sides;
        }
        return sample;
    }
    return std::nullopt;
}

void CanSource::work()
{
    if (options_.mode != Mode::Transmit) return;
    const std::scoped_lock lock(mutex_);
    const double now = options_.clock();
    if (unsent_) {
        const auto sent = link_.send(*unsent_, now);
        const auto* const frame = std::get_if<CanFrame>(&sent);
        if (frame && bus_->send(*frame)) unsent_.reset();
    }
    for (const CanFrame& frame : link_.tick(now)) {
        const Status left = bus_->send(frame);  // the bus counts failures
        const auto command = commandIn(frame);
        if (command && safety(*command) > 0) remember(*command, static_cast<bool>(left));
    }
}

// A command that passes the gate is the operator's newest and replaces the pending one, unless that is safer. The gate
// passes motion and release commands only after a stop has ended.
void CanSource::remember(const Command& command, bool left)
{
    const int level = safety(command);
    if (unsent_ && level != 0 && level < safety(*unsent_)) return;
    unsent_.reset();
    if (!left && level != 0) unsent_ = command;
}

Status CanSource::send(const Command& command)
{
    if (auto why = whyNotTransmitting()) return Error{*std::move(why)};
    const std::scoped_lock lock(mutex_);
    const auto sent = link_.send(command, options_.clock());
    if (const auto* refusal = std::get_if<GateRefusal>(&sent)) return Error{describe(*refusal), 0};
    const auto* frame = std::get_if<CanFrame>(&sent);
    Status left = frame ? bus_->send(*frame) : Done{};  // otherwise next() sends it later
    remember(command, static_cast<bool>(left));
    return left;
}

void CanSource::operatorAlive()
{
    const std::scoped_lock lock(mutex_);
    link_.operatorAlive(options_.clock());
}

void CanSource::wantArming()
{
    const std::scoped_lock lock(mutex_);
    link_.wantArming();
}

void CanSource::confirmArming()
{
    const std::scoped_lock lock(mutex_);
    link_.confirmArming();
}

void CanSource::disarm()
{
    {
        const std::scoped_lock lock(mutex_);
        link_.disarm();
    }
    work();  // sends at once, because the thread of next() may be ending
}

void CanSource::approve(const ProbeCommand& probe)
{
    const std::scoped_lock lock(mutex_);
    link_.approve(probe, options_.clock());
}

CanView CanSource::view() const
{
    const std::scoped_lock lock(mutex_);
    return {.link = link_.view(options_.clock()),
            .bus = bus_->state(),
            .busName = bus_->name(),
            .frames = bus_->counters(),
            .telemetry = link_.telemetry().counters(),
            .forces = link_.telemetry().forces(),
            .transmits = options_.mode == Mode::Transmit,
            .whyNotTransmitting = whyNotTransmitting(),
            .waits = waits_,
            .ended = ended()};
}

std::vector<LinkNeed> armingNeeds(const CanView& view)
{
    const auto& robot = view.link.robot;
    const auto need = [](bool met, SourceText so, const Message& why) {
        return LinkNeed{met, met ? Message(so) : why};
    };
    return {need(!view.whyNotTransmitting, TR_NOOP("core", "commands can leave"),
                 view.whyNotTransmitting.value_or(Message())),
            need(!view.link.foreignSender, TR_NOOP("core", "no other console sends commands"),
                 describe(DisarmCause::ForeignSender)),
            need(!robot || robot->activity != RobotActivity::Stopped,
                 TR_NOOP("core", "STOP is not latched"),
                 TR_NOOP("core", "STOP is latched: release it first")),
            need(view.link.goodFor >= ArmingLimits{}.linkGood, TR_NOOP("core", "the link is good"),
                 TR_NOOP("core", "The link must be good for a second")),
            need(!robot || !robot->armed, TR_NOOP("core", "no other console has armed the robot"),
                 describe(DisarmCause::AlreadyArmed))};
}

std::optional<Message> whyNotArming(const CanView& view)
{
    for (const LinkNeed& need : armingNeeds(view))
        if (!need.met) return need.text;
    return std::nullopt;
}

}  // namespace terratact
