#include "drivers/socketcan.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <stdexcept>
#include <thread>
#include <utility>

#include <fmt/format.h>

namespace terratact {
namespace {

constexpr double kFirstBackOff = 0.1,
                 kMaxBackOff = 1.0;        // [s] between searches for an absent interface
constexpr double kLookEvery = 0.1;         // [s] between checks of a present one
constexpr double kFullCounts = 0.5;        // [s] for which a full queue is remembered
constexpr double kPauseAfterError = 0.01;  // [s] so that no error causes a busy loop
constexpr double kFrameInBuffer = 896.0;   // [B] that Linux 6.12 charges for a frame; 6.1: 768
constexpr double kFullBus = 9009.0;        // [1/s] frames of 8 bytes at 1 Mbit/s

template <class Clock>
double secondsOf()
{
    return std::chrono::duration<double>(Clock::now().time_since_epoch()).count();
}

/// Returns the frame as its echo will be: bytes behind its end are not sent.
CanFrame trimmed(CanFrame frame)
{
    std::fill(frame.data.begin() + frame.length, frame.data.end(), std::uint8_t{0});
    return frame;
}

}  // namespace

Status checkInterfaceName(std::string_view name)
{
    const auto allowed = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9')
            || c == '_' || c == '.' || c == '-';
    };
    const bool isPath = name == "." || name == "..";
    if (!name.empty() && name.size() <= 15 && std::ranges::all_of(name, allowed) && !isPath)
        return Done{};
    return Error{
        fmt::format("{:?} cannot be a CAN interface: 1 to 15 letters, digits and _ . -, such as "
                    "can0 (ip -brief link lists what there is)",
                    name.substr(0, 40))};
}

SocketCan::SocketCan(const Options& options, System system)
    : options_(options), system_(std::move(system)), backOff_(kFirstBackOff)
{
}

Result<std::unique_ptr<SocketCan>> SocketCan::open(const Options& options)
{
    return open(
        options,
        {.openSocket = [name = options.interface,
                        buffer = options.receiveBuffer] { return openCanSocket(name, buffer); },
         .steadyTime = secondsOf<std::chrono::steady_clock>,
         .wallTime = secondsOf<std::chrono::system_clock>,
         .sleep =
             [](double seconds) {
                 std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
             }});
}

Result<std::unique_ptr<SocketCan>> SocketCan::open(const Options& options, System system)
{
    if (!(options.stalledAfter > 0.0) || options.receiveBuffer <= 0)
        throw std::invalid_argument("SocketCan: stalledAfter and receiveBuffer must be positive");
    if (Status name = checkInterfaceName(options.interface); !name) return name.error();
    std::unique_ptr<SocketCan> bus(new SocketCan(options, std::move(system)));
    const std::scoped_lock lock(bus->mutex_);
    if (Status connected = bus->connect(); !connected && connected.error().code != ENODEV)
        return connected.error();
    return bus;
}

Result<std::size_t> SocketCan::receive(std::span<BusFrame> frames,
                                       std::chrono::milliseconds patience)
{
    if (frames.empty()) throw std::invalid_argument("SocketCan: no room for a frame");
    const double deadline = system_.steadyTime() + std::chrono::duration<double>(patience).count();
    for (;;) {
        poll();
        const double left = std::max(0.0, deadline - system_.steadyTime());
        const double nap = std::min(left, untilLook());
        if (!socket_) {
            if (left <= 0.0) return std::size_t{0};
            system_.sleep(nap);
            continue;
        }
        const auto reading = socket_->read(frames, nap);
        if (reading) {
            if (const std::size_t count = unpack(frames, *reading); count > 0) return count;
        } else {
            failed(reading.error().code);
            system_.sleep(std::min(left, kPauseAfterError));
            if (state() != BusState::Down && state() != BusState::Absent)
                return Error{Message(TR_NOOP("core", "%1: not readable: %2"), name(),
                                     reading.error().message),
                             reading.error().code};
        }
        if (system_.steadyTime() >= deadline) return std::size_t{0};
    }
}

