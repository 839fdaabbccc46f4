#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <stdexcept>

namespace terratact {

/// Tells telemetry of now from a replay with right checksums and counters: the robot answers each console
/// heartbeat with its token.  A recording cannot answer what was not asked then.
class Freshness {
public:
    /// A heartbeat with this token left at `now` [s].
    void sent(std::uint16_t token, double now)
    {
        if (!std::isfinite(now)) throw std::invalid_argument("Freshness: the time must be finite");
        asked_[next_] = Asked{.token = token, .time = now, .before = false};
        next_ = (next_ + 1) % asked_.size();
    }

    /// A sound RobotHeartbeat brought this token; false: it answers none of the last four.
    bool echoed(std::uint16_t token)
    {
        for (const std::optional<Asked>& asked : asked_) {
            if (!asked || asked->token != token) continue;
            if (!answered_ || asked->time > *answered_) answered_ = asked->time;
            return true;
        }
        return false;
    }

    /// What is sent from here on is told from what has been sent: see answersAnew().
    void beginAnew()
    {
        for (std::optional<Asked>& asked : asked_)
            if (asked) asked->before = true;
    }
    /// Whether this token left after the last beginAnew() and is one of the last four.
    bool answersAnew(std::uint16_t token) const
    {
        return std::ranges::any_of(asked_, [token](const std::optional<Asked>& asked) {
            return asked && !asked->before && asked->token == token;
        });
    }

    /// How long ago the newest heartbeat that has been answered left [s]; empty before the first.
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
