#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/message.h"
#include "core/infer/estimate/two_track_estimate.h"
#include "core/robot/measurement.h"
#include "core/terrain/bins.h"
#include "core/trail/trail_history.h"
#include "core/wire/can_frame.h"

namespace terratact {

// Rows of a session (docs/sessions.md) as plain values. Times are nanoseconds on the steady clock
// since the session's start. SessionStart::wallTime maps them to the calendar. Ids count from 1
// within their table; 0 means none.

using SessionTime = std::int64_t;  ///< [ns]

/// Largest distance of a row from the session's begin: 36 years.
inline constexpr SessionTime kMaxSessionTime = std::int64_t{1} << 60U;

/// Returns seconds, as used by the program's clocks.
constexpr double secondsOf(SessionTime time)
{
    return static_cast<double>(time) * 1e-9;
}
constexpr SessionTime sessionTimeOf(double seconds)
{
    return static_cast<SessionTime>(seconds * 1e9 + (seconds < 0.0 ? -0.5 : 0.5));
}

/// Facts that hold from the start of the session.
struct SessionStart {
    std::int64_t wallTime = 0;  ///< time 0 in [ns] since 1970, UTC
    std::string program{};      ///< "terratact-console 0.1.0"
    std::string source{};       ///< source as shown to the operator: "can0", "SIMULATED ROBOT"
    std::string bus{};          ///< name of channel 0: "can0"
    bool transmits = false;     ///< commands could be sent
    std::string robot{};        ///< whole text of the robot file
    std::string robotHash{};    ///< SHA-256 of the robot file, 64 hexadecimal digits
    bool operator==(const SessionStart&) const = default;
};

struct FrameRow {
    SessionTime time = 0;  ///< time at which the kernel received it
    CanFrame frame{};
    bool sent = false;   ///< this console sent it
    bool local = false;  ///< a process of the console's computer sent it
    bool operator==(const FrameRow&) const = default;
};

/// Model that came into use.
struct ModelRow {
    std::int64_t id = 0;
    SessionTime time = 0;
    std::string name{};       ///< "default.ttm"
    std::string hash{};       ///< SHA-256 of its file
    std::string details{};    ///< model card
    std::string trailName{};  ///< "default.ttn": networks of the method trail; empty: none
    std::string trailHash{};  ///< SHA-256 of their file
    bool operator==(const ModelRow&) const = default;
};

/// Scene that was captured for an estimate.
struct SceneRow {
    std::int64_t id = 0;
    SessionTime time = 0;
    Measurement measurement{};
    std::optional<Heights> truth{};  ///< true heights, if the source knows them
    /// True heights of each side: left, right (sideHeights(), core/terrain/ground_lines.h).
    std::optional<std::array<Heights, 2>> sideTruth{};
    /// Memory of the way before the scene; empty: nothing was recorded, or nothing was known.
    std::optional<TrailHistory> memory{};
    bool operator==(const SceneRow&) const = default;
};

/// Role of an estimate among those of its scene.
enum class EstimateRole : std::uint8_t {
    First,
    Again,  ///< repeated with another reading of the arm
    Second  ///< computed by the other method, shown beside the first
};
std::string_view name(EstimateRole role);
std::optional<EstimateRole> estimateRoleFromName(std::string_view text);

/// Estimate as it was shown. Scene, readings, settings, robot and model reproduce it. Its last bits
/// may differ on another processor or in another version. Both sides have the same settings and the
/// same number of draws. Both sides of an estimate of one plane are equal.
struct EstimateRow {
    std::int64_t id = 0;
    SessionTime time = 0;
    std::int64_t scene = 0, model = 0;
    EstimateRole role = EstimateRole::First;
    double seconds = 0.0;                ///< computing time [s]
    double stepLimit = 0.1;              ///< step limit [m]
    std::vector<ArmReading> readings{};  ///< readings of the arm, in the order of their use
    TwoTrackEstimate estimate{};
    bool operator==(const EstimateRow&) const = default;
};

/// Draws of both sides: left, right. Draw k of both sides is one joint draw.
using SideDraws = std::array<std::vector<Heights>, 2>;

inline void setDraws(TwoTrackEstimate& estimate, SideDraws draws)
{
    for (std::size_t side = 0; side < 2; ++side)
        estimate.side.at(side).draws = std::move(draws.at(side));
}

/// Expected gain of touching one bin of one side.
struct OfferedBin {
    int bin = 0;
    double varianceShare = 0.0, bitsAfter = 0.0;
    ProbeSide side = ProbeSide::Middle;
    bool operator==(const OfferedBin&) const = default;
};

/// Probe that was proposed to the operator, with the numbers on its card.
struct ProposalRow {
    std::int64_t id = 0;
    SessionTime time = 0;
    std::int64_t estimate = 0;
    int bin = 0;
    ProbeSide side = ProbeSide::Middle;
    double height = 0.0, q10 = 0.0, q90 = 0.0, sd = 0.0;  ///< [m]
    double limit = 0.0;       ///< probe threshold: sd above which the arm is proposed [m]
    double armSd = 0.0;       ///< [m]
    double seconds = 0.0;     ///< expected duration [s]
    double stepLimit = 0.0;   ///< step limit of the question [m]
    double bitsBefore = 0.0;  ///< entropy of the question [bit]
    std::string grounds{};    ///< fingerprint of its grounds (core/atem/probe/probe_grounds.h)
    /// Gains of the bins: that of `bin` and `side` first if the method could compute it, then the
    /// others.
    std::vector<OfferedBin> offers{};
    bool operator==(const ProposalRow&) const = default;
};

/// Kind of an event. The file holds its name.
enum class EventKind : std::uint8_t {
    Word,      ///< line in the console's event list; subject: note, doubt, bad
    Decision,  ///< action of the operator; subject: which; shown: the numbers on the screen
    /// Phase of the exploration; subject: its name; text: the name of the failure, where it failed.
    Phase,
    Arming,  ///< arming; subject: name of its phase; text: name of the cause, where it is disarmed
    /// Link state; subject: kLinkUp, kLinkLost, kTelemetryLost. number: with kLinkUp, the longest
    /// silence [s].
    Link,
    Forgotten,  ///< the estimate is not valid any more; text: why
    /// a silence longer than kMaxSilence since the scene, or since the last estimate was left
    TelemetryGap,
    Override,  ///< text: what the operator overrides since this event; empty: nothing
    Alarm,     ///< subject: its id; text; number: 0 gone, 1 returned, 2 acknowledged, 3 raised
    Panel,     ///< contact of the operator's panel; subject: which; number: 1 closed, 0 open
    Marker,    ///< marker that the operator set; text: a note
    Gap,       ///< frames that are missing in the file; number: how many; text: why
    Session    ///< subject: begun, ended, recovered, continued
};
inline constexpr int kEventKinds = 13;
inline constexpr std::string_view kLinkUp = "up", kLinkLost = "lost",
                                  kTelemetryLost = "telemetry lost";  ///< other frames came
std::string_view name(EventKind kind);
std::optional<EventKind> eventKindFromName(std::string_view text);

struct EventRow {
    std::int64_t id = 0;
    SessionTime time = 0;
    EventKind kind = EventKind::Word;
    std::string subject{}, text{};
    std::optional<double> number{};
    std::int64_t estimate = 0,
                 proposal = 0;  ///< rows that it refers to, or 0
    std::string shown{};        ///< text on the screen at that time
    /// `text` and `shown` in parts, for translation; empty: only the text is known.
    Message message{}, screen{};
    bool operator==(const EventRow&) const = default;
};

}  // namespace terratact
