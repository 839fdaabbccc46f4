#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "core/log/rows/session_rows.h"

namespace terratact {

/// The rows of a session besides frames.
using SessionRow = std::variant<ModelRow, SceneRow, EstimateRow, ProposalRow, EventRow>;

/// State of the recording at one time, written at the start of the next file. A reader of that file alone finds the
/// rows it refers to and the console's state.
class RecordingContext {
public:
    /// Adds a row of the recording, in order.
    void add(const SessionRow& row);

    /// Returns the rows that the next file needs. These are the model in use, and the newest scene with its estimates,
    /// proposals and answers. For arming, link, exploration and a forgotten estimate it returns the newest event. For
    /// each active alarm and panel contact it returns the newest event, too. An active override and a telemetry gap
    /// since the scene complete the state.
    std::vector<SessionRow> rows() const;

private:
    void addEvent(EventRow event);

    std::vector<SessionRow> ofScene_;  ///< the scene's rows, after the model's row
    std::map<std::pair<EventKind, std::string>, EventRow> standing_;
};

}  // namespace terratact
