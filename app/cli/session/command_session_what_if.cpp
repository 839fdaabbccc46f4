#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <memory>

#include "app/cli/session/session_commands.h"
#include "app/modelling/session_reruns.h"
#include "app/recording/recorded_sides.h"
#include "app/recording/session_text.h"
#include "app/runtime/interrupt.h"
#include "app/runtime/parallel.h"
#include "app/runtime/print_text.h"
#include "app/runtime/progress.h"
#include "app/runtime/text_output.h"
#include "core/base/text.h"

namespace terratact {

namespace {

std::string words(const TwoTrackVerdict& verdict)
{
    if (verdict.onePlane)
        return fmt::format("{} (step ahead {:.0f} %)", describe(verdict),
                           100.0 * answeredBy(verdict.side[0]).p);
    return fmt::format("{} (step ahead left {:.0f} %, right {:.0f} %, either side {:.0f} %)",
                       describe(verdict), 100.0 * answeredBy(verdict.side[0]).p,
                       100.0 * answeredBy(verdict.side[1]).p, 100.0 * answeredBy(verdict).p);
}

/// Prints what was recomputed.
class RerunPrinter {
public:
    RerunPrinter(const SessionReruns& reruns, std::FILE* messages)
        : reruns_(reruns), messages_(messages)
    {
    }

    void print() const
    {
        for (const Rerun& rerun : reruns_.all()) print(rerun);
        if (reruns_.all().size() > 1) summarise();
        printScores();
        printLedger("later probes against the bands before them",
                    [this](SessionReader& session) { return reruns_.laterProbes(session); });
        printLedger("contacts and probes at later poses against the bands that odometry took there",
                    [this](SessionReader& session) { return reruns_.laterPoses(session); });
    }

private:
    void print(const Rerun& r) const
    {
        const Differences& d = r.differences;
        printText(messages_, "{}: estimate {} of scene {} at {}, {}: ", r.session->path(), r.row.id,
                  r.row.scene, momentText(r.row.time),
                  name(r.row.estimate.side[0].settings.method));
        const bool identical = d.match == Match::Identical;
        if (r.asRecorded && identical) {
            printText(messages_, "reproduced bit for bit\n");
            return;
        }
        if (r.asRecorded && d.match == Match::LastBits) {
            printText(messages_,
                      "reproduced but for the last bits of another processor or version, "
                      "heights within {:.1g} m\n",
                      d.largest());
            return;
        }
        if (r.asRecorded && r.endedByTime())
            printText(messages_, "its sampling was ended by time, which nothing repeats\n");
        else if (r.asRecorded)
            printText(messages_, "NOT reproduced, heights differ by up to {:.1g} m\n", d.largest());
        else
            printText(messages_, "now {}{}\n", name(r.again.side[0].settings.method),
                      identical ? ", the same bit for bit" : "");
        if (identical) return;
        for (const RecordedSide& side : recordedSides(d.onePlane, nullptr)) printBins(r, side);
        printText(messages_, "  moved most at {:+.1f} m{}, by {:.0f} mm; {} then, {} now\n",
                  binCentre(d.largestBin),
                  d.onePlane           ? ""
                  : d.largestSide == 0 ? " left"
                                       : " right",
                  1000.0 * d.largest(), words(d.before), words(d.after));
    }

    void printBins(const Rerun& r, const RecordedSide& side) const
    {
        const Differences& d = r.differences;
        if (!d.onePlane) printText(messages_, "  {}\n", side.name);
        printText(messages_, "   bin   height [m]           sd [mm]      80 % band [m]\n"
                             "   [m]   then     now  moved  then  now   then              now\n");
        for (std::size_t i = 0; i < kBins; ++i) {
            const TerrainEstimate& a = r.row.estimate.side.at(side.index);
            const TerrainEstimate& b = r.again.side.at(side.index);
            printText(messages_,
                      "  {:+.1f} {:+.3f}  {:+.3f}  {:+5.0f} {:5.0f} {:4.0f}   {:+.3f} … {:+.3f}   "
                      "{:+.3f} … {:+.3f}\n",
                      binCentre(static_cast<int>(i)), a.height[i], b.height[i],
                      1000.0 * d.side.at(side.index)[i].height, 1000.0 * a.sd[i], 1000.0 * b.sd[i],
                      a.q10[i], a.q90[i], b.q10[i], b.q90[i]);
        }
    }

