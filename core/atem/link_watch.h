#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace terratact {

/// How the telemetry of a robot arrives.
enum class LinkStanding : std::uint8_t {
    Silent,  ///< none has come yet
    Up,
    Lost,      ///< none comes, or only just again
    Unsteady,  ///< it comes and goes
    Ended,     ///< a log, which has no more of it
};

/// What a console knows of the link, and says wherever it speaks of it.
struct LinkAccount {
    LinkStanding standing = LinkStanding::Silent;
    bool alive = false;    ///< telemetry is fresh now: values may be shown, whatever the standing
    bool alone = false;    ///< only telemetry is missing: other frames of the robot come
    int gaps = 0;          ///< since it last was Up; of a link that is Up, before that
    double longest = 0.0;  ///< [s] of them
    bool operator==(const LinkAccount&) const = default;
};

/// "link lost", "telemetry unsteady".
std::string describe(const LinkAccount& link);

/// What there is to see of the link at one time.
struct LinkGlimpse {
    double now = 0.0;             ///< [s] any monotonic clock
    std::optional<double> age{};  ///< [s] of the newest telemetry; empty: none has come yet
    bool alive = false;           ///< that is fresh enough
    bool othersCome = false;      ///< other frames of the robot do
    bool ended = false;           ///< a log
};

/// Keeps account of the link.  It is lost at once, and up again only once telemetry has come for a while, so that one
/// that comes and goes is one trouble and not many.
class LinkWatch {
public:
    static constexpr double kSteadyAfter = 1.0;  ///< [s] it is up again after so long without a gap
    static constexpr double kMaxGap = 1.0;       ///< [s] a longer silence is a loss

    /// To be called several times a second.  Throws std::invalid_argument for times that are not finite.
    const LinkAccount& poll(const LinkGlimpse& seen);
    const LinkAccount& account() const { return account_; }

private:
    void hear(double now);
    void miss(const LinkGlimpse& seen);

    LinkAccount account_;
    double backSince_ = 0.0;  ///< [s]
};

}  // namespace terratact
