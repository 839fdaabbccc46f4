#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <thread>

#include "drivers/gamepad.h"

namespace terratact {

/// Controls of a fake gamepad that the test moves, from another thread than its reader's.
class GamepadDesk {
public:
    /// Returns a gamepad that reports what the desk shows.
    std::unique_ptr<Gamepad> gamepad() { return std::make_unique<Reported>(*this); }
    void set(const GamepadState& state)
    {
        const std::scoped_lock lock(mutex_);
        state_ = state;
    }
    /// Makes polls block while it hangs.
    void hang(bool hangs) { hangs_ = hangs; }
    /// Makes every following poll throw.
    void breakDown() { broken_ = true; }
    /// Number of finished polls.
    int polls() const { return polls_; }

private:
    class Reported final : public Gamepad {
    public:
        explicit Reported(GamepadDesk& desk) : desk_(desk) {}
        GamepadState poll(std::chrono::milliseconds /*pause*/) override
        {
            do {
                std::this_thread::sleep_for(std::chrono::milliseconds(1));
            } while (desk_.hangs_);
            ++desk_.polls_;
            if (desk_.broken_) throw std::runtime_error("the gamepad is on fire");
            const std::scoped_lock lock(desk_.mutex_);
            return desk_.state_;
        }

    private:
        GamepadDesk& desk_;
    };

    std::atomic<bool> hangs_ = false, broken_ = false;
    std::atomic<int> polls_ = 0;
    std::mutex mutex_;  // guards the member below
    GamepadState state_;
};

}  // namespace terratact