    void summarise() const
    {
        std::size_t same = 0, lastBits = 0, other = 0;
        std::vector<double> moved;
        const std::vector<Rerun>& all = reruns_.all();
        for (const Rerun& r : all) {
            same += r.differences.match == Match::Identical;
            lastBits += r.differences.match == Match::LastBits;
            other += r.differences.before.both != r.differences.after.both;
            moved.push_back(r.differences.largest());
        }
        std::sort(moved.begin(), moved.end());
        printText(messages_,
                  "\n{} estimates of {} sessions: {} the same bit for bit, {} but for the "
                  "last bits, {} with another verdict; largest move of a bin {:.0f} mm in the "
                  "median estimate, {:.0f} mm in the worst\n",
                  all.size(), reruns_.sessionsWithReruns(), same, lastBits, other,
                  1000.0 * moved[moved.size() / 2], 1000.0 * moved.back());
    }

    void printRow(std::string_view label, const ErrorStatistics& s) const
    {
        printText(messages_, "  {:<5} {:6} {:13.1f} {:10.1f} {:14.0f}\n", label, s.n,
                  1000.0 * s.median, 1000.0 * s.crps, 100.0 * s.coverage);
    }

    /// Prints scores against the truth, if a simulated source recorded it.
    void printScores() const
    {
        const RerunErrors errors = reruns_.errors();
        if (errors.then.empty()) return;
        printText(messages_,
                  "\nagainst the truth, which the source knew\n         bins  |error| [mm]  CRPS "
                  "[mm]  in 80 % band\n");
        printRow("then", statistics(errors.then));
        printRow("now", statistics(errors.now));
    }

    /// Prints one line per session, sorted by name and thus by time, and one line for all.
    void printLedger(std::string_view title,
                     const std::function<RerunLedgers(SessionReader&)>& ledgersOf) const
    {
        RerunLedgers all;
        std::string lines;
        std::size_t sessions = 0;
        for (const auto& session : reruns_.sessions()) {
            const RerunLedgers ledgers = ledgersOf(*session);
            if (ledgers.empty()) continue;
            all.then.add(ledgers.then);
            all.now.add(ledgers.now);
            ++sessions;
            lines += ledgerLines(ledgers, ", " + utcText(session->start().wallTime) + ", "
                                              + printable(session->path()));
        }
        if (sessions == 0) return;
        printText(messages_, "\n{}\n         times  in 50 %  in 80 %  in 95 %  rms z  bands\n{}",
                  title, Lines(sessions > 1 ? lines : std::string()));
        printText(messages_, "{}", Lines(ledgerLines(all, sessions > 1 ? ", all" : "")));
    }

    static std::string ledgerLines(const RerunLedgers& ledgers, const std::string& where)
    {
        std::string lines;
        for (const auto& [label, ledger] :
             {std::pair{"then", &ledgers.then}, std::pair{"now", &ledgers.now}}) {
            const LedgerSummary s = ledger->summary();
            lines += fmt::format("  {:<5} {:6} {:8.0f} {:8.0f} {:8.0f} {:6.2f}  {}{}\n", label, s.n,
                                 100.0 * s.in50.share, 100.0 * s.in80.share, 100.0 * s.in95.share,
                                 s.rmsZ, name(s.verdict), where);
        }
        return lines;
    }

    const SessionReruns& reruns_;
    std::FILE* const messages_;
};

void noteDamage(const SessionReader& session)
{
    for (const SessionDamage& damage : session.damage())
        printText(stderr, "terratact: {}: left out: {}\n", session.path(),
                  damageText(session.start(), damage));
}

/// Returns the progress and the cancellation of one estimate.
Watch watchOf(const EstimateRow& row, const Interrupt& interrupt)
{
    Watch watch;
    lendProcessors(watch);
    const auto progress =
        std::make_shared<Progress>(fmt::format("estimate {}: percent", row.id), 100);
    watch.progress = [progress](double share) { progress->reach(static_cast<int>(100.0 * share)); };
    watch.cancelled = [&interrupt] { return interrupt.came(); };
    return watch;
}

}  // namespace

Status whatIf(const WhatIfOptions& options)
{
    const Interrupt interrupt;
    SessionReruns reruns(
        options.rerun, {.opened = noteDamage,
                        .watch = [&](const EstimateRow& row) { return watchOf(row, interrupt); }});
    try {
        for (const std::string& path : options.files)
            for (const std::string& file : sessionsAt(path))
                if (Status done = reruns.add(file); !done) return done;
    } catch (const Cancelled&) {
        return Error{"what-if was cancelled (Ctrl+C): nothing is compared and nothing is written"};
    }
    if (reruns.all().empty()) return Error{options.files.front() + ": holds no estimate"};
    RerunPrinter(reruns, messagesBeside(options.out)).print();
    if (!options.out.empty())
        if (Status written = writeText(options.out, reruns.csv()); !written) return written;
    if (reruns.failed() == 0) return Done{};
    return Error{fmt::format("{} of {} estimates do not come out as they were recorded",
                             reruns.failed(), reruns.all().size())};
}

}  // namespace terratact
