#include "core/learn/data/ground_file.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "core/base/text.h"
#include "core/learn/data/profile_form.h"
#include "core/store/csv_field.h"

namespace terratact {
namespace {

constexpr double kMaxY = 2.0;                        // [m]
constexpr double kMinStep = 0.001, kMaxStep = 10.0;  // [m]
constexpr double kMaxLength = 1000.0;                // [m] as of a profile of points
constexpr std::size_t kMaxLines = 64;                // of one ground

/// Positions of the columns of a file of lines.
struct LineColumns {
    std::size_t y = 0, heights = 0;
    std::optional<std::size_t> ground, step;
};

Result<LineColumns> lineColumns(const CsvReader& csv)
{
    std::size_t count = csv.fields().size();
    while (count > 1 && csv.fields()[count - 1].empty()) --count;
    LineColumns columns;
    std::optional<std::size_t> y;
    for (std::size_t i = 0; i < count; ++i) {
        const std::string_view name = csv.fields()[i];
        std::optional<std::size_t>* const place = name == "y_m"    ? &y
                                                : name == "pair"   ? &columns.ground
                                                : name == "step_m" ? &columns.step
                                                                   : nullptr;
        if (!place) continue;
        if (*place) return csv.error("has the column " + std::string(name) + " twice");
        *place = i;
    }
    columns.y = *y;
    columns.heights = count - 1;
    const auto heights = std::ranges::find(csv.fields(), "heights_m") - csv.fields().begin();
    if (csv.fields()[columns.heights] != "heights_m")
        return csv.error("is a header with y_m and without heights_m as its last column");
    if (static_cast<std::size_t>(heights) != columns.heights)
        return csv.error("has the column heights_m twice");
    return columns;
}

/// Returns true for a record without a line of ground: of empty fields, or a remark.
bool isNoLine(const CsvReader& csv, const LineColumns& columns)
{
    const auto isEmpty = [](std::string_view field) { return field.empty(); };
    if (std::ranges::all_of(csv.fields(), isEmpty)) return true;
    return csv.fields().front().starts_with('#')
        && (csv.fields().size() <= columns.heights || !csv.isNumber(columns.y));
}

/// Returns true if the record below the header gives the unit of y instead of a number.
bool givesUnits(const CsvReader& csv, const LineColumns& columns)
{
    if (csv.fields().size() <= columns.y) return false;
    const std::string_view y = csv.fields()[columns.y];
    return y == "m" || y == "[m]" || y == "(m)";
}

/// Collects lines to grounds.
class LineCollector {
public:
    LineCollector(LineColumns columns, double step, bool blocks)
        : columns_(columns), step_(step), blocks_(blocks)
    {
    }

    Status add(CsvReader& csv)
    {
        if (csv.fields().size() <= columns_.heights)
            return csv.error("has no heights, expected them from field "
                             + std::to_string(columns_.heights + 1) + " on");
        if (csv.fields()[columns_.heights] == "heights_m") return csv.error(kSecondTable);
        if (Status status = begin(csv); !status) return status;
        const Result<double> y = numberIn(csv, columns_.y, "y_m", -kMaxY, kMaxY);
        if (!y) return y.error();
        const auto sameY = [&](const GroundLine& line) { return line.y == *y; };
        if (std::ranges::any_of(lines_, sameY))
            return csv.error("y_m is " + numberText(*y) + " again in the same ground");
        if (lines_.size() == kMaxLines)
            return csv.error("is one line more than the " + std::to_string(kMaxLines)
                             + " of one ground");
        const Result<double> step = columns_.step
                                      ? numberIn(csv, *columns_.step, "step_m", kMinStep, kMaxStep)
                                      : Result<double>(step_);
        if (!step) return step.error();
        Result<std::vector<double>> heights = heightsOf(csv);
        if (!heights) return heights.error();
        if (static_cast<double>(heights->size() - 1) * *step > kMaxLength)
            return csv.error("is longer than " + numberText(kMaxLength)
                             + " m: is step_m in metres?");
        lines_.push_back({*y, TerrainProfile::fromSamples(*heights, *step, blocks_)});
        return Done{};
    }

