#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "app/cli/session_commands.h"
#include "app/recording/session_merger.h"
#include "app/recording/session_text.h"
#include "app/runtime/say.h"
#include "core/log/session_salvage.h"
#include "core/log/session_writer.h"
#include "core/store/file_read.h"

namespace terratact {
namespace {

constexpr const char* kUnproven =
    "; the hashes that were recorded with them are lost: nothing proves that they are what was "
    "recorded";

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

/// Consecutive batches that are missing or damaged.
struct LostSpan {
    SessionTime first, last;
    std::int64_t batches;
};

/// Result of recovering a session that could not be closed in place.
struct Saved {
    std::string out;
    std::int64_t leftOut = 0;  ///< rows that refer to a lost row
    bool isProven = true;      ///< the recorded hashes prove the rows
    bool isCut = false;
    bool startIsWhole = true;  ///< source, robot and wall time are known
    std::vector<LostSpan> spans{};
    std::set<std::int64_t> draws{};   ///< estimates with undamaged draws
    std::vector<std::string> rest{};  ///< other losses
};

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
void addDamage(const SessionReader& session, Saved& saved)
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
                 Saved& saved)
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
Status saveFragments(const std::string& path, const std::string& why, Saved& saved)
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

/// Checks that a file can be created there.
Status requireRoom(const std::string& path, const std::string& out, const std::string& why)
{
    std::error_code none;
    if (std::filesystem::exists(out, none)) return fileError(out, "is there already");
    const std::filesystem::path folder = std::filesystem::path(out).parent_path();
    if (::access(folder.empty() ? "." : folder.c_str(), W_OK) == 0) return Done{};
    return fileError(path,
                     why + ", and " + out + " cannot be made: --out names a new session elsewhere");
}

Status save(const std::string& path, const std::string& why, Saved& saved)
{
    if (saved.out.empty()) saved.out = nameBeside(path);
    if (Status room = requireRoom(path, saved.out, why); !room) return room;
    auto session = SessionReader::open(path);
    if (session && !session->lacksJournal() && session->verify().damage.empty())
        return copyWhole(*session, path, why, saved);
    return saveFragments(path, why, saved);
}

void tellLoss(const Saved& saved)
{
    if (!saved.isProven) say("  but        the frames alone{}\n", kUnproven);
    if (!saved.startIsWhole)
        say("  lost       what the session said of its start: times count from 1970, the robot and "
            "the source are not known\n");
    for (const LostSpan& span : touching(saved.spans)) {
        const std::string what =
            span.batches == 1 ? "1 batch" : fmt::format("{} batches", span.batches);
        if (span.first == span.last)
            say("  lost       {} at {}\n", what, momentText(span.first));
        else
            say("  lost       {} between {} and {}\n", what, momentText(span.first),
                momentText(span.last));
    }
    for (const std::string& line : saved.rest) say("  lost       {}\n", line);
    if (saved.leftOut > 0) say("  left out   {} rows that refer to a lost one\n", saved.leftOut);
}

/// Reads the new session again and prints its content.
Status tell(const std::string& path, const std::string& why, const Saved& saved)
{
    auto session = SessionReader::open(saved.out);
    if (!session) return session.error();
    const SessionVerification found = session->verify();
    say("{}: {}\n", path, why);
    say("  saved      {}: up to {}, {} frames, {} scenes, {} estimates, {} events\n", saved.out,
        momentText(session->end()), found.frames, session->scenes().size(),
        session->estimates().size(), found.events);
    tellLoss(saved);
    if (saved.isCut)
        say("  lost       what was recorded after {}: the file ends there\n",
            momentText(session->end()));
    say("  last link  {}\n", found.chain);
    return Done{};
}

/// Returns why a session cannot stay as it is, without the file name; empty: undamaged and closed.
std::string troubleOf(const std::string& path)
{
    auto session = SessionReader::open(path);
    const auto named = [&path](const std::string& text) {
        return text.starts_with(path + ": ") ? text.substr(path.size() + 2) : text;
    };
    if (!session) return named(session.error().text);
    const SessionVerification found = session->verify();
    if (session->lacksJournal()) return "its journal is not beside it, both files belong together";
    if (!found.damage.empty()) return "is damaged: " + found.damage.front().why.english();
    return session->sealed() ? std::string()
                             : "cannot be closed where neither it nor its folder can be written";
}

Status recoverOne(const std::string& path, const std::string& out)
{
    const auto recovery = recoverSession(path);
    if (recovery && *recovery == SessionRecovery::InUse)
        return Error{path + ": somebody has it open, most likely who records it"};
    if (!recovery && recovery.error().code == kNotFollowed) return recovery.error();
    const std::string why = troubleOf(path);
    if (why.empty()) {
        say("{}: {}\n", path,
            recovery && *recovery == SessionRecovery::Recovered ? "recovered and closed"
                                                                : "was closed already");
        return Done{};
    }
    Saved saved;
    saved.out = out;
    if (Status done = save(path, why, saved); !done) return done;
    return tell(path, why, saved);
}

}  // namespace

Status recoverSessions(const RecoverOptions& options)
{
    if (!options.out.empty() && options.files.size() != 1)
        return Error{"--out is what one session becomes"};
    for (const std::string& file : options.files)
        if (Status done = recoverOne(file, options.out); !done) return done;
    return Done{};
}

}  // namespace terratact
