#pragma once

#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <cstddef>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

#include "app/runtime/steady_now.h"
#include "core/atem/panel.h"
#include "drivers/gpio_lines.h"

namespace terratact {

/// A fake panel: the test closes contacts and reads lamps, from another thread than the panel's.
class PanelBoard {
public:
    void close(PanelContact contact, bool closed)
    {
        const std::scoped_lock lock(mutex_);
        closed_[contact] = closed;
        edges_.edges.push_back(
            {.input = static_cast<std::size_t>(contact), .active = closed, .time = steadyNow()});
    }
    void unplug()
    {
        const std::scoped_lock lock(mutex_);
        gone_ = true;
    }
    void plugIn()
    {
        const std::scoped_lock lock(mutex_);
        gone_ = false;
    }
    /// Makes reads block while it hangs.
    void hang(bool hangs) { hangs_ = hangs; }
    /// Makes every following read throw.
    void breakDown()
    {
        const std::scoped_lock lock(mutex_);
        broken_ = true;
    }
    bool lit(std::size_t lamp) const
    {
        const std::scoped_lock lock(mutex_);
        return lit_.at(lamp);
    }
    Result<std::unique_ptr<GpioLines>> open()
    {
        const std::scoped_lock lock(mutex_);
        if (gone_) return Error{"no such chip", ENODEV};
        return std::unique_ptr<GpioLines>(std::make_unique<Lines>(*this));
    }

private:
    class Lines final : public GpioLines {
    public:
        explicit Lines(PanelBoard& board) : board_(board) {}
        const GpioFound& found() const override { return found_; }
        Result<GpioEdges> readEdges(std::chrono::milliseconds /*patience*/) override
        {
            do {
                std::this_thread::sleep_for(std::chrono::milliseconds(2));
            } while (board_.hangs_);
            const std::scoped_lock lock(board_.mutex_);
            if (board_.broken_) throw std::runtime_error("the board is on fire");
            if (board_.gone_) return Error{"the chip is gone", ENODEV};
            return std::exchange(board_.edges_, {});
        }
        Result<std::vector<bool>> levels() override
        {
            const std::scoped_lock lock(board_.mutex_);
            if (board_.gone_) return Error{"the chip is gone", ENODEV};
            return std::vector<bool>(board_.closed_.values.begin(), board_.closed_.values.end());
        }
        Status set(std::size_t output, bool active) override
        {
            const std::scoped_lock lock(board_.mutex_);
            board_.lit_.at(output) = active;
            return Done{};
        }

    private:
        PanelBoard& board_;
        GpioFound found_;
    };

    std::atomic<bool> hangs_ = false;
    mutable std::mutex mutex_;                                        // guards the members below
    PerContact<bool> closed_{.values = {false, false, false, true}};  // STOP is normally closed
    GpioEdges edges_;
    std::array<bool, kPanelOutputs> lit_{};
    bool gone_ = false, broken_ = false;
};

}  // namespace terratact
