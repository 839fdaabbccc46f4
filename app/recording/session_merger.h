#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "core/base/result.h"
#include "core/log/session_reader.h"
#include "core/log/session_writer.h"

namespace terratact {

/// Merges the rows of sessions into a new one. It renumbers ids and converts times to the new session's start. Rows
/// that a later session repeats are written once.
class SessionMerger {
public:
    /// Handling of a row that refers to a damaged row.
    enum class Dangling {
        Refused,  ///< the row is an Error
        LeftOut   ///< events are kept without the reference; other rows are omitted
    };

    /// wallTime: time 0 of the new session [ns] since 1970.
    SessionMerger(SessionWriter& writer, std::int64_t wallTime, Dangling dangling);

    /// Adds all undamaged rows of a session.
    Status add(SessionReader& session);

    /// Adds an event of that session with renumbered references.
    Status event(const SessionReader& session, EventRow row);

    /// Returns the number of rows omitted because they refer to a damaged row.
    std::int64_t leftOut() const { return leftOut_; }

private:
    struct Ids {
        std::map<std::int64_t, std::int64_t> model, scene, estimate, proposal;
        std::size_t modelsRead = 0, scenesRead = 0, estimatesRead = 0, proposalsRead = 0,
                    eventsRead = 0;
    };
    using EventKey = std::tuple<SessionTime, EventKind, std::string, std::string>;

    Status addRowsUntil(SessionTime time);
    template <class Rows>
    Status addUntil(SessionTime time, const Rows& rows, std::size_t& read);
    template <class RowType>
    Status keep(RowType row, std::int64_t old, std::map<std::int64_t, std::int64_t>& ids,
                std::vector<RowType>& kept);
    Status add(ModelRow row);
    Status add(SceneRow row);
    Status add(EstimateRow row);
    Status add(ProposalRow row);
    Status add(EventRow row);
    Status refer(EventRow& row, bool toEstimate);
    Status require(const EstimateRow& row);
    Status requireEstimate(std::int64_t id);
    Status missing(const char* what, const char* whose);

    SessionWriter& writer_;
    std::int64_t wallTime_;
    Dangling dangling_;
    bool dangles_ = false;  ///< the current row refers to a damaged row
    std::int64_t leftOut_ = 0;
    SessionReader* session_ = nullptr;
    SessionTime shift_ = 0;
    Ids ids_;
    std::set<EventKey> events_, eventsBefore_;  ///< events of this session, and of earlier sessions
    std::vector<ModelRow> models_;
    std::vector<SceneRow> scenes_;
    std::vector<EstimateRow> estimates_;  ///< without draws
    std::vector<ProposalRow> proposals_;
};

}  // namespace terratact
