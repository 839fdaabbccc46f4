#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cerrno>
#include <deque>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "drivers/socketcan.h"

namespace terratact {

inline CanFrame frameOfId(std::uint32_t id)
{
    return {.id = id, .length = 2, .data = {1, 2}};
}

// Fake kernel under the test's control, with a clock that only waiting advances.
struct Kernel {
    double now = 100.0, wall = 5000.0;  // [s]
    bool present = true, up = true;
    int noSocket = 0;                   // errno of opening
    int readError = 0, writeError = 0;  // errno, until cleared; a read's is reported once
    std::uint64_t drops = 0;
    std::size_t buffer = 8u << 20;
    std::deque<BusFrame> queue;
    std::vector<CanFrame> written;
    int opened = 0, closed = 0, reads = 0, naps = 0;

    void pass(double seconds)
    {
        now += seconds;
        wall += seconds;
    }
    void put(const CanFrame& frame, bool local = false)
    {
        queue.push_back({.frame = frame, .wallTime = wall, .echo = false, .local = local});
    }
    void echo(const CanFrame& frame)
    {
        queue.push_back({.frame = frame, .wallTime = wall, .echo = true, .local = true});
    }
};

class FakeSocket final : public CanSocket {
public:
    explicit FakeSocket(Kernel& kernel) : kernel_(kernel), incarnation_(++kernel.opened) {}
    ~FakeSocket() override { ++kernel_.closed; }

    Result<Reading> read(std::span<BusFrame> frames, double patience) override
    {
        ++kernel_.reads;
        if (const int code = std::exchange(kernel_.readError, 0)) return Error{"trouble", code};
        if (kernel_.queue.empty()) kernel_.pass(patience);
        Reading reading;
        for (; reading.frames < frames.size() && !kernel_.queue.empty(); ++reading.frames) {
            frames[reading.frames] = kernel_.queue.front();
            kernel_.queue.pop_front();
        }
        reading.emptied = reading.frames < frames.size();
        return reading;
    }
    Status write(const CanFrame& frame) override
    {
        if (kernel_.writeError) return Error{"trouble", kernel_.writeError};
        kernel_.written.push_back(frame);
        return Done{};
    }
    Link link() const override
    {
        if (!kernel_.present || incarnation_ != kernel_.opened) return Link::Gone;
        return kernel_.up ? Link::Up : Link::Down;
    }
    std::uint64_t drops() const override { return kernel_.drops; }
    std::size_t receiveBuffer() const override { return kernel_.buffer; }

private:
    Kernel& kernel_;
    int incarnation_;
};

inline SocketCan::System systemOf(Kernel& kernel)
{
    return {.openSocket = [&kernel]() -> Result<std::unique_ptr<CanSocket>> {
                if (kernel.noSocket) return Error{"can0: trouble", kernel.noSocket};
                if (!kernel.present) return Error{"can0: absent", ENODEV};
                return std::unique_ptr<CanSocket>(std::make_unique<FakeSocket>(kernel));
            },
            .steadyTime = [&kernel] { return kernel.now; },
            .wallTime = [&kernel] { return kernel.wall; },
            .sleep =
                [&kernel](double seconds) {
                    kernel.pass(seconds);
                    ++kernel.naps;
                }};
}

inline std::unique_ptr<SocketCan> opened(Kernel& kernel, SocketCan::Options options = {
                                                             .interface = "can0", .transmit = true})
{
    options.interface = "can0";
    auto bus = SocketCan::open(options, systemOf(kernel));
    if (!bus) throw std::runtime_error(bus.error().text);
    return *std::move(bus);
}

struct OnABus : testing::Test {
    Kernel kernel;
    std::unique_ptr<SocketCan> bus = opened(kernel);
    std::array<BusFrame, 8> frames{};

    std::size_t receive(std::chrono::milliseconds patience = std::chrono::milliseconds(0))
    {
        const auto count = bus->receive(frames, patience);
        EXPECT_TRUE(count) << count.error().text;
        return count ? *count : 0;
    }
    std::string refusal(std::uint32_t id = 9)
    {
        const Status sent = bus->send(frameOfId(id));
        return sent ? std::string() : sent.error().text;
    }
};

}  // namespace terratact
