#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <stdexcept>

namespace terratact {

/// Detects a replay of telemetry with right checksums and counters. The robot answers each console
/// heartbeat with its token. A recording cannot answer a new token.
class Freshness {
public:
    /// Records that a heartbeat with this token was sent at `now` [s].
    void sent(std::uint16_t token, double now)
    {
        if (!std::isfinite(now)) throw std::invalid_argument("Freshness: the time must be finite");
        asked_[next_] = Asked{.token = token, .time = now, .before = false};
        next_ = (next_ + 1) % asked_.size();
    }

    /// Records the token of a valid RobotHeartbeat. Returns false if it answers none of the last
    /// four heartbeats.
    bool echoed(std::uint16_t token)
    {
        for (const std::optional<Asked>& asked : asked_) {
            if (!asked || asked->token != token) continue;
            if (!answered_ || asked->time > *answered_) answered_ = asked->time;
            return true;
        }
        return false;
    }

    /// Separates earlier heartbeats from later ones, see answersAnew().
    void beginAnew()
    {
        for (std::optional<Asked>& asked : asked_)
            if (asked) asked->before = true;
    }
    /// Returns true if this token was sent after the last beginAnew() and is one of the last four.
    bool answersAnew(std::uint16_t token) const
    {
        return std::ranges::any_of(asked_, [token](const std::optional<Asked>& asked) {
            return asked && !asked->before && asked->token == token;
        });
    }

    /// Returns the age of the newest answered heartbeat [s]; empty before the first answer.
    std::optional<double> age(double now) const
    {
        return answered_ ? std::optional(now - *answered_) : std::nullopt;
    }

private:
    struct Asked {
        std::uint16_t token;
        double time;
        bool before;
    };
    std::array<std::optional<Asked>, 4> asked_{};
    std::size_t next_ = 0;
    std::optional<double> answered_;
};

}  // namespace terratact