    Result<GroundFile> finish(const CsvReader& csv)
    {
        finishGround();
        if (file_.grounds.empty()) return csv.error("is a header, and no line follows it");
        return std::move(file_);
    }

private:
    static Result<double> numberIn(CsvReader& csv, std::size_t field, std::string_view what,
                                   double least, double most)
    {
        Result<double> value = csv.number(field, what);
        if (value && !(*value >= least && *value <= most))
            return csv.error(std::string(what) + " is " + numberText(*value) + ", expected "
                             + numberText(least) + " to " + numberText(most));
        return value;
    }

    Result<std::vector<double>> heightsOf(CsvReader& csv)
    {
        std::size_t end = csv.fields().size();
        while (end > columns_.heights && csv.fields()[end - 1].empty()) --end;
        Result<std::vector<double>> heights = numbersOf(csv, columns_.heights, end);
        if (!heights) return heights;
        count_ += heights->size();
        if (count_ > kMaxProfileNumbers)
            return csv.error("goes beyond the " + std::to_string(kMaxProfileNumbers)
                             + " numbers allowed in a file");
        if (heights->size() < 2)
            return csv.error("has fewer than the two heights that a line needs");
        if (lines_.empty()) first_ = heights->front();
        for (const double height : *heights)
            if (Status status = checkHeight(csv, height, first_); !status) return status.error();
        return heights;
    }

    /// Finishes the ground before if this line begins another.
    Status begin(const CsvReader& csv)
    {
        const std::string name(columns_.ground ? csv.fields()[*columns_.ground] : "");
        if (name != name_) finishGround();
        if (finished_.contains(name))
            return csv.error("is of pair " + shown(name)
                             + ", whose lines do not stand together: others precede it");
        name_ = name;
        return Done{};
    }

    void finishGround()
    {
        if (lines_.empty()) return;
        finished_.insert(name_);
        file_.grounds.emplace_back(std::exchange(lines_, {}));
    }

    LineColumns columns_;
    double step_;
    bool blocks_;
    std::string name_;
    std::set<std::string> finished_;
    std::vector<GroundLine> lines_;  ///< of the ground that is being read
    double first_ = 0.0;             ///< first height of that ground [m]
    std::size_t count_ = 0;          ///< numbers of the whole file
    GroundFile file_;
};

Result<GroundFile> readGroundLines(CsvReader csv, double step, bool blocks)
{
    const Result<LineColumns> columns = lineColumns(csv);
    if (!columns) return columns.error();
    LineCollector collector(*columns, step, blocks);
    for (bool unitsMayFollow = true;;) {
        const Result<bool> more = csv.next();
        if (!more) return more.error();
        if (!*more) return collector.finish(csv);
        if (isNoLine(csv, *columns)) continue;
        if (std::exchange(unitsMayFollow, false) && givesUnits(csv, *columns)) continue;
        if (const Status status = collector.add(csv); !status) return status.error();
    }
}

}  // namespace

Result<GroundFile> readGrounds(const std::string& path, double step, bool blocks)
{
    Result<CsvReader> csv = CsvReader::open(path);
    if (!csv) return csv.error();
    return readGrounds(*std::move(csv), step, blocks);
}

Result<GroundFile> readGrounds(CsvReader csv, double step, bool blocks)
{
    if (!(step > 0.0) || !std::isfinite(step))
        throw std::invalid_argument("readGrounds: step is not above 0");
    if (const Result<bool> first = csv.next(); !first) return first.error();
    if (namesLines(csv)) return readGroundLines(std::move(csv), step, blocks);
    Result<ProfileFile> file = readProfilesFromHere(std::move(csv), step, blocks);
    if (!file) return file.error();
    GroundFile grounds;
    for (TerrainProfile& profile : file->profiles) grounds.grounds.emplace_back(std::move(profile));
    return grounds;
}

}  // namespace terratact
