#include "app/recording/session_merge.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <utility>

#include "app/recording/session_merger.h"
#include "app/recording/session_text.h"
#include "core/log/event_text.h"
#include "core/log/session_reader.h"
#include "core/log/session_writer.h"
#include "core/store/file_read.h"

namespace terratact {
namespace {

constexpr std::int64_t kMaxApart = std::int64_t{86'400} * 31 * 1'000'000'000;  // [ns]

/// A session to be merged.
struct MergePart {
    SessionReader reader;
    std::int64_t first, last;  ///< times of its first and last frame [ns] since 1970
};

/// Opens a session. Without frames, its first row counts as first and last frame.
Result<MergePart> partOf(const std::string& file)
{
    auto session = SessionReader::open(file);
    if (!session) return session.error();
    std::optional<SessionTime> first;
    SessionTime last = session->begin();
    for (std::size_t i = 0; i < session->batches().size(); ++i) {
        if (session->batches()[i].frameCount == 0) continue;
        const auto frames = session->frames(i);
        if (frames.empty()) continue;
        if (!first) first = frames.front().time;
        last = frames.back().time;
    }
    const std::int64_t from = wallTimeOf(session->start(), first.value_or(session->begin()));
    const std::int64_t to = wallTimeOf(session->start(), last);
    return MergePart{std::move(*session), from, to};
}

/// Opens the sessions and sorts them by time.
Result<std::vector<MergePart>> partsOf(const std::vector<std::string>& files)
{
    std::vector<MergePart> parts;
    for (const std::string& file : files) {
        auto part = partOf(file);
        if (!part) return part.error();
        parts.push_back(std::move(*part));
    }
    std::sort(parts.begin(), parts.end(),
              [](const MergePart& a, const MergePart& b) { return a.first < b.first; });
    return parts;
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

/// Checks that a session can follow the one before it.
Status requireFollowing(const MergePart& before, const MergePart& part)
{
    if (Status alike = requireAlike(before.reader, part.reader); !alike) return alike;
    if (part.first < before.last)
        return fileError(part.reader.path(),
                         fmt::format("begins at {}, before {} ends at {}: sessions that overlap "
                                     "are not one drive",
                                     utcText(part.first), before.reader.path(),
                                     utcText(before.last)));
    if (part.first - before.last > kMaxApart
        || std::abs(part.reader.start().wallTime - before.reader.start().wallTime) > kMaxApart)
        return fileError(part.reader.path(),
                         "was recorded more than a month apart from " + before.reader.path());
    return Done{};
}

/// Returns the start of the new session: the earliest time; it transmits if one of the parts did.
SessionStart startOf(const std::vector<MergePart>& parts)
{
    SessionStart start = parts.front().reader.start();
    for (const MergePart& part : parts) {
        start.transmits = start.transmits || part.reader.start().transmits;
        start.wallTime = std::min(start.wallTime, part.reader.start().wallTime);
    }
    return start;
}

/// Adds an event with the file name of the session that follows, and with its damage.
Status addOrigin(SessionMerger& merger, SessionReader& session)
{
    const SessionVerification found = session.verify();
    const std::string file = std::filesystem::path(session.path()).filename().string();
    const Message source =
        found.damage.empty()
            ? Message(TR_NOOP("core", "from %1, %2 frames, last link %3"), file, found.frames,
                      found.chain)
            : Message(TR_NOOP("core", "from %1, %2 frames, last link %3, %4 batches of which are "
                                      "not what was recorded and left out"),
                      file, found.frames, found.chain, found.damage.size());
    return merger.event(
        session,
        withText({.time = session.begin(), .kind = EventKind::Session, .subject = "merged"},
                 source));
}

Status writeParts(SessionWriter& writer, std::int64_t wallTime, std::vector<MergePart>& parts)
{
    SessionMerger merger(writer, wallTime, SessionMerger::Dangling::Refused);
    for (MergePart& part : parts) {
        if (Status added = addOrigin(merger, part.reader); !added) return added;
        if (Status added = merger.add(part.reader); !added) return added;
    }
    return writer.seal();
}

}  // namespace

Result<MergedSession> mergeSessionFiles(const std::vector<std::string>& files,
                                        const std::string& out)
{
    auto parts = partsOf(files);
    if (!parts) return parts.error();
    for (std::size_t k = 1; k < parts->size(); ++k)
        if (Status fits = requireFollowing((*parts)[k - 1], (*parts)[k]); !fits)
            return fits.error();
    const SessionStart start = startOf(*parts);
    auto writer = SessionWriter::create(out, start);
    if (!writer) return writer.error();
    if (Status written = writeParts(*writer, start.wallTime, *parts); !written) {
        std::error_code ignored;
        for (const char* suffix : {"", "-wal", "-shm"})
            std::filesystem::remove(out + suffix, ignored);
        return written.error();
    }
    return MergedSession{parts->size(), writer->frames(), writer->chain()};
}

}  // namespace terratact
