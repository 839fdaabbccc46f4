#pragma once

#include <cerrno>
#include <deque>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "drivers/gpio_lines.h"

namespace terratact {

/// A GPIO chip with levels set by the test. Like the kernel with libgpiod 1 it keeps 16 edges of each input and drops
/// newer ones. It must outlive the lines it opens.
class FakeGpioChip {
public:
    static constexpr std::size_t kFifo = 16;

    /// Behaves like openGpioLines(); fails while the chip is gone.
    Result<std::unique_ptr<GpioLines>> open(const GpioRequest& request)
    {
        ++openings;
        if (gone) return Error{"no GPIO chip labelled fake", ENODEV};
        request_ = request;
        active_.resize(request.inputs.size(), false);
        fifos_.assign(request.inputs.size(), {});
        outputs.assign(request.outputs.size(), false);
        writes.clear();
        ++held;
        return std::unique_ptr<GpioLines>(std::make_unique<Lines>(*this));
    }

    /// Sets an input; a change of level makes an edge.
    void move(std::size_t input, bool active, double time = 0.0)
    {
        if (active_.size() <= input) active_.resize(input + 1, false);
        if (active_[input] == active) return;
        active_[input] = active;
        if (input >= fifos_.size()) return;  // no lines are open yet
        if (fifos_[input].size() < kFifo)
            fifos_[input].push_back({.input = input, .active = active, .time = time});
        else
            ++dropped;
    }

    const GpioRequest& request() const { return request_; }

    bool gone = false;       ///< every call fails with ENODEV
    bool loseEdges = false;  ///< the next read reports lost edges
    int setError = 0;        ///< errno of set()
    int openings = 0;        ///< attempts to open
    int held = 0;            ///< lines open now
    int dropped = 0;         ///< dropped edges
    std::vector<bool> outputs;
    std::vector<std::pair<std::size_t, bool>> writes;  ///< writes since the lines were opened

private:
    class Lines final : public GpioLines {
    public:
        explicit Lines(FakeGpioChip& chip) : chip_(chip) {}
        ~Lines() override { --chip_.held; }

        const GpioFound& found() const override { return found_; }

        Result<GpioEdges> readEdges(std::chrono::milliseconds /*patience*/) override
        {
            if (chip_.gone) return vanished();
            GpioEdges edges;
            edges.lost = std::exchange(chip_.loseEdges, false);
            for (auto& fifo : chip_.fifos_) {
                edges.edges.insert(edges.edges.end(), fifo.begin(), fifo.end());
                fifo.clear();
            }
            return edges;
        }

        Result<std::vector<bool>> levels() override
        {
            if (chip_.gone) return vanished();
            return chip_.active_;
        }

        Status set(std::size_t output, bool active) override
        {
            if (chip_.gone) return vanished();
            if (chip_.setError != 0) return Error{"fake: input/output error", chip_.setError};
            chip_.outputs.at(output) = active;
            chip_.writes.emplace_back(output, active);
            return Done{};
        }

    private:
        static Error vanished() { return {"gpiochip0 [fake]: the chip is gone", ENODEV}; }

        FakeGpioChip& chip_;
        GpioFound found_{.path = "/dev/gpiochip0",
                         .chip = "gpiochip0",
                         .label = "fake",
                         .lines = 8,
                         .inputs = {},
                         .outputs = {}};
    };

    GpioRequest request_;
    std::vector<bool> active_;
    std::vector<std::deque<GpioEdge>> fifos_;
};

}  // namespace terratact
