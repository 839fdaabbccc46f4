#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "app/cli/session_commands.h"
#include "app/recording/session_merger.h"
#include "app/recording/session_text.h"
#include "app/runtime/print_text.h"
#include "core/log/event_text.h"
#include "core/log/session_writer.h"
#include "core/store/file_read.h"

namespace terratact {

namespace {

constexpr std::int64_t kMaxApart = std::int64_t{86'400} * 31 * 1'000'000'000;  // [ns]

/// Returns the times of the first and last frame [ns] since 1970; those of the first row without frames.
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

/// Prints which file follows, and whether it is undamaged.
Status showMerge(SessionMerger& merger, SessionReader& session)
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
        std::int64_t first, last;  ///< times of its first and last frame [ns] since 1970
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
        if (part.first - before.last > kMaxApart
            || std::abs(part.reader.start().wallTime - before.reader.start().wallTime) > kMaxApart)
            return fileError(part.reader.path(),
                             "was recorded more than a month apart from " + before.reader.path());
        start.transmits = start.transmits || part.reader.start().transmits;
        wallTime = std::min(wallTime, part.reader.start().wallTime);
    }
    start.wallTime = wallTime;
    auto writer = SessionWriter::create(options.out, start);
    if (!writer) return writer.error();
    SessionMerger merger(*writer, wallTime, SessionMerger::Dangling::Refused);
    Status status = Done{};
    for (Part& part : parts) {
        if (status) status = showMerge(merger, part.reader);
        if (status) status = merger.add(part.reader);
    }
    if (status) status = writer->seal();
    if (!status) {
        std::error_code ignored;
        for (const char* suffix : {"", "-wal", "-shm"})
            std::filesystem::remove(options.out + suffix, ignored);
        return status;
    }
    printText("{} sessions, {} frames merged into {}; last link {}\n", parts.size(),
              writer->frames(), options.out, writer->chain());
    return Done{};
}

}  // namespace terratact
