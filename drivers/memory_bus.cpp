#include "drivers/memory_bus.h"

#include <algorithm>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

namespace terratact {
namespace {

bool connected(BusState state)
{
    return state != BusState::Down && state != BusState::Absent;
}

}  // namespace

struct MemoryBus::Socket {
    std::string name;
    std::size_t window = 0;
    BusState state = BusState::Up;
    BusCounters counters;
    std::size_t unconfirmed = 0;
    std::deque<CanFrame> kept;      // sent, but not yet on the bus
    std::deque<BusFrame> received;  // not read yet
};

struct MemoryBus::Wire {
    explicit Wire(Clock time) : clock(std::move(time)) {}

    Clock clock;
    std::mutex mutex;  // guards the members below
    std::condition_variable arrived;
    std::vector<std::shared_ptr<Socket>> sockets;
    std::size_t toDrop = 0;

    void deliver(const CanFrame& frame, const Socket* sender, bool local);
    void change(Socket& socket, BusState state);
};

void MemoryBus::Wire::deliver(const CanFrame& frame, const Socket* sender, bool local)
{
    const bool drop = toDrop > 0;
    if (drop) --toDrop;
    const double now = clock();
    for (const auto& socket : sockets) {
        const bool echo = socket.get() == sender;
        if (!connected(socket->state)) continue;
        if (drop && !echo)
            ++socket->counters.dropped;
        else
            socket->received.push_back({frame, now, now, echo, echo || (local && !sender)});
    }
    arrived.notify_all();
}

void MemoryBus::Wire::change(Socket& socket, BusState state)
{
    if (socket.state == BusState::Absent && connected(state)) ++socket.counters.reopened;
    socket.state = state;
    if (!connected(state)) {
        socket.kept.clear();
        socket.unconfirmed = 0;
    } else if (state != BusState::Stalled) {
        for (; !socket.kept.empty(); socket.kept.pop_front())
            deliver(socket.kept.front(), &socket, true);
    }
}

class MemoryBus::End final : public CanBus {
public:
    End(std::shared_ptr<Wire> wire, std::shared_ptr<Socket> socket)
        : wire_(std::move(wire)), socket_(std::move(socket))
    {
    }
    ~End() override;
    End(const End&) = delete;
    End& operator=(const End&) = delete;

    std::string name() const override { return socket_->name; }
    Result<std::size_t> receive(std::span<BusFrame> frames,
                                std::chrono::milliseconds patience) override;
    Status send(const CanFrame& frame) override;
    BusState state() const override;
    BusCounters counters() const override;

private:
    std::optional<Message> obstacle() const;

    std::shared_ptr<Wire> wire_;
    std::shared_ptr<Socket> socket_;
};

MemoryBus::End::~End()
{
    const std::scoped_lock lock(wire_->mutex);
    std::erase(wire_->sockets, socket_);
}

Result<std::size_t> MemoryBus::End::receive(std::span<BusFrame> frames,
                                            std::chrono::milliseconds patience)
{
    if (frames.empty()) throw std::invalid_argument("MemoryBus: no room for a frame");
    std::unique_lock lock(wire_->mutex);
    wire_->arrived.wait_for(lock, patience, [this] { return !socket_->received.empty(); });
    std::size_t count = 0;
    for (; count < frames.size() && !socket_->received.empty(); ++count) {
        frames[count] = socket_->received.front();
        socket_->received.pop_front();
        ++socket_->counters.received;
        if (frames[count].frame.error) ++socket_->counters.errorFrames;
        if (!frames[count].echo || socket_->unconfirmed == 0) continue;
        --socket_->unconfirmed;
        ++socket_->counters.confirmed;
    }
    return count;
}

Status MemoryBus::End::send(const CanFrame& frame)
{
    requireSendable(frame);
    const std::scoped_lock lock(wire_->mutex);
    if (auto trouble = obstacle()) {
        ++socket_->counters.notSent;
        return Error{Message::joined(Message::verbatim(socket_->name), *std::move(trouble))};
    }
    ++socket_->counters.sent;
    ++socket_->unconfirmed;
    if (socket_->state == BusState::Stalled)
        socket_->kept.push_back(frame);
    else
        wire_->deliver(frame, socket_.get(), true);
    return Done{};
}

std::optional<Message> MemoryBus::End::obstacle() const
{
    if (!connected(socket_->state)) return TR_NOOP("core", "the bus is down");
    if (socket_->state == BusState::BusOff) return TR_NOOP("core", "the controller is off the bus");
    if (socket_->window != 0 && socket_->unconfirmed >= socket_->window)
        return TR_NOOP("core", "what was sent before has not left yet");
    return std::nullopt;
}

BusState MemoryBus::End::state() const
{
    const std::scoped_lock lock(wire_->mutex);
    return socket_->state;
}

BusCounters MemoryBus::End::counters() const
{
    const std::scoped_lock lock(wire_->mutex);
    return socket_->counters;
}

MemoryBus::MemoryBus(Clock clock) : wire_(std::make_shared<Wire>(std::move(clock))) {}

MemoryBus::~MemoryBus() = default;

std::unique_ptr<CanBus> MemoryBus::join(const std::string& name, std::size_t window)
{
    auto socket = std::make_shared<Socket>();
    socket->name = name;
    socket->window = window;
    const std::scoped_lock lock(wire_->mutex);
    wire_->sockets.push_back(socket);
    return std::make_unique<End>(wire_, std::move(socket));
}

void MemoryBus::setState(BusState state, const std::string& end)
{
    const std::scoped_lock lock(wire_->mutex);
    bool found = false;
    for (const auto& socket : wire_->sockets) {
        if (!end.empty() && socket->name != end) continue;
        wire_->change(*socket, state);
        found = true;
    }
    if (!found) throw std::invalid_argument("MemoryBus: no end called " + end);
}

void MemoryBus::dropNext(std::size_t frames)
{
    const std::scoped_lock lock(wire_->mutex);
    wire_->toDrop = frames;
}

void MemoryBus::put(const CanFrame& frame, bool local)
{
    const std::scoped_lock lock(wire_->mutex);
    wire_->deliver(frame, nullptr, local);
}

}  // namespace terratact
