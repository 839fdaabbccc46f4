#include "app/modelling/tradeoff_csv.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "core/store/csv_reader.h"
#include "core/store/csv_text.h"

namespace terratact {

namespace {

constexpr std::string_view kPresetColumns =
    "model,method,quality,draws,chains,burn_in,inducing,ms,quantile_off_mm,error_mm,converged";

std::string inducingName(int rows)
{
    return rows == 0 ? "all" : std::to_string(rows);
}

/// Returns the mark for the Pareto fronts of a point.
std::string_view mark(const TradeFronts& fronts, std::size_t point)
{
    if (fronts.reference[point]) return fronts.truth[point] ? " *+" : " *";
    return fronts.truth[point] ? "  +" : "";
}

Result<PresetCost> presetFrom(CsvReader& csv)
{
    const auto& fields = csv.fields();
    if (fields.size() != 11) return csv.error("has not eleven fields");
    const auto method = methodFromName(fields[1]);
    const auto preset = qualityPresetFromName(fields[2]);
    if (!method) return csv.error("names no method");
    if (!preset) return csv.error("names no quality");
    std::array<double, 8> values{};
    for (std::size_t k = 0; k < values.size(); ++k) {
        const Result<double> value = csv.number(k + 3, "field " + std::to_string(k + 4));
        if (!value) return value.error();
        values[k] = *value;
    }
    const auto [draws, chains, burnIn, inducing, milliseconds, offMm, errorMm, converged] = values;
    for (const double count : {draws, chains, burnIn, inducing})
        if (!(count >= 0.0 && count <= kMaxDraws && count == std::floor(count)))
            return csv.error("has draws, chains, burn_in or inducing that are no count");
    if (!(milliseconds >= 0.0 && offMm >= 0.0 && errorMm >= 0.0))
        return csv.error("has a time or a distance below 0");
    if (!(converged >= 0.0 && converged <= 1.0))
        return csv.error("has a share that is not between 0 and 1");
    return PresetCost{.method = *method,
                      .preset = *preset,
                      .draws = static_cast<int>(draws),
                      .chains = static_cast<int>(chains),
                      .burnIn = static_cast<int>(burnIn),
                      .inducing = static_cast<int>(inducing),
                      .milliseconds = milliseconds,
                      .offMm = offMm,
                      .errorMm = errorMm,
                      .converged = converged};
}

}  // namespace

std::string tradeoffCsv(std::span<const TradePoint> points)
{
    const TradeFronts fronts = tradeFronts(points);
    std::string text = "method,varied,draws,chains,burn_in,precision,inducing,used,converged,ms,"
                       "mean_off_mm,quantile_off_mm,error_mm,crps_mm,front_reference,front_truth\n";
    for (std::size_t k = 0; k < points.size(); ++k) {
        const TradePoint& p = points[k];
        const Settings& s = p.setting.settings;
        text +=
            csvLine({name(s.method), p.setting.varied, s.draws, s.chains, s.burnIn,
                     name(s.precision), inducingName(s.inducing), p.draws, rounded(p.converged, 4),
                     rounded(1e3 * p.seconds, 4), rounded(1e3 * p.reference.mean, 4),
                     rounded(1e3 * p.reference.quantile, 4), rounded(1e3 * p.error, 4),
                     rounded(1e3 * p.crps, 4), static_cast<bool>(fronts.reference[k]),
                     static_cast<bool>(fronts.truth[k])});
    }
    return text;
}

std::string tradeoffTable(std::span<const TradePoint> points)
{
    const TradeFronts fronts = tradeFronts(points);
    std::string text =
        "per scene: draws that were used of those allowed (median), share of scenes that "
        "converged, time, and how far means and 0.1/0.9 quantiles lie from a long run [mm]; error "
        "and CRPS against the truth [mm]; * on its method's Pareto front of time and quantiles, + "
        "on that of time and error of all\n\n";
    text += fmt::format("{:<10} {:<11} {:>6} {:>6} {:>7} {:>9} {:>8} {:>6} {:>9} {:>9} {:>7} {:>9} "
                        "{:>7} {:>6}\n",
                        "method", "varied", "draws", "chains", "burn-in", "precision", "inducing",
                        "used", "converged", "ms", "means", "quantiles", "|error|", "CRPS");
    for (std::size_t k = 0; k < points.size(); ++k) {
        const TradePoint& p = points[k];
        const Settings& s = p.setting.settings;
        text += fmt::format(
            "{:<10} {:<11} {:>6} {:>6} {:>7} {:>9} {:>8} {:>6} {:>8.0f}% {:>9.3g} {:>7.2f} "
            "{:>9.2f} {:>7.1f} {:>6.1f}{}\n",
            name(s.method), p.setting.varied, s.draws, s.chains, s.burnIn, name(s.precision),
            inducingName(s.inducing), p.draws, 100.0 * p.converged, 1e3 * p.seconds,
            1e3 * p.reference.mean, 1e3 * p.reference.quantile, 1e3 * p.error, 1e3 * p.crps,
            mark(fronts, k));
    }
    return text;
}

std::string presetsCsv(std::string_view model, std::span<const TradePoint> points)
{
    std::string text(kPresetColumns);
    text += '\n';
    for (const TradePoint& p : points) {
        if (!p.setting.preset) continue;
        const Settings& s = p.setting.settings;
        text += csvLine({model, name(s.method), name(*p.setting.preset), s.draws, s.chains,
                         s.burnIn, s.inducing, rounded(1e3 * p.seconds, 3),
                         rounded(1e3 * p.reference.quantile, 3), rounded(1e3 * p.error, 3),
                         rounded(p.converged, 3)});
    }
    return text;
}

Result<PresetTable> readPresets(const std::string& path)
{
    Result<CsvReader> csv = CsvReader::open(path);
    if (!csv) return csv.error();
    if (const Result<bool> header = csv->next(); !header) return header.error();
    if (fmt::format("{}", fmt::join(csv->fields(), ",")) != kPresetColumns)
        return csv->error(fmt::format("is not the header {}", kPresetColumns));
    PresetTable table;
    for (;;) {
        const Result<bool> more = csv->next();
        if (!more) return more.error();
        if (!*more) return table;
        const Result<PresetCost> cost = presetFrom(*csv);
        if (!cost) return cost.error();
        const std::string_view model = csv->fields().front();
        if (!table.costs.empty() && model != table.model)
            return csv->error("is of another model than the lines before");
        table.model = model;
        table.costs.push_back(*cost);
    }
}

}  // namespace terratact
