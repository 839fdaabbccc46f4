#include "core/learn/data/probe_file.h"

#include <cmath>
#include <map>
#include <utility>

#include "core/base/text.h"
#include "core/store/csv_text.h"

namespace terratact {
namespace {

constexpr double kMaxHeight = 5.0;   // [m]
constexpr double kSameTruth = 1e-4;  // [m] rounding alone makes smaller differences

/// First truth of each place, with its line.
using PlaceTruths = std::map<std::string, std::pair<double, int>>;

Result<double> height(CsvReader& csv, std::size_t field, std::string_view name)
{
    Result<double> value = csv.number(field, name);
    if (value && std::abs(*value) > kMaxHeight)
        return csv.error(std::string(name) + " is " + numberText(*value)
                         + ", beyond ±5 m (is it in mm?)");
    return value;
}

Result<ProbeReading> reading(CsvReader& csv)
{
    ProbeReading result;
    result.place = csvText(csv.fields()[0]);
    if (result.place.empty()) return csv.error("names no place");
    const Result<double> read = height(csv, 1, "height_m");
    if (!read) return read.error();
    result.height = *read;
    if (csv.isMissing(2)) return result;
    const Result<double> truth = height(csv, 2, "truth_m");
    if (!truth) return truth.error();
    result.truth = *truth;
    return result;
}

/// Error: an earlier line gives the place another truth.
Status requireOneTruth(const ProbeReading& given, PlaceTruths& truths, const CsvReader& csv)
{
    if (!given.truth) return Done{};
    const auto& [truth, line] =
        truths.try_emplace(given.place, *given.truth, csv.line()).first->second;
    if (std::abs(*given.truth - truth) <= kSameTruth) return Done{};
    return csv.error("truth_m of place " + shown(given.place) + " is " + numberText(*given.truth)
                     + ", and " + numberText(truth) + " in line " + std::to_string(line)
                     + ": a place has one truth");
}

}  // namespace

Result<std::vector<ProbeReading>> readProbeReadings(const std::string& path)
{
    Result<CsvReader> csv = CsvReader::open(path);
    if (!csv) return csv.error();
    return readProbeReadings(*std::move(csv));
}

Result<std::vector<ProbeReading>> readProbeReadings(CsvReader csv)
{
    if (const Result<bool> header = csv.next(); !header) return header.error();
    const auto& names = csv.fields();
    if (names.size() != 3 || names[0] != "place" || names[1] != "height_m" || names[2] != "truth_m")
        return csv.error("is not the header place,height_m,truth_m");
    csv.useAsHeader({"", "m", "m"});
    std::vector<ProbeReading> readings;
    PlaceTruths truths;
    for (;;) {
        const Result<bool> more = csv.next();
        if (!more) return more.error();
        if (!*more) break;
        if (readings.size() == kMaxProbeReadings)
            return csv.error("is one reading more than the " + std::to_string(kMaxProbeReadings)
                             + " allowed in a file");
        const Result<ProbeReading> next = reading(csv);
        if (!next) return next.error();
        if (Status s = requireOneTruth(*next, truths, csv); !s) return s.error();
        readings.push_back(*next);
    }
    if (readings.empty()) return csv.error("is a header, and no reading follows it");
    return readings;
}

}  // namespace terratact
