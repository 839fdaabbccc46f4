#pragma once

#include <cstdint>
#include <optional>

#include "core/base/message.h"

namespace terratact {

/// State of a robot's telemetry.
enum class LinkStanding : std::uint8_t {
    Silent,  ///< no telemetry has come yet
    Up,
    Lost,      ///< no telemetry, or it has only just come back
    Unsteady,  ///< telemetry has repeated gaps
    Ended,     ///< the log has ended
};

/// Account of the link for every text that mentions it.
struct LinkAccount {
    LinkStanding standing = LinkStanding::Silent;
    bool alive = false;    ///< telemetry is fresh: values may be shown in any state
    bool alone = false;    ///< only telemetry is missing: other frames of the robot come
    int gaps = 0;          ///< gaps since the link was last Up; for a link that is Up, before that
    double longest = 0.0;  ///< longest of these gaps [s]
    bool operator==(const LinkAccount&) const = default;
};

/// Returns "link lost" or "telemetry unsteady".
SourceText describe(const LinkAccount& link);

/// Observation of the link at one time.
struct LinkGlimpse {
    double now = 0.0;             ///< [s] any monotonic clock
    std::optional<double> age{};  ///< age of the newest telemetry [s]; empty: none has come yet
    bool alive = false;           ///< the newest telemetry is fresh
    bool othersCome = false;      ///< other frames of the robot come
    bool ended = false;           ///< the log has ended
};

/// Keeps account of the link. The link is lost at once, and up again only after steady telemetry.
/// An unsteady link is therefore one event and not many.
class LinkWatch {
public:
    /// [s] without a gap after which the link is up again
    static constexpr double kSteadyAfter = 1.0;
    static constexpr double kMaxGap = 1.0;  ///< [s] longest silence that is not a loss

    /// Updates the account. Call it several times a second. Throws std::invalid_argument for times
    /// that are not finite.
    const LinkAccount& poll(const LinkGlimpse& seen);
    const LinkAccount& account() const { return account_; }

private:
    void hear(double now);
    void miss(const LinkGlimpse& seen);

    LinkAccount account_;
    double backSince_ = 0.0;  ///< [s]
};

}  // namespace terratact
