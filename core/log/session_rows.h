#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/infer/estimate/estimate.h"
#include "core/robot/measurement.h"
#include "core/terrain/bins.h"
#include "core/wire/can_frame.h"

namespace terratact {

// What a session keeps, row by row (docs/sessions.md).  Plain values.  Times are nanoseconds on the steady
// clock since the session's start, which SessionStart::wallTime puts into the calendar.  Identifiers count
// from 1 within their table; 0 is none.

using SessionTime = std::int64_t;  ///< [ns]

/// [s] as the clocks of the program have it.
constexpr double secondsOf(SessionTime time)
{
    return static_cast<double>(time) * 1e-9;
}
constexpr SessionTime sessionTimeOf(double seconds)
{
    return static_cast<SessionTime>(seconds * 1e9 + (seconds < 0.0 ? -0.5 : 0.5));
}

/// What was so from the beginning.
struct SessionStart {
    std::int64_t wallTime = 0;  ///< [ns] since 1970, UTC, of time 0
    std::string program{};      ///< "terratact-console 0.1.0"
    std::string source{};       ///< as the operator read it: "can0", "SIMULATED ROBOT"
    std::string bus{};          ///< name of channel 0: "can0"
    bool transmits = false;     ///< commands could be sent
    std::string robot{};        ///< the robot file, whole
    std::string robotHash{};    ///< SHA-256 of it, 64 hexadecimal digits
    bool operator==(const SessionStart&) const = default;
};

struct FrameRow {
    SessionTime time = 0;  ///< when the kernel received it
    CanFrame frame{};
    bool sent = false;   ///< by this console: it has left
    bool local = false;  ///< by a process of that computer
    bool operator==(const FrameRow&) const = default;
};

/// A model that came into use.
struct ModelRow {
    std::int64_t id = 0;
    SessionTime time = 0;
    std::string name{};     ///< "default.ttm"
    std::string hash{};     ///< SHA-256 of its file
    std::string details{};  ///< its card
    bool operator==(const ModelRow&) const = default;
};

/// A scene that was captured to be estimated.
struct SceneRow {
    std::int64_t id = 0;
    SessionTime time = 0;
    Measurement measurement{};
    std::optional<Heights> truth{};  ///< where the source knew it
    bool operator==(const SceneRow&) const = default;
};

/// Which of a scene's estimates it is.
enum class EstimateRole : std::uint8_t {
    First,
    Again,  ///< with another reading of the arm
    Second  ///< by the other method, beside the first
};
std::string_view name(EstimateRole role);
std::optional<EstimateRole> estimateRoleFromName(std::string_view text);

/// An estimate as it was shown.  Scene, readings, settings, robot and model bring it forth again, but for last bits on
/// another processor or by another version.
struct EstimateRow {
    std::int64_t id = 0;
    SessionTime time = 0;
    std::int64_t scene = 0, model = 0;
    EstimateRole role = EstimateRole::First;
    double seconds = 0.0;                ///< it took
    double stepLimit = 0.1;              ///< [m] what counted as an obstacle
    std::vector<ArmReading> readings{};  ///< of the arm, in the order in which they entered
    TerrainEstimate estimate{};
    bool operator==(const EstimateRow&) const = default;
};

/// What touching one bin was expected to buy.
struct OfferedBin {
    int bin = 0;
    double varianceShare = 0.0, bitsAfter = 0.0;
    bool operator==(const OfferedBin&) const = default;
};

/// A probe that was put to the operator, with the numbers on the card.
struct ProposalRow {
    std::int64_t id = 0;
    SessionTime time = 0;
    std::int64_t estimate = 0;
    int bin = 0;
    double height = 0.0, q10 = 0.0, q90 = 0.0, sd = 0.0;  ///< [m]
    double limit = 0.0;                                   ///< [m] sd that asks for the arm
    double armSd = 0.0;                                   ///< [m]
    double seconds = 0.0;                                 ///< it would cost
    double stepLimit = 0.0;                               ///< [m] of the question
    double bitsBefore = 0.0;                              ///< its entropy [bit]
    std::string grounds{};  ///< fingerprint of what it rested on (core/atem/probe_grounds.h)
    std::vector<OfferedBin>
        offers{};  ///< of `bin` first where the method could tell, then the others
    bool operator==(const ProposalRow&) const = default;
};

/// What an event is about.  In the file by name.
enum class EventKind : std::uint8_t {
    Word,      ///< a line of the console's list of events; subject: note, doubt, bad
    Decision,  ///< the operator did something; subject: what; shown: the numbers on the screen
    Phase,     ///< of the exploration; subject: its name
    Arming,    ///< subject: phase
    Link,  ///< subject: kLinkUp, kLinkLost, kTelemetryLost; number: of kLinkUp, the longest silence [s]
    Forgotten,  ///< the estimate no longer stands; text: why
    Unheard,  ///< since the scene, or the estimate that was left last, a silence of more than kMaxSilence
    Override,  ///< text: what the operator has overridden from now on; empty: nothing
    Alarm,  ///< subject: its identifier; text; number: 0 gone, 1 returned, 2 acknowledged, 3 raised
    Panel,  ///< a contact of the operator's panel; subject: which; number: 1 closed, 0 open
    Marker,  ///< set by the operator; text: a note
    Gap,     ///< frames that are not in the file; number: how many; text: why
    Session  ///< subject: begun, ended, recovered, continued
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
                 proposal = 0;  ///< that it refers to, or 0
    std::string shown{};        ///< what was on the screen, in words
    bool operator==(const EventRow&) const = default;
};

}  // namespace terratact
