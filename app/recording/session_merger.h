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

/// Writes the rows of sessions into a new one: ids anew, times since the new one's start.  What a later one repeats
/// stands there once.
class SessionMerger {
public:
    /// What becomes of a row that refers to one which is damaged.
    enum class Dangling {
        Refused,  ///< an Error
        LeftOut   ///< events stay, without what they refer to
    };

    /// wallTime: [ns] since 1970, of the new session's time 0.
    SessionMerger(SessionWriter& writer, std::int64_t wallTime, Dangling dangling);

    /// All that is whole.
    Status add(SessionReader& session);

    /// An event of that session, in the new one.
    Status event(const SessionReader& session, EventRow row);

    std::int64_t leftOut() const { return leftOut_; }  ///< rows that refer to a damaged one

private:
    struct Ids {
        std::map<std::int64_t, std::int64_t> model, scene, estimate, proposal;
        std::size_t modelsRead = 0, scenesRead = 0, estimatesRead = 0, proposalsRead = 0,
                    eventsRead = 0;
    };
    using Told = std::tuple<SessionTime, EventKind, std::string, std::string>;

    Status addRowsUntil(SessionTime time);
    template <class Rows>
    Status addUntil(SessionTime time, const Rows& rows, std::size_t& read);
    template <class RowType>
    Status keep(RowType row, std::int64_t old, std::map<std::int64_t, std::int64_t>& ids,
                std::vector<RowType>& kept);
    Status take(ModelRow row);
    Status take(SceneRow row);
    Status take(EstimateRow row);
    Status take(ProposalRow row);
    Status take(EventRow row);
    Status refer(EventRow& row, bool toEstimate);
    Status require(const EstimateRow& row);
    Status requireEstimate(std::int64_t id);
    Status missing(const char* what, const char* whose);

    SessionWriter& writer_;
    std::int64_t wallTime_;
    Dangling dangling_;
    bool dangles_ = false;  ///< the row that is being taken
    std::int64_t leftOut_ = 0;
    SessionReader* session_ = nullptr;
    SessionTime shift_ = 0;
    Ids ids_;
    std::set<Told> told_, toldBefore_;  ///< events of this session, of those before it
    std::vector<ModelRow> models_;
    std::vector<SceneRow> scenes_;
    std::vector<EstimateRow> estimates_;  ///< without their draws
    std::vector<ProposalRow> proposals_;
};

}  // namespace terratact
