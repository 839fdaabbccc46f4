#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/cli/session/open_session.h"
#include "app/cli/session/session_commands.h"
#include "app/recording/export/payload_signals.h"
#include "app/recording/session_text.h"
#include "app/recording/what_if.h"
#include "app/runtime/print_text.h"
#include "app/runtime/text_output.h"
#include "core/base/text.h"
#include "core/log/session_reader.h"
#include "core/store/file_read.h"

namespace terratact {

namespace {

/// Returns the number of estimates that contradict their readings (core/sim/posterior_check.h).
std::ptrdiff_t contradicting(const SessionReader& session)
{
    const auto& estimates = session.estimates();
    return std::count_if(estimates.begin(), estimates.end(), [](const EstimateRow& row) {
        return row.estimate.side[0].contradicts || row.estimate.side[1].contradicts;
    });
}

std::size_t count(const SessionReader& session, EventKind kind)
{
    const auto& events = session.events();
    return static_cast<std::size_t>(std::count_if(
        events.begin(), events.end(), [kind](const EventRow& e) { return e.kind == kind; }));
}

double framesMissing(const SessionReader& session)
{
    double missing = 0.0;
    for (const EventRow& event : session.events())
        if (event.kind == EventKind::Gap) missing += event.number.value_or(0.0);
    return missing;
}

void line(std::string_view what, const std::string& text)
{
    printText("  {:<10} {}\n", what, text);
}

void printDamage(const SessionReader& session, const SessionVerification& found)
{
    if (found.broken)
        line("broken", "nothing is proven from " + damageText(session.start(), *found.broken));
    for (const SessionDamage& damage : found.damage)
        line("damage", damageText(session.start(), damage));
}

void print(SessionReader& session)
{
    const SessionVerification found = session.verify();
    const SessionStart& start = session.start();
    const double duration = secondsOf(session.end() - session.begin());
    printText("{}\n", session.path());
    line("begins", fmt::format("{}, {}", utcText(wallTimeOf(start, session.begin())),
                               localText(wallTimeOf(start, session.begin()))));
    line("lasts", fmt::format("{:.3f} s", duration));
    line("source", fmt::format("{}, bus {}, {}", start.source, start.bus,
                               start.transmits ? "commands could be sent" : "listened only"));
    line("program", start.program);
    line("robot", "SHA-256 " + start.robotHash);
    for (const ModelRow& model : session.models())
        line("model", fmt::format("{}, SHA-256 {}, from {} on", model.name, model.hash,
                                  momentText(model.time)));
    line("frames", duration > 0.0
                       ? fmt::format("{}, {:.1f} per second", session.frameCount(),
                                     static_cast<double>(session.frameCount()) / duration)
                       : fmt::format("{}", session.frameCount()));
    line("rows", fmt::format("{} scenes, {} estimates, {} probes proposed, {} decisions, {} "
                             "markers, {} events in all",
                             session.scenes().size(), session.estimates().size(),
                             session.proposals().size(), count(session, EventKind::Decision),
                             count(session, EventKind::Marker), session.events().size()));
    line("contradict", fmt::format("{} of {} estimates contradict their readings",
                                   contradicting(session), session.estimates().size()));
    line("gaps", fmt::format("{}, {:.0f} frames missing", count(session, EventKind::Gap),
                             framesMissing(session)));
    printDamage(session, found);
    line("holds", found.damage.empty() && !found.broken ? "yes" : "NO");
    line("closed", session.sealed()         ? "yes"
                   : session.lacksJournal() ? "no, and its journal is not beside it"
                                            : "no: still being recorded, or its program died");
    line("last link", found.chain);
}

/// Prints whether the session's hash chain holds and returns the result.
bool verify(SessionReader& session, const std::string& link)
{
    const SessionVerification found = session.verify();
    const bool linked = link.empty() || link == found.chain;
    const bool holds = !found.broken && found.damage.empty() && linked;
    printText("{}: {}; {} batches, {} frames, {} events{}; last link {}\n", session.path(),
              holds ? "holds" : "DOES NOT HOLD", found.batches, found.frames, found.events,
              session.sealed() ? "" : ", not closed", found.chain);
    const auto& batches = session.batches();
    if (found.broken) {
        const auto at = std::find_if(batches.begin(), batches.end(), [&](const SessionBatch& b) {
            return b.first == found.broken->first && b.last == found.broken->last;
        });
        line("broken",
             fmt::format("from batch {} on nothing is proven: {}", at == batches.end() ? 0 : at->id,
                         damageText(session.start(), *found.broken)));
    }
    for (const SessionDamage& damage : found.damage)
        line("damage", damageText(session.start(), damage));
    if (!linked) line("last link", fmt::format("is not {}: something was cut off or added", link));
    return holds;
}

}  // namespace

Status showSessions(const std::vector<std::string>& files)
{
    for (const std::string& file : files) {
        auto session = openSession(file);
        if (!session) return session.error();
        print(*session);
    }
    return Done{};
}

Status verifySessions(const VerifyOptions& options)
{
    if (!options.link.empty() && options.files.size() != 1)
        return Error{"--link is the last link of one session"};
    std::size_t bad = 0;
    for (const std::string& file : options.files) {
        auto session = openSession(file);
        if (!session) {
            printText("{}\n", session.error().text);
            ++bad;
        } else if (!verify(*session, options.link)) {
            ++bad;
        }
    }
    if (bad == 0) return Done{};
    return Error{fmt::format("{} of {} sessions do not hold", bad, options.files.size())};
}

Status exportSession(const SessionExportOptions& options)
{
    const auto format = options.format ? options.format : exportFormatOf(options.out);
    if (!format)
        return fileError(options.out,
                         "ends in none of .log, .asc, .csv, .mcap: choose a format with "
                         "--format");
    auto session = openSession(options.file);
    if (!session) return session.error();
    const bool holdsSignals = *format == ExportFormat::Csv || *format == ExportFormat::Mcap;
    if (!options.dbc.empty() && !holdsSignals)
        return fileError(options.out, "a log of CAN frames holds no signals of --dbc; csv and mcap "
                                      "do");
    const auto book = readDbcBook(CanProtocol::Terratact, options.dbc);
    if (!book) return book.error();
    for (const Message& remark : remarksOf(*book))
        printText(stderr, "terratact: {}\n", remark.english());
    ExportSelection selection = options.selection;
    selection.book = *book;
    const auto counts = writeExport(*session, options.out, *format, selection);
    if (!counts) return counts.error();
    if (counts->withoutColumns > 0)
        printText(stderr,
                  "terratact: {}: {} messages of --dbc are left out: their signals and "
                  "those before are more than {}\n",
                  options.out, counts->withoutColumns, PayloadSignals::kMaxSignals);
    printText(messagesBeside(options.out), "{} written\n", options.out);
    if (counts->leftOut > 0)
        printText(stderr, "terratact: {}: {} frames left out, which the format cannot hold\n",
                  options.out, counts->leftOut);
    for (const SessionDamage& damage : session->damage())
        printText(stderr, "terratact: {}: left out: {}\n", options.file,
                  damageText(session->start(), damage));
    return Done{};
}

}  // namespace terratact