Status SocketCan::send(const CanFrame& frame)
{
    requireSendable(frame);
    const double now = system_.steadyTime();
    std::unique_lock lock(mutex_);
    if (auto reason = obstacle(now)) {
        ++counters_.notSent;
        return Error{*std::move(reason)};
    }
    const CanFrame content = trimmed(frame);
    const Status written = socket_->write(content);
    if (written) {
        ++counters_.sent;
        unconfirmed_.push_back({content, now});
        full_.reset();
        return Done{};
    }
    ++counters_.notSent;
    const int code = written.error().code;
    if (code == ENOBUFS || code == EAGAIN) {
        if (!full_ || now - full_->last > kFullCounts) full_ = Full{now, now};
        full_->last = now;
        return Error{Message(TR_NOOP("core", "%1: not sent, the kernel's queue is full"), name()),
                     code};
    }
    lock.unlock();
    failed(code);
    if (state() == BusState::Down || state() == BusState::Absent)
        return Error{describe(state(), name()), code};
    return Error{Message(TR_NOOP("core", "%1: not sent: %2"), name(), written.error().message),
                 code};
}

BusState SocketCan::state() const
{
    const double now = system_.steadyTime();
    const std::scoped_lock lock(mutex_);
    return stateAt(now);
}

BusCounters SocketCan::counters() const
{
    const std::scoped_lock lock(mutex_);
    BusCounters counters = counters_;
    counters.dropped = drops();
    return counters;
}

std::string SocketCan::warning() const
{
    const std::scoped_lock lock(mutex_);
    if (!socket_) return {};
    const double granted = static_cast<double>(socket_->receiveBuffer());
    if (granted >= 2.0 * options_.receiveBuffer) return {};
    const double frames = std::floor(granted / kFrameInBuffer);
    return fmt::format(
        "{}: the kernel keeps only {:.0f} unread frames ({:.2f} s of a full bus), so some may be "
        "lost (sudo sysctl -w net.core.rmem_max={})",
        name(), frames, frames / kFullBus, options_.receiveBuffer);
}

/// Opens the socket. The mutex must be held.
Status SocketCan::connect()
{
    auto socket = system_.openSocket();
    if (!socket) return socket.error();
    socket_ = *std::move(socket);
    emptiedAt_ = system_.steadyTime();
    became(socket_->link() == CanSocket::Link::Up ? BusState::Up : BusState::Down);
    return Done{};
}

/// Checks the interface when it is due. A socket alone does not show that the interface is up
/// again, or that another one has its name.
void SocketCan::poll()
{
    const double now = system_.steadyTime();
    const std::scoped_lock lock(mutex_);
    if (now < nextLook_) return;
    if (socket_) {
        const CanSocket::Link link = socket_->link();
        if (link_ == BusState::Absent || link == CanSocket::Link::Gone) {
            earlierDrops_ += socket_->drops();
            socket_.reset();
            became(BusState::Absent);
        } else {
            became(link == CanSocket::Link::Up ? BusState::Up : BusState::Down);
            // A dropped echo never comes: the window is cleared.
            if (const std::uint64_t dropped = drops(); dropped != knownDrops_) {
                knownDrops_ = dropped;
                unconfirmed_.clear();
            }
        }
        nextLook_ = now + kLookEvery;
    } else if (connect()) {
        ++counters_.reopened;
        backOff_ = kFirstBackOff;
        nextLook_ = now + kLookEvery;
    } else {
        nextLook_ = now + backOff_;
        backOff_ = std::min(2.0 * backOff_, kMaxBackOff);
    }
}

double SocketCan::untilLook() const
{
    const double now = system_.steadyTime();
    const std::scoped_lock lock(mutex_);
    return std::max(0.0, nextLook_ - now);
}

/// Sets the interface to Up, Down or Absent. Frames sent before it went down are discarded, and its
/// controller is reset. The mutex must be held.
void SocketCan::became(BusState link)
{
    if (link != link_) {
        unconfirmed_.clear();
        full_.reset();
        controller_ = ControllerState::Active;
    }
    link_ = link;
}

