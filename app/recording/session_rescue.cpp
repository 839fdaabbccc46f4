#include "app/recording/session_rescue.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "app/recording/session_merger.h"
#include "app/recording/session_text.h"
#include "core/log/session_reader.h"
#include "core/log/session_salvage.h"
#include "core/store/file_read.h"

namespace terratact {
namespace {

/// A session file and SQLite's files beside it; the destructor removes them unless they are kept.
class UnfinishedSession {
public:
    explicit UnfinishedSession(std::string path) : path_(std::move(path)) {}
    ~UnfinishedSession()
    {
        std::error_code none;
        if (!kept_)
            for (const char* const end : {"", "-wal", "-shm"})
                std::filesystem::remove(path_ + end, none);
    }
    UnfinishedSession(const UnfinishedSession&) = delete;
    UnfinishedSession& operator=(const UnfinishedSession&) = delete;
    void keep() { kept_ = true; }
    const std::string& path() const { return path_; }

private:
    std::string path_;
    bool kept_ = false;
};

/// Returns NAME-recovered.tts beside the session, or the first free numbered name.
std::string nameBeside(const std::string& path)
{
    const std::filesystem::path whole(path);
    const std::string base = (whole.parent_path() / whole.stem()).string() + "-recovered";
    std::string name = base + ".tts";
    std::error_code none;
    for (int n = 2; std::filesystem::exists(name, none) && n < 1000; ++n)
        name = fmt::format("{}-{}.tts", base, n);
    return name;
}

/// Adds the gaps between non-consecutive batches.
void addGaps(const SessionReader& session, std::int64_t lastBatch, std::vector<LostSpan>& spans)
{
    SessionTime before = session.begin();
    std::int64_t next = 1;
    for (const SessionBatch& batch : session.batches()) {
        if (batch.id > next) spans.push_back({before, batch.first, batch.id - next});
        next = batch.id + 1;
        before = batch.last;
    }
    if (next <= lastBatch) spans.push_back({before, before, lastBatch - next + 1});
}

/// Joins spans that touch each other.
std::vector<LostSpan> touching(std::vector<LostSpan> spans)
{
    constexpr SessionTime kApart =
        500'000'000;  // [ns] longest interval between batches of a console
    std::sort(spans.begin(), spans.end(),
              [](const LostSpan& a, const LostSpan& b) { return a.first < b.first; });
    std::vector<LostSpan> all;
    for (const LostSpan& span : spans) {
        if (all.empty() || span.first > all.back().last + kApart) {
            all.push_back(span);
            continue;
        }
        all.back().last = std::max(all.back().last, span.last);
        all.back().batches += span.batches;
    }
    return all;
}

/// Adds the damage that the reader found after reading everything.
void addDamage(const SessionReader& session, SavedSession& saved)
{
    for (const SessionDamage& damage : session.damage()) {
        const auto& batches = session.batches();
        const bool isBatch =
            std::any_of(batches.begin(), batches.end(), [&](const SessionBatch& batch) {
                return batch.first == damage.first && batch.last == damage.last;
            });
        if (isBatch)
            saved.spans.push_back({damage.first, damage.last, 1});
        else
            saved.rest.push_back(
                fmt::format("at {}: {}", momentText(damage.first), damage.why.english()));
    }
    for (const EstimateRow& row : session.estimates())
        if (!saved.draws.contains(row.id))
            saved.rest.push_back(fmt::format("estimate {} at {}, whose draws are not whole", row.id,
                                             momentText(row.time)));
}

/// Copies all undamaged rows into a new session, whose event states source and reason.
Status copyWhole(SessionReader& session, const std::string& path, const std::string& why,
                 SavedSession& saved)
{
    auto writer = SessionWriter::create(saved.out, session.start());
    if (!writer) return writer.error();
    UnfinishedSession target(saved.out);
    SessionMerger merger(*writer, session.start().wallTime, SessionMerger::Dangling::LeftOut);
    Status status = merger.add(session);
    for (const EstimateRow& row : session.estimates())
        if (session.draws(row.id)) saved.draws.insert(row.id);
    addDamage(session, saved);
    if (status)
        status = merger.event(session,
                              {.time = session.end(),
                               .kind = EventKind::Session,
                               .subject = "recovered",
                               .text = fmt::format("what was whole in {}: {}{}",
                                                   std::filesystem::path(path).filename().string(),
                                                   why, saved.isProven ? "" : kUnproven)});
    if (status) status = writer->seal();
    if (!status) return status;
    target.keep();
    saved.leftOut = merger.leftOut();
    return Done{};
}

/// Recovers rows from the pages of a file that SQLite cannot read completely.
Status saveFragments(const std::string& path, const std::string& why, SavedSession& saved)
{
    const Error nothing =
        fileError(path, why + ", and nothing of a session is whole in it: nothing could be saved");
    const UnfinishedSession scratch(saved.out + ".pages");
    const auto pages = salvagePages(path, scratch.path());
    if (!pages && pages.error().code == kNothingWhole) return nothing;
    if (!pages) return pages.error();
    auto session = SessionReader::openFragments(scratch.path());
    if (!session) return nothing;
    std::int64_t frames = 0;
    for (std::size_t i = 0; i < session->batches().size(); ++i)
        frames += static_cast<std::int64_t>(session->frames(i).size());
    if (frames == 0 && session->events().empty() && session->scenes().empty()) return nothing;
    saved.startIsWhole = pages->startIsWhole;
    saved.isProven = pages->isProven;
    saved.isCut = pages->isCut;
    addGaps(*session, pages->lastBatch, saved.spans);
    return copyWhole(*session, path, why, saved);
}

bool canWriteBeside(const std::string& path)
{
    const std::filesystem::path folder = std::filesystem::path(path).parent_path();
    return ::access(folder.empty() ? "." : folder.c_str(), W_OK) == 0;
}

/// Checks that a file can be created there.
Status requireRoom(const std::string& path, const std::string& out, const std::string& why)
{
    std::error_code none;
    if (std::filesystem::exists(out, none))
        return fileError(out, "is there already: name another file");
    if (canWriteBeside(out)) return Done{};
    return fileError(path,
                     why + ", and " + out + " cannot be made: --out names a new session elsewhere");
}

Status save(const std::string& path, const std::string& why, SavedSession& saved)
{
    if (saved.out.empty()) saved.out = nameBeside(path);
    if (Status room = requireRoom(path, saved.out, why); !room) return room;
    auto session = SessionReader::open(path);
    if (session && !session->lacksJournal() && session->verify().damage.empty())
        return copyWhole(*session, path, why, saved);
    return saveFragments(path, why, saved);
}

/// Returns why a readable session could not be closed. refusal: SQLite's reason.
std::string whyOpen(const std::string& path, const std::string& refusal)
{
    const bool file = ::access(path.c_str(), W_OK) == 0, folder = canWriteBeside(path);
    if (!file && !folder) return "cannot be closed where neither it nor its folder can be written";
    if (!file) return "cannot be closed, because it cannot be written";
    if (!folder) return "cannot be closed where its folder cannot be written";
    const std::string index = path + "-shm";
    std::error_code none;
    if (std::filesystem::exists(index, none) && ::access(index.c_str(), W_OK) != 0)
        return fmt::format("cannot be closed, because {} is there and cannot be written: if no "
                           "program has the session open, remove it",
                           index);
    return "cannot be closed: " + refusal;
}

/// Returns why a session cannot stay as it is, without the file name; empty: undamaged and closed.
/// recovery: result of recovering it in place.
std::string troubleOf(const std::string& path, const Result<SessionRecovery>& recovery)
{
    auto session = SessionReader::open(path);
    const auto named = [&path](const std::string& text) {
        return text.starts_with(path + ": ") ? text.substr(path.size() + 2) : text;
    };
    if (!session) return named(session.error().text);
    const SessionVerification found = session->verify();
    if (session->lacksJournal()) return "its journal is not beside it, both files belong together";
    if (!found.damage.empty()) return "is damaged: " + found.damage.front().why.english();
    if (session->sealed()) return {};
    return whyOpen(path, recovery ? "it is open" : named(recovery.error().text));
}

}  // namespace

Result<SessionRescue> rescueSession(const std::string& path, const std::string& out)
{
    const auto recovery = recoverSession(path);
    if (recovery && *recovery == SessionRecovery::InUse)
        return Error{path + ": somebody has it open, most likely who records it"};
    if (!recovery && recovery.error().code == kNotFollowed) return recovery.error();
    SessionRescue rescue{.recovered = recovery && *recovery == SessionRecovery::Recovered,
                         .why = troubleOf(path, recovery)};
    if (rescue.why.empty()) return rescue;
    if (::access(path.c_str(), R_OK) != 0) return fileError(path, rescue.why);
    rescue.saved.out = out;
    if (Status done = save(path, rescue.why, rescue.saved); !done) return done.error();
    rescue.saved.spans = touching(std::move(rescue.saved.spans));
    return rescue;
}

}  // namespace terratact
