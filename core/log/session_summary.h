#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/infer/estimate/two_track_estimate.h"
#include "core/infer/verdict/verdict.h"
#include "core/log/rows/session_rows.h"

namespace terratact {

/// Whether a session was closed by its writer.
enum class SessionClosing : std::uint8_t {
    Sealed,  ///< closed by its writer, or recovered
    Open,    ///< still being recorded, or its program died; its journal is beside it
    Torn     ///< not closed, and its journal is missing or damaged: the end is not in the file
};
std::string_view name(SessionClosing closing);

/// Verdicts of the scenes of a session: one for each scene with an estimate, that of its last one.
struct SessionVerdicts {
    std::int64_t clear = 0, blocked = 0, cannotTell = 0;
    std::int64_t notRead = 0;  ///< older scenes beyond the limits of a summary, and damaged ones
    bool operator==(const SessionVerdicts&) const = default;
};

/// The last estimate of a session, without its draws.
struct LastEstimate {
    SessionTime time = 0;
    double stepLimit = 0.1;  ///< [m]
    TwoTrackEstimate estimate{};
    std::optional<StepVerdict> verdict{};  ///< empty: it could not be computed
    bool operator==(const LastEstimate&) const = default;
};

/// What a list of recordings shows of a session.
struct SessionSummary {
    static constexpr std::size_t kMaxJudged = 200;  ///< scenes whose verdict is computed
    static constexpr std::int64_t kMaxDrawBytes = std::int64_t{32} << 20U;  ///< bytes read for them
    static constexpr std::size_t kMaxNotes = 100;
    static constexpr std::size_t kMaxNoteBytes = 500;

    SessionClosing closing = SessionClosing::Sealed;
    std::int64_t wallTime = 0;         ///< time 0 in [ns] since 1970, UTC
    SessionTime begin = 0;             ///< time of the first batch with frames; 0: there is none
    SessionTime end = 0;               ///< time of the last row
    std::string program{};             ///< "terratact-console 0.1.0"
    std::string source{};              ///< "can0", "SIMULATED ROBOT"
    std::string robot{};               ///< name in the robot file; empty: it cannot be read
    std::int64_t frames = 0;           ///< number of frames
    std::int64_t scenes = 0;           ///< number of scenes
    std::int64_t estimates = 0;        ///< number of estimates
    std::int64_t proposals = 0;        ///< probes proposed
    std::int64_t probes = 0;           ///< probes approved by the operator
    std::int64_t alarms = 0;           ///< number of times that an alarm was raised
    std::int64_t marks = 0;            ///< marks of the operator, with a note or without
    std::vector<std::string> notes{};  ///< their notes, at most kMaxNotes, cut after kMaxNoteBytes
    SessionVerdicts verdicts{};
    std::optional<LastEstimate> last{};
    std::optional<Message> damage{};  ///< of its journal, or the first row that no session can hold
    bool operator==(const SessionSummary&) const = default;
};

/// Reads a summary of a session from an untrusted source. It has no frames. Of each scene it has the draws of the last
/// estimate. The cost grows with scenes and events, not with frames. The rows are checked, but not against the chain of
/// hashes: SessionReader proves them.
///
/// The file is opened read-only and no file is left beside it, even if it was not closed. Its writer
/// is not disturbed, also one of this process. A verdict is that of verdictOf() for the recorded
/// step limit. Silences and the sensor alarm between scene and estimate withhold it.
///
/// Errors name the file: it is no session, has another version, is truncated, or its tables cannot be
/// read. stop: ends the reading with an Error.
Result<SessionSummary> summarizeSession(const std::string& path, const std::stop_token& stop = {});

}  // namespace terratact
