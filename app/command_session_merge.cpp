#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <tuple>

#include "app/session_commands.h"
#include "app/session_text.h"
#include "core/file_read.h"
#include "core/log/session_writer.h"

namespace terratact {

namespace {

constexpr std::int64_t kMostApart = std::int64_t{86'400} * 31 * 1'000'000'000;  // [ns]

/// Writes the rows of several sessions into a new one: ids anew, times since the first one's start.
class Merger {
public:
    explicit Merger(SessionWriter& writer, std::int64_t wallTime)
        : writer_(writer), wallTime_(wallTime)
    {
    }

    Status add(SessionReader& session)
    {
        // Rotated files have their start in common, later ones repeat what stood when they began.
        session_ = &session;
        toldBefore_.merge(told_);
        shift_ = session.start().wallTime - wallTime_;
        ids_ = {};
        const SessionVerification found = session.verify();
        if (Status told = tell(found); !told) return told;
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

private:
    struct Ids {
        std::map<std::int64_t, std::int64_t> model, scene, estimate, proposal;
        std::size_t modelsRead = 0, scenesRead = 0, estimatesRead = 0, proposalsRead = 0,
                    eventsRead = 0;
    };

    using Told = std::tuple<SessionTime, EventKind, std::string, std::string>;

    Status tell(const SessionVerification& found)
    {
        const std::string damaged =
            found.damage.empty()
                ? ""
                : fmt::format(", {} batches of which are not what was recorded and left out",
                              found.damage.size());
        return event(
            {.time = session_->begin(),
             .kind = EventKind::Session,
             .subject = "merged",
             .text = fmt::format("from {}, {} frames, last link {}{}",
                                 std::filesystem::path(session_->path()).filename().string(),
                                 found.frames, found.chain, damaged)});
    }

    Status event(EventRow row)
    {
        row.id = ++lastEvent_;
        row.time += shift_;
        return writer_.add(row);
    }

    Status addRowsUntil(SessionTime time)
    {
        const auto each = [&](const auto& rows, std::size_t& read, const auto& take) -> Status {
            for (; read < rows.size() && rows[read].time <= time; ++read)
                if (Status added = take(rows[read]); !added) return added;
            return Done{};
        };
        SessionReader& s = *session_;
        Status status =
            each(s.models(), ids_.modelsRead, [&](const ModelRow& r) { return take(r); });
        if (status)
            status = each(s.scenes(), ids_.scenesRead, [&](const SceneRow& r) { return take(r); });
        if (status)
            status = each(s.estimates(), ids_.estimatesRead,
                          [&](const EstimateRow& r) { return take(r); });
        if (status)
            status = each(s.proposals(), ids_.proposalsRead,
                          [&](const ProposalRow& r) { return take(r); });
        if (status)
            status = each(s.events(), ids_.eventsRead, [&](const EventRow& r) { return take(r); });
        return status;
    }

    /// Where an equal row is there already, its id; else adds it.
    template <class RowType>
    Status keep(RowType row, std::int64_t old, std::map<std::int64_t, std::int64_t>& ids,
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

    Status take(ModelRow row)
    {
        if (ids_.model.contains(row.id)) return Done{};
        row.time += shift_;
        return keep(row, row.id, ids_.model, models_);
    }

    Status take(SceneRow row)
    {
        if (ids_.scene.contains(row.id)) return Done{};
        row.time += shift_;
        return keep(row, row.id, ids_.scene, scenes_);
    }

    Status take(EstimateRow row)
    {
        if (ids_.estimate.contains(row.id)) return Done{};
        if (Status there = require(row); !there) return there;
        auto draws = session_->draws(row.id);
        if (!draws) return draws.error();
        row.time += shift_;
        row.scene = ids_.scene.at(row.scene);
        row.model = ids_.model.at(row.model);
        const std::int64_t old = row.id;
        // Draws are many: equal but for them is equal.
        const auto same =
            std::find_if(estimates_.begin(), estimates_.end(), [&](const EstimateRow& o) {
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
        row.estimate.draws = std::move(*draws);
        return writer_.add(row);
    }

    Status take(ProposalRow row)
    {
        if (ids_.proposal.contains(row.id)) return Done{};
        if (Status there = requireEstimate(row.estimate); !there) return there;
        row.time += shift_;
        row.estimate = ids_.estimate.at(row.estimate);
        return keep(row, row.id, ids_.proposal, proposals_);
    }

    Status take(EventRow row)
    {
        const Told told{row.time + shift_, row.kind, row.subject, row.text};
        if (toldBefore_.contains(told)) return Done{};
        told_.insert(told);
        if (row.estimate != 0)
            if (Status there = requireEstimate(row.estimate); !there) return there;
        if (row.proposal != 0) {
            const ProposalRow* proposal = session_->proposal(row.proposal);
            if (!proposal) return missing("an event", "proposal");
            if (Status there = take(*proposal); !there) return there;
            row.proposal = ids_.proposal.at(row.proposal);
        }
        if (row.estimate != 0) row.estimate = ids_.estimate.at(row.estimate);
        return event(row);
    }

    /// What an estimate rests on, though it may be later by the clock.
    Status require(const EstimateRow& row)
    {
        const SceneRow* scene = session_->scene(row.scene);
        const ModelRow* model = session_->model(row.model);
        if (!scene) return missing("an estimate", "scene");
        if (!model) return missing("an estimate", "model");
        if (Status there = take(*model); !there) return there;
        return take(*scene);
    }

    Status requireEstimate(std::int64_t id)
    {
        const EstimateRow* estimate = session_->estimate(id);
        return estimate ? take(*estimate) : missing("a row", "estimate");
    }

    Status missing(const char* what, const char* whose) const
    {
        return fileError(session_->path(), fmt::format("{} refers to a {} that is damaged: it "
                                                       "cannot be merged",
                                                       what, whose));
    }

    SessionWriter& writer_;
    std::int64_t wallTime_;
    SessionReader* session_ = nullptr;
    SessionTime shift_ = 0;
    Ids ids_;
    std::int64_t lastEvent_ = 0;
    std::set<Told> told_, toldBefore_;  ///< events of this session, of those before it
    std::vector<ModelRow> models_;
    std::vector<SceneRow> scenes_;
    std::vector<EstimateRow> estimates_;  ///< without their draws
    std::vector<ProposalRow> proposals_;
};

/// [ns] since 1970, of the first and the last frame; of the first row where there is none.
std::pair<std::int64_t, std::int64_t> frameSpan(SessionReader& session)
{
    std::optional<SessionTime> first;
    SessionTime last = session.begin();
    for (std::size_t i = 0; i < session.batches().size(); ++i)
        if (session.batches()[i].frameCount > 0) {
            if (const auto frames = session.frames(i); !frames.empty()) {
                if (!first) first = frames.front().time;
                last = frames.back().time;
            }
        }
    return {wallTimeOf(session.start(), first.value_or(session.begin())),
            wallTimeOf(session.start(), last)};
}

Status requireAlike(const SessionReader& a, const SessionReader& b)
{
    if (a.start().robot != b.start().robot)
        return fileError(b.path(), "is of another robot than " + a.path());
    if (a.start().bus != b.start().bus || a.start().source != b.start().source)
        return fileError(b.path(),
                         fmt::format("is of {} on {}, and {} is of {} on {}", b.start().source,
                                     b.start().bus, a.path(), a.start().source, a.start().bus));
    return Done{};
}

}  // namespace

Status mergeSessions(const SessionMergeOptions& options)
{
    struct Part {
        SessionReader reader;
        std::int64_t first, last;  ///< [ns] since 1970, of its frames
    };
    std::vector<Part> parts;
    for (const std::string& file : options.files) {
        auto session = SessionReader::open(file);
        if (!session) return session.error();
        const auto [first, last] = frameSpan(*session);
        parts.push_back({std::move(*session), first, last});
    }
    std::sort(parts.begin(), parts.end(),
              [](const Part& a, const Part& b) { return a.first < b.first; });
    std::int64_t wallTime = parts.front().reader.start().wallTime;
    SessionStart start = parts.front().reader.start();
    for (std::size_t k = 1; k < parts.size(); ++k) {
        const Part &before = parts[k - 1], &part = parts[k];
        if (Status alike = requireAlike(before.reader, part.reader); !alike) return alike;
        if (part.first < before.last)
            return fileError(
                part.reader.path(),
                fmt::format("begins at {}, before {} ends at {}: sessions that overlap "
                            "are not one drive",
                            utcText(part.first), before.reader.path(), utcText(before.last)));
        if (part.first - before.last > kMostApart
            || std::abs(part.reader.start().wallTime - before.reader.start().wallTime) > kMostApart)
            return fileError(part.reader.path(),
                             "was recorded more than a month apart from " + before.reader.path());
        start.transmits = start.transmits || part.reader.start().transmits;
        wallTime = std::min(wallTime, part.reader.start().wallTime);
    }
    start.wallTime = wallTime;
    auto writer = SessionWriter::create(options.out, start);
    if (!writer) return writer.error();
    Merger merger(*writer, wallTime);
    Status status = Done{};
    for (Part& part : parts)
        if (status) status = merger.add(part.reader);
    if (status) status = writer->seal();
    if (!status) {
        std::error_code ignored;
        for (const char* suffix : {"", "-wal", "-shm"})
            std::filesystem::remove(options.out + suffix, ignored);
        return status;
    }
    fmt::print("{} sessions, {} frames merged into {}; last link {}\n", parts.size(),
               writer->frames(), options.out, writer->chain());
    return Done{};
}

}  // namespace terratact