/// Updates the state of the interface from an errno.
void SocketCan::failed(int code)
{
    const double now = system_.steadyTime();
    const std::scoped_lock lock(mutex_);
    if (code == ENETDOWN) {
        became(BusState::Down);
        nextLook_ = now + kFirstBackOff;
    } else if (code == ENODEV || code == ENXIO) {
        became(BusState::Absent);
        nextLook_ = now;  // also closes the socket
    }
}

std::size_t SocketCan::unpack(std::span<BusFrame> frames, const CanSocket::Reading& reading)
{
    const double now = system_.steadyTime(), wall = system_.wallTime();
    const std::scoped_lock lock(mutex_);
    for (BusFrame& frame : frames.first(reading.frames)) {
        // The wall clock may have been set meanwhile; but no frame waited before the queue was
        // empty.
        const double age = frame.wallTime > 0.0 ? wall - frame.wallTime : 0.0;
        frame.time = std::clamp(now - age, std::min(emptiedAt_, now), now);
        if (frame.wallTime <= 0.0) frame.wallTime = wall;
        if (frame.echo) confirm(frame.frame);
        if (frame.frame.error) addError(frame);
    }
    counters_.received += reading.frames;
    counters_.malformed += reading.malformed;
    if (reading.emptied) emptiedAt_ = now;
    return reading.frames;
}

/// Only the controller's driver is trusted: an error frame from a process of this computer is
/// forged.
void SocketCan::addError(const BusFrame& frame)
{
    ++counters_.errorFrames;
    if (frame.local) {
        ++counters_.forgedErrors;
        return;
    }
    const auto state = controllerState(frame.frame);
    if (!state) return;
    // A restarted controller has discarded its frames.
    if (controller_ == ControllerState::BusOff && *state != ControllerState::BusOff)
        unconfirmed_.clear();
    controller_ = *state;
}

/// Confirms a frame. Frames leave in order: earlier ones have left too, and their echoes were lost.
void SocketCan::confirm(const CanFrame& frame)
{
    const auto sent = std::ranges::find(unconfirmed_, frame, &Sent::frame);
    if (sent == unconfirmed_.end()) return;
    unconfirmed_.erase(unconfirmed_.begin(), sent + 1);
    ++counters_.confirmed;
    full_.reset();
}

std::uint64_t SocketCan::drops() const
{
    return earlierDrops_ + (socket_ ? socket_->drops() : 0);
}

bool SocketCan::overdue(double now) const
{
    return !unconfirmed_.empty() && now - unconfirmed_.front().time >= options_.stalledAfter;
}

BusState SocketCan::stateAt(double now) const
{
    const bool full = full_ && full_->last - full_->since >= options_.stalledAfter
                   && now - full_->last < kFullCounts;
    if (link_ != BusState::Up) return link_;
    if (controller_ != ControllerState::BusOff && (full || overdue(now))) return BusState::Stalled;
    switch (controller_) {
    case ControllerState::Active: return BusState::Up;
    case ControllerState::Warning: return BusState::ErrorWarning;
    case ControllerState::Passive: return BusState::ErrorPassive;
    case ControllerState::BusOff: break;
    }
    return BusState::BusOff;
}

/// Returns why nothing may be sent now; nothing: sending is possible.
std::optional<Message> SocketCan::obstacle(double now) const
{
    if (!options_.transmit)
        return Message(TR_NOOP("core", "%1 was opened to receive only: nothing is sent"), name());
    if (link_ != BusState::Up || controller_ == ControllerState::BusOff || overdue(now))
        return describe(stateAt(now), name());
    if (options_.maxUnconfirmed > 0 && unconfirmed_.size() >= options_.maxUnconfirmed)
        return Message(TR_NOOP("core", "%1: not sent, %2 frames before it have not left yet"),
                       name(), unconfirmed_.size());
    return std::nullopt;
}

}  // namespace terratact
