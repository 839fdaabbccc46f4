#include "app/evaluation_report.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <stdexcept>

namespace terratact {
namespace {

double millimetres(double metres)
{
    return 1000.0 * metres;
}

/// "12 (5–31)": median and quartiles [mm].
std::string medianAndQuartiles(const ErrorStatistics& s)
{
    if (s.n == 0) return "-";
    return fmt::format("{:.0f} ({:.0f}–{:.0f})", millimetres(s.median), millimetres(s.q1),
                       millimetres(s.q3));
}

/// The text at the right end of `width` columns; fmt counts "–" as one.
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

std::string claimLine(const ClaimResult& r)
{
    const std::string head = fmt::format("{}: {}", r.claim.text, name(r.verdict));
    if (r.n == 0)
        return fmt::format("{}\n   no bin was estimated by both {} and {}", head,
                           name(r.claim.base), name(r.claim.better));
    const std::string medians =
        fmt::format("{}\n   median |error| {} {:.1f} mm, {} {:.1f} mm", head, name(r.claim.base),
                    millimetres(r.baseMedian), name(r.claim.better), millimetres(r.betterMedian));
    if (r.runs < kLeastRuns)
        return fmt::format("{}; {} of at least {} drives", medians, r.runs, kLeastRuns);
    return fmt::format(
        "{}; difference {:+.1f} mm, 95 % interval {:+.1f} … {:+.1f}; {} bins of {} drives", medians,
        millimetres(r.betterMedian - r.baseMedian), millimetres(r.low), millimetres(r.high), r.n,
        r.runs);
}

}  // namespace

std::string errorsCsv(std::span<const BinError> errors, std::span<const Scene> scenes)
{
    std::string csv = "run,t_s,method,bin_m,error_m,abs_error_m,in_band,source\n";
    auto out = std::back_inserter(csv);
    for (const BinError& e : errors) {
        if (e.scene >= scenes.size())
            throw std::invalid_argument("errorsCsv: an error of a scene that is not there");
        const Scene& scene = scenes[e.scene];
        fmt::format_to(out, "{},{},{},{:+.1f},{},{},{},{}\n", scene.run, scene.time, name(e.method),
                       binCentre(e.bin), e.error, std::abs(e.error), e.inBand ? 1 : 0,
                       name(e.origin));
    }
    return csv;
}

std::string fig8Csv(std::span<const ErrorHistogram> histograms)
{
    std::string csv = "method,from_m,to_m,count,share\n";
    auto out = std::back_inserter(csv);
    for (const ErrorHistogram& h : histograms)
        for (std::size_t k = 0; k < h.count.size(); ++k) {
            const auto edge = [&](std::size_t at) {
                return fmt::format("{:.6g}", h.width * static_cast<double>(at));
            };
            fmt::format_to(out, "{},{},{},{},{:.6f}\n", name(h.method), edge(k),
                           k + 1 < h.count.size() ? edge(k + 1) : std::string(), h.count[k],
                           static_cast<double>(h.count[k]) / static_cast<double>(h.n));
        }
    return csv;
}

std::string fig9Csv(std::span<const MethodSummary> summaries)
{
    std::string csv =
        "method,bin_m,n,q1_m,median_m,q3_m,mean_m,coverage,sampled,sampled_coverage\n";
    auto out = std::back_inserter(csv);
    for (const MethodSummary& summary : summaries)
        for (int bin = 0; bin < kBins; ++bin) {
            const ErrorStatistics& s = summary.bin[static_cast<std::size_t>(bin)];
            if (s.n == 0) continue;
            fmt::format_to(out, "{},{:+.1f},{},{:.6f},{:.6f},{:.6f},{:.6f},{:.4f},{},{}\n",
                           name(summary.method), binCentre(bin), s.n, s.q1, s.median, s.q3, s.mean,
                           s.coverage, s.sampled,
                           s.sampled > 0 ? fmt::format("{:.4f}", s.sampledCoverage)
                                         : std::string());
        }
    return csv;
}

std::string evaluationTable(std::span<const MethodSummary> summaries)
{
    std::string table = "|error|: median (quartiles) [mm]\n";
    addRow(table, "bin [m]", summaries,
           [](const MethodSummary& m) { return std::string(name(m.method)); });
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

std::string claimsText(std::span<const ClaimResult> results)
{
    std::string text;
    for (std::size_t k = 0; k < results.size(); ++k)
        text += fmt::format("{}. {}\n", k + 1, claimLine(results[k]));
    return text;
}

}  // namespace terratact
