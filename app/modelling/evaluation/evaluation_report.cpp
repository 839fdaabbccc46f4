#include "app/modelling/evaluation/evaluation_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "core/base/message.h"
#include "core/base/text.h"
#include "core/store/csv_text.h"

namespace terratact {
namespace {

double millimetres(double metres)
{
    return 1000.0 * metres;
}

/// Returns "12 (5–31)": median and quartiles [mm].
std::string medianAndQuartiles(const ErrorStatistics& s)
{
    if (s.n == 0) return "-";
    return fmt::format("{:.0f} ({:.0f}–{:.0f})", millimetres(s.median), millimetres(s.q1),
                       millimetres(s.q3));
}

/// Right-aligns a text in `width` columns; fmt counts "–" as one column.
std::string cell(const std::string& text, int width = 15)
{
    return fmt::format("{:>{}}", text, width);
}

template <class Text>
void addRow(std::string& table, std::string_view head, std::span<const MethodSummary> summaries,
            Text text)
{
    table += fmt::format("{:<22}", head);
    for (const MethodSummary& summary : summaries) table += cell(text(summary));
    table += '\n';
}

std::string percent(double share, std::size_t n)
{
    return n == 0 ? "-" : fmt::format("{:.0f} %", 100.0 * share);
}

/// Returns a row of texts in columns of these widths; the first `left` are left-aligned.
std::string row(const std::vector<std::string>& texts, const std::vector<int>& widths,
                std::size_t left)
{
    std::string line;
    for (std::size_t k = 0; k < texts.size(); ++k)
        line += k < left ? fmt::format("{:<{}}", texts[k], widths[k]) : cell(texts[k], widths[k]);
    line += '\n';
    return line;
}

/// Returns "7.0 [6.2, 8.1]": the score of the whole sample and its interval, times `factor`.
std::string withInterval(double value, const std::optional<ScoreIntervals>& intervals,
                         Interval ScoreIntervals::*which, double factor, int digits)
{
    std::string text = fmt::format("{:.{}f}", factor * value, digits);
    if (intervals) {
        const Interval& i = (*intervals).*which;
        text += fmt::format(" [{:.{}f}, {:.{}f}]", factor * i.low, digits, factor * i.high, digits);
    }
    return text;
}

/// Adds a score of the whole sample and the two ends of its interval, which may be unknown.
void addInterval(std::vector<CsvValue>& fields, double value, const std::optional<Interval>& i)
{
    fields.insert(fields.end(),
                  {fixed(value, 6), i ? fixed(i->low, 6) : "", i ? fixed(i->high, 6) : ""});
}

/// Returns the entry with this label; a default entry if there is none.
template <class Entry>
Entry entryOf(const std::string& label, std::span<const Entry> entries)
{
    for (const Entry& e : entries)
        if (e.label == label) return e;
    return {};
}

/// Returns a name cut to the width of its column.
std::string shortened(const std::string& text, std::size_t most)
{
    return text.size() <= most ? text : text.substr(0, most - 2) + "..";
}

/// Returns rows method,from,to,count,share; the last class ends at `last`.
std::string histogramCsv(std::string_view header, std::span<const ErrorHistogram> histograms,
                         std::string_view last)
{
    std::string csv(header);
    for (const ErrorHistogram& h : histograms)
        for (std::size_t k = 0; k < h.count.size(); ++k) {
            const auto edge = [&](std::size_t at) {
                return rounded(h.width * static_cast<double>(at), 6);
            };
            csv +=
                csvLine({h.label, edge(k), k + 1 < h.count.size() ? edge(k + 1) : last, h.count[k],
                         fixed(static_cast<double>(h.count[k]) / static_cast<double>(h.n), 6)});
        }
    return csv;
}

std::string claimLine(const ClaimResult& r)
{
    const std::string head = fmt::format("{}: {}", r.claim.text, name(r.verdict));
    if (r.n == 0)
        return fmt::format("{}\n   no bin was estimated by both {} and {}", head,
                           name(r.claim.base), name(r.claim.better));
    const std::string medians =
        fmt::format("{}\n   median |error| {} {:.1f} mm, {} {:.1f} mm", head, name(r.claim.base),
                    millimetres(r.baseMedian), name(r.claim.better), millimetres(r.betterMedian));
    if (r.runs < kMinRuns)
        return fmt::format("{}; {} of at least {} drives", medians, r.runs, kMinRuns);
    return fmt::format(
        "{}; difference {:+.1f} mm, 95 % interval {:+.1f} … {:+.1f}; {} bins of {} drives", medians,
        millimetres(r.betterMedian - r.baseMedian), millimetres(r.low), millimetres(r.high), r.n,
        r.runs);
}

std::string brierRow(const BrierSummary& b, const std::vector<int>& widths)
{
    std::string score = fmt::format("{:.3f}", b.score);
    if (b.interval) score += fmt::format(" [{:.3f}, {:.3f}]", b.interval->low, b.interval->high);
    return row({std::string(name(b.place)), b.label, fmt::format("{}", b.n),
                percent(b.observedShare, b.n), score, fmt::format("{:.3f}", b.reliability),
                fmt::format("{:.3f}", b.resolution), fmt::format("{:.3f}", b.uncertainty)},
               widths, 2);
}

/// Returns "0.34 0.40   120": mean forecast, observed share, count.
std::string reliabilityText(const ReliabilityClass& c)
{
    if (c.n == 0) return "-";
    return fmt::format("{:.2f} {:.2f} {:5}", c.meanForecast, c.observedShare, c.n);
}

std::string reliabilityRows(std::span<const BrierSummary> summaries, StepPlace place)
{
    std::vector<std::string> head{"forecast"};
    std::vector<int> widths{12};
    std::vector<const BrierSummary*> own;
    for (const BrierSummary& b : summaries) {
        if (b.place != place) continue;
        own.push_back(&b);
        head.push_back(b.label);
        widths.push_back(17);
    }
    if (own.empty()) return {};
    std::string table =
        fmt::format("Reliability, {}: mean forecast, observed share, scenes\n", name(place));
    table += row(head, widths, 1);
    for (std::size_t k = 0; k < kReliabilityClasses; ++k) {
        const double from = 0.1 * static_cast<double>(k);
        std::vector<std::string> texts{fmt::format("{:.1f} - {:.1f}", from, from + 0.1)};
        for (const BrierSummary* b : own) texts.push_back(reliabilityText(b->classes[k]));
        table += row(texts, widths, 1);
    }
    return table;
}

}  // namespace

std::string errorsCsv(std::span<const BinError> errors, std::span<const Scene> scenes)
{
    std::string csv =
        "run,t_s,method,bin_m,error_m,abs_error_m,in_band,source,crps_m,pit,in_50,in_95,width_m,"
        "novelty\n";
    for (const BinError& e : errors) {
        if (e.scene >= scenes.size())
            throw std::invalid_argument("errorsCsv: an error of a scene that is not there");
        const Scene& scene = scenes[e.scene];
        const ForecastScores& s = e.scores;
        csv += csvLine({scene.run, scene.time, e.label, signedTenth(binCentre(e.bin)), e.error,
                        std::abs(e.error), s.in80, name(e.origin), fixed(s.crps, 6),
                        fixed(s.pit, 6), s.in50, s.in95, fixed(s.width, 6),
                        e.novelty > 0.0 ? fixed(e.novelty, 4) : ""});
    }
    return csv;
}

std::string fig8Csv(std::span<const ErrorHistogram> histograms)
{
    return histogramCsv("method,from_m,to_m,count,share\n", histograms, "");
}

std::string fig9Csv(std::span<const MethodSummary> summaries)
{
    std::string csv =
        "method,bin_m,n,q1_m,median_m,q3_m,mean_m,coverage,sampled,sampled_coverage,crps_m\n";
    for (const MethodSummary& summary : summaries)
        for (int bin = 0; bin < kBins; ++bin) {
            const ErrorStatistics& s = summary.bin[static_cast<std::size_t>(bin)];
            if (s.n == 0) continue;
            csv += csvLine({summary.label, signedTenth(binCentre(bin)), s.n, fixed(s.q1, 6),
                            fixed(s.median, 6), fixed(s.q3, 6), fixed(s.mean, 6),
                            fixed(s.coverage, 4), s.sampled,
                            s.sampled > 0 ? fixed(s.sampledCoverage, 4) : "", fixed(s.crps, 6)});
        }
    return csv;
}

std::string pitCsv(std::span<const ErrorHistogram> histograms)
{
    return histogramCsv("method,from,to,count,share\n", histograms, "1");
}

std::string coverageCsv(std::span<const MethodSummary> summaries)
{
    std::string csv = "method,bin_m,n,in_50,in_80,in_95,width_m\n";
    const auto add = [&](const std::string& label, const CsvValue& bin, const ErrorStatistics& s) {
        if (s.n > 0)
            csv += csvLine({label, bin, s.n, fixed(s.coverage50, 4), fixed(s.coverage, 4),
                            fixed(s.coverage95, 4), fixed(s.width, 6)});
    };
    for (const MethodSummary& summary : summaries) {
        for (int bin = 0; bin < kBins; ++bin)
            add(summary.label, signedTenth(binCentre(bin)),
                summary.bin[static_cast<std::size_t>(bin)]);
        add(summary.label, "all", summary.all);
    }
    return csv;
}

std::string scoresCsv(std::span<const MethodSummary> summaries,
                      std::span<const Confidence> confidences, std::span<const MethodTime> times)
{
    std::string csv = "method,n,drives";
    for (const auto& column :
         {",near_median{}_m", ",median{}_m", ",mean{}_m", ",crps{}_m", ",coverage{}"})
        for (const auto& part : {"", "_low", "_high"})
            csv += fmt::format(fmt::runtime(column), part);
    csv += ",coverage_50,coverage_95,width_m,scene_s\n";
    for (const MethodSummary& m : summaries) {
        const Confidence c = entryOf(m.label, confidences);
        std::vector<CsvValue> fields{m.label, m.all.n, c.drives};
        const auto add = [&](double value, Interval ScoreIntervals::*which) {
            addInterval(fields, value,
                        c.intervals ? std::optional((*c.intervals).*which) : std::nullopt);
        };
        add(m.near.median, &ScoreIntervals::nearMedian);
        add(m.all.median, &ScoreIntervals::median);
        add(m.all.mean, &ScoreIntervals::mean);
        add(m.all.crps, &ScoreIntervals::crps);
        add(m.all.coverage, &ScoreIntervals::coverage);
        fields.insert(fields.end(),
                      {fixed(m.all.coverage50, 4), fixed(m.all.coverage95, 4),
                       fixed(m.all.width, 6), fixed(entryOf(m.label, times).perScene, 6)});
        csv += csvLine(fields);
    }
    return csv;
}

std::string groupsCsv(std::string_view kind, std::span<const GroupSummary> groups)
{
    std::string csv = fmt::format("{},method,scenes,n,median_m,mean_m,crps_m,coverage\n", kind);
    for (const GroupSummary& g : groups)
        csv += csvLine({g.group, g.label, g.scenes, g.all.n, fixed(g.all.median, 6),
                        fixed(g.all.mean, 6), fixed(g.all.crps, 6), fixed(g.all.coverage, 4)});
    return csv;
}

std::string brierCsv(std::span<const BrierSummary> summaries)
{
    std::string csv =
        "method,place,n,observed_share,brier,brier_low,brier_high,reliability,resolution,"
        "uncertainty\n";
    for (const BrierSummary& b : summaries) {
        std::vector<CsvValue> fields{b.label, name(b.place), b.n, fixed(b.observedShare, 6)};
        addInterval(fields, b.score, b.interval);
        fields.insert(fields.end(),
                      {fixed(b.reliability, 6), fixed(b.resolution, 6), fixed(b.uncertainty, 6)});
        csv += csvLine(fields);
    }
    return csv;
}

std::string reliabilityCsv(std::span<const BrierSummary> summaries)
{
    std::string csv = "method,place,from,to,n,mean_forecast,observed_share\n";
    for (const BrierSummary& b : summaries)
        for (std::size_t k = 0; k < b.classes.size(); ++k) {
            const ReliabilityClass& c = b.classes[k];
            const auto from = 0.1 * static_cast<double>(k);
            if (c.n > 0)
                csv += csvLine({b.label, name(b.place), fixed(from, 1), fixed(from + 0.1, 1), c.n,
                                fixed(c.meanForecast, 4), fixed(c.observedShare, 4)});
        }
    return csv;
}

std::string probesCsv(std::span<const ProbeSummary> summaries)
{
    std::string csv =
        "method,rule,scenes,probed,ahead_before_m,ahead_after_m,all_before_m,all_after_m,"
        "probes_needed,settled\n";
    for (const ProbeSummary& p : summaries)
        csv += csvLine({p.label, p.rule, p.scenes, p.probed, fixed(p.before.ahead, 6),
                        fixed(p.after.ahead, 6), fixed(p.before.all, 6), fixed(p.after.all, 6),
                        fixed(p.probesNeeded, 4), p.settled});
    return csv;
}

std::string evaluationTable(std::span<const MethodSummary> summaries)
{
    std::string table = "|error|: median (quartiles) [mm]\n";
    addRow(table, "bin [m]", summaries, [](const MethodSummary& m) { return m.label; });
    for (int bin = 0; bin < kBins; ++bin)
        addRow(table, fmt::format("{:+.1f}", binCentre(bin)), summaries,
               [bin](const MethodSummary& m) {
                   return medianAndQuartiles(m.bin[static_cast<std::size_t>(bin)]);
               });
    addRow(table, "all bins", summaries,
           [](const MethodSummary& m) { return medianAndQuartiles(m.all); });
    addRow(table, "mean |error| [mm]", summaries,
           [](const MethodSummary& m) { return fmt::format("{:.1f}", millimetres(m.all.mean)); });
    addRow(table, "80 % band covers", summaries,
           [](const MethodSummary& m) { return percent(m.all.coverage, m.all.n); });
    addRow(table, "  sampled bins alone", summaries,
           [](const MethodSummary& m) { return percent(m.all.sampledCoverage, m.all.sampled); });
    addRow(table, "errors", summaries,
           [](const MethodSummary& m) { return fmt::format("{}", m.all.n); });
    return table;
}

std::string scoresTable(std::span<const MethodSummary> summaries,
                        std::span<const Confidence> confidences, std::span<const MethodTime> times)
{
    const std::vector<int> widths{12, 19, 19, 19, 19, 15, 6, 6, 7, 9};
    std::string table =
        "Scores [mm] and coverage [%], in brackets 95 % intervals over whole drives; median* of "
        "bins -0.3 to 0.5\n";
    table += row({"method", "median*", "median", "mean |error|", "CRPS", "80 % covers", "50 %",
                  "95 %", "width", "ms/scene"},
                 widths, 1);
    for (const MethodSummary& m : summaries) {
        const auto i = entryOf(m.label, confidences).intervals;
        table += row({m.label, withInterval(m.near.median, i, &ScoreIntervals::nearMedian, 1e3, 1),
                      withInterval(m.all.median, i, &ScoreIntervals::median, 1e3, 1),
                      withInterval(m.all.mean, i, &ScoreIntervals::mean, 1e3, 1),
                      withInterval(m.all.crps, i, &ScoreIntervals::crps, 1e3, 1),
                      withInterval(m.all.coverage, i, &ScoreIntervals::coverage, 100.0, 0),
                      fmt::format("{:.0f}", 100.0 * m.all.coverage50),
                      fmt::format("{:.0f}", 100.0 * m.all.coverage95),
                      fmt::format("{:.0f}", millimetres(m.all.width)),
                      fmt::format("{:.1f}", millimetres(entryOf(m.label, times).perScene))},
                     widths, 1);
    }
    return table;
}

std::string coverageTable(std::span<const MethodSummary> summaries)
{
    std::string table = "How often the 80 % band covers the truth\n";
    addRow(table, "bin [m]", summaries, [](const MethodSummary& m) { return m.label; });
    for (int bin = 0; bin < kBins; ++bin)
        addRow(table, fmt::format("{:+.1f}", binCentre(bin)), summaries,
               [bin](const MethodSummary& m) {
                   const ErrorStatistics& s = m.bin[static_cast<std::size_t>(bin)];
                   return percent(s.coverage, s.n);
               });
    return table;
}

std::string groupsTable(std::string_view kind, std::span<const GroupSummary> groups)
{
    const std::vector<int> widths{26, 12, 8, 9, 9, 9, 9};
    std::string table =
        fmt::format("By {}: |error| and CRPS [mm], how often the 80 % band covers\n", kind);
    table +=
        row({std::string(kind), "method", "scenes", "median", "mean", "CRPS", "covers"}, widths, 2);
    std::string before;
    for (const GroupSummary& g : groups) {
        table +=
            row({g.group == before ? std::string() : shortened(printable(g.group), 25), g.label,
                 fmt::format("{}", g.scenes), fmt::format("{:.1f}", millimetres(g.all.median)),
                 fmt::format("{:.1f}", millimetres(g.all.mean)),
                 fmt::format("{:.1f}", millimetres(g.all.crps)), percent(g.all.coverage, g.all.n)},
                widths, 2);
        before = g.group;
    }
    return table;
}

std::string stepsTable(std::span<const BrierSummary> summaries, double limit)
{
    const std::vector<int> widths{10, 12, 8, 9, 22, 12, 12, 12};
    std::string table =
        fmt::format("Is there a step of more than {:.0f} mm?\n", millimetres(limit));
    table += row({"place", "method", "scenes", "steps", "Brier score", "reliability", "resolution",
                  "uncertainty"},
                 widths, 2);
    for (const StepPlace place : kStepPlaces)
        for (const BrierSummary& b : summaries)
            if (b.place == place) table += brierRow(b, widths);
    for (const StepPlace place : kStepPlaces) table += reliabilityRows(summaries, place);
    return table;
}

std::string probesTable(std::span<const ProbeSummary> summaries, const ProbeLimits& limits)
{
    const std::vector<int> widths{12, 10, 8, 17, 17, 8, 17, 9, 10};
    std::string table = fmt::format(
        "Probes: mean |error| before and after one; how many until every sd is below {:.0f} mm "
        "(at most {})\n",
        millimetres(limits.sdLimit), limits.most);
    table += row({"method", "rule", "scenes", "0.6 and 0.7", "all bins", "probed", "0.6, 0.7 there",
                  "needed", "settled"},
                 widths, 2);
    const auto change = [](double before, double after) {
        return fmt::format("{:.1f} to {:.1f}", millimetres(before), millimetres(after));
    };
    for (const ProbeSummary& p : summaries)
        table +=
            row({p.label, p.rule, fmt::format("{}", p.scenes),
                 change(p.before.ahead, p.after.ahead), change(p.before.all, p.after.all),
                 fmt::format("{}", p.probed), change(p.beforeProbed.ahead, p.afterProbed.ahead),
                 fmt::format("{:.2f}", p.probesNeeded),
                 percent(static_cast<double>(p.settled)
                             / static_cast<double>(std::max<std::size_t>(p.scenes, 1)),
                         p.scenes)},
                widths, 2);
    return table;
}

std::string claimsText(std::span<const ClaimResult> results)
{
    std::string text;
    for (std::size_t k = 0; k < results.size(); ++k)
        text += fmt::format("{}. {}\n", k + 1, claimLine(results[k]));
    return text;
}

}  // namespace terratact
