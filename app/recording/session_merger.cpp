#include "app/recording/session_merger.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/store/file_read.h"

namespace terratact {

SessionMerger::SessionMerger(SessionWriter& writer, std::int64_t wallTime, Dangling dangling)
    : writer_(writer), wallTime_(wallTime), dangling_(dangling)
{
}

Status SessionMerger::add(SessionReader& session)
{
    // Rotated files share their start; each repeats the state at its beginning.
    session_ = &session;
    eventsBefore_.merge(events_);
    shift_ = session.start().wallTime - wallTime_;
    ids_ = {};
    for (std::size_t i = 0; i < session.batches().size(); ++i) {
        for (FrameRow frame : session.frames(i)) {
            frame.time += shift_;
            if (Status added = writer_.add(frame); !added) return added;
        }
        if (Status added = addRowsUntil(session.batches()[i].last); !added) return added;
        if (Status done = writer_.commit(); !done) return done;
    }
    return addRowsUntil(session.end());
}

Status SessionMerger::event(const SessionReader& session, EventRow row)
{
    row.time += session.start().wallTime - wallTime_;
    return writer_.add(row);
}

template <class Rows>
Status SessionMerger::addUntil(SessionTime time, const Rows& rows, std::size_t& read)
{
    for (; read < rows.size() && rows[read].time <= time; ++read) {
        dangles_ = false;
        Status added = add(rows[read]);
        if (added) continue;
        if (!dangles_ || dangling_ == Dangling::Refused) return added;
        ++leftOut_;
    }
    return Done{};
}

Status SessionMerger::addRowsUntil(SessionTime time)
{
    const SessionReader& s = *session_;
    Status status = addUntil(time, s.models(), ids_.modelsRead);
    if (status) status = addUntil(time, s.scenes(), ids_.scenesRead);
    if (status) status = addUntil(time, s.estimates(), ids_.estimatesRead);
    if (status) status = addUntil(time, s.proposals(), ids_.proposalsRead);
    if (status) status = addUntil(time, s.events(), ids_.eventsRead);
    return status;
}

/// Maps the row's id to that of an equal earlier row; adds the row if there is none.
template <class RowType>
Status SessionMerger::keep(RowType row, std::int64_t old, std::map<std::int64_t, std::int64_t>& ids,
                           std::vector<RowType>& kept)
{
    const auto same = std::find_if(kept.begin(), kept.end(), [&](const RowType& other) {
        row.id = other.id;
        return other == row;
    });
    if (same != kept.end()) {
        ids[old] = same->id;
        return Done{};
    }
    row.id = static_cast<std::int64_t>(kept.size()) + 1;
    ids[old] = row.id;
    kept.push_back(row);
    return writer_.add(row);
}

Status SessionMerger::add(ModelRow row)
{
    if (ids_.model.contains(row.id)) return Done{};
    row.time += shift_;
    return keep(row, row.id, ids_.model, models_);
}

Status SessionMerger::add(SceneRow row)
{
    if (ids_.scene.contains(row.id)) return Done{};
    row.time += shift_;
    return keep(row, row.id, ids_.scene, scenes_);
}

Status SessionMerger::add(EstimateRow row)
{
    if (ids_.estimate.contains(row.id)) return Done{};
    if (Status there = require(row); !there) return there;
    auto draws = session_->draws(row.id);
    if (!draws) {
        dangles_ = true;
        return draws.error();
    }
    row.time += shift_;
    row.scene = ids_.scene.at(row.scene);
    row.model = ids_.model.at(row.model);
    const std::int64_t old = row.id;
    // Draws are not compared, because there are many: estimates equal in all else count as equal.
    const auto same = std::find_if(estimates_.begin(), estimates_.end(), [&](const EstimateRow& o) {
        row.id = o.id;
        return o == row;
    });
    if (same != estimates_.end()) {
        ids_.estimate[old] = same->id;
        return Done{};
    }
    row.id = static_cast<std::int64_t>(estimates_.size()) + 1;
    ids_.estimate[old] = row.id;
    estimates_.push_back(row);
    setDraws(row.estimate, std::move(*draws));
    return writer_.add(row);
}

Status SessionMerger::add(ProposalRow row)
{
    if (ids_.proposal.contains(row.id)) return Done{};
    if (Status there = requireEstimate(row.estimate); !there) return there;
    row.time += shift_;
    row.estimate = ids_.estimate.at(row.estimate);
    return keep(row, row.id, ids_.proposal, proposals_);
}

Status SessionMerger::add(EventRow row)
{
    const EventKey key{row.time + shift_, row.kind, row.subject, row.text};
    if (eventsBefore_.contains(key)) return Done{};
    events_.insert(key);
    for (const bool estimates : {true, false}) {
        if (Status there = refer(row, estimates); !there) {
            if (!dangles_ || dangling_ == Dangling::Refused) return there;
            (estimates ? row.estimate : row.proposal) =
                0;  // the event is kept without the reference
        }
    }
    row.time += shift_;
    return writer_.add(row);
}

/// Replaces the event's reference to an estimate or a proposal by the new id.
Status SessionMerger::refer(EventRow& row, bool toEstimate)
{
    if ((toEstimate ? row.estimate : row.proposal) == 0) return Done{};
    if (toEstimate) {
        if (Status there = requireEstimate(row.estimate); !there) return there;
        row.estimate = ids_.estimate.at(row.estimate);
        return Done{};
    }
    const ProposalRow* proposal = session_->proposal(row.proposal);
    if (!proposal) return missing("an event", "proposal");
    if (Status there = add(*proposal); !there) return there;
    row.proposal = ids_.proposal.at(row.proposal);
    return Done{};
}

/// Adds the scene and model that an estimate refers to, even if their time is later.
Status SessionMerger::require(const EstimateRow& row)
{
    const SceneRow* scene = session_->scene(row.scene);
    const ModelRow* model = session_->model(row.model);
    if (!scene) return missing("an estimate", "scene");
    if (!model) return missing("an estimate", "model");
    if (Status there = add(*model); !there) return there;
    return add(*scene);
}

Status SessionMerger::requireEstimate(std::int64_t id)
{
    const EstimateRow* estimate = session_->estimate(id);
    return estimate ? add(*estimate) : missing("a row", "estimate");
}

Status SessionMerger::missing(const char* what, const char* whose)
{
    dangles_ = true;
    return fileError(session_->path(), fmt::format("{} refers to a {} that is damaged: it "
                                                   "cannot be merged",
                                                   what, whose));
}

}  // namespace terratact
