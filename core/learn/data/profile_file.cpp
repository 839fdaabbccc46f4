#include "core/learn/data/profile_file.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/base/text.h"
#include "core/learn/data/profile_form.h"
#include "core/store/file_read.h"

namespace terratact {
namespace {

constexpr double kMaxX = 1000.0;  ///< [m]

bool isHeader(const CsvReader& csv)
{
    const auto isLetter = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z')
            || static_cast<unsigned char>(c) > 127;
    };
    std::size_t named = csv.fields().size();
    while (named > 1 && csv.fields()[named - 1].empty()) --named;
    for (std::size_t i = 0; i < named; ++i)
        if (csv.isNumber(i) || csv.isMissing(i) || std::ranges::none_of(csv.fields()[i], isLetter))
            return false;
    return true;
}

/// Returns true if one of more than two columns has the name of a point's column. The lines are
/// then no heights.
bool namesMoreThanPoints(const CsvReader& csv)
{
    const auto isOfPoints = [](std::string_view name) {
        return name == "x" || name == "z" || name == "x_m" || name == "z_m" || name == "X"
            || name == "Z";
    };
    return csv.fields().size() > 2 && std::ranges::any_of(csv.fields(), isOfPoints);
}

bool namesPoints(const CsvReader& csv)
{
    const auto& names = csv.fields();
    return (names[0] == "x" && names[1] == "z") || (names[0] == "x_m" && names[1] == "z_m");
}

/// Detects heights whose decimal commas may be separators: all fields are integers. "0,05" then
/// reads as 0 and 5.
class DecimalCommas {
public:
    void add(const CsvReader& csv)
    {
        for (const std::string_view field : csv.fields()) {
            const std::string_view digits = field.starts_with('-') ? field.substr(1) : field;
            const bool isWhole =
                std::ranges::all_of(digits, [](char c) { return c >= '0' && c <= '9'; });
            allWhole_ = allWhole_ && isWhole;
            anyLikeFraction_ =
                anyLikeFraction_ || (isWhole && digits.size() > 1 && digits[0] == '0');
        }
    }

    /// Returns true if a field has leading zeros, which no integer has but many fractions have.
    bool certain() const { return allWhole_ && anyLikeFraction_; }
    bool possible() const { return allWhole_; }

private:
    bool allWhole_ = true, anyLikeFraction_ = false;
};

/// Reads lines of points into one profile, starting with the current line.
class PointReader {
public:
    /// headed: the header names the columns x and z.
    explicit PointReader(bool headed) : headed_(headed) {}

    Status add(const CsvReader& csv, const std::vector<double>& line)
    {
        if (line.size() != 2)
            return csv.error("has " + std::to_string(line.size())
                             + " fields where the lines before have x,z");
        commas_.add(csv);
        const Vec2 point{line[0], line[1]};
        if (std::abs(point.x) > kMaxX)
            return csv.error("x is " + numberText(point.x) + ", beyond ±1000 m (is it in mm?)");
        if (!points_.empty() && point.x < points_.back().x)
            return csv.error("x decreases from " + numberText(points_.back().x) + " to "
                             + numberText(point.x));
        sameX_ = !points_.empty() && point.x == points_.back().x ? sameX_ + 1 : 1;
        mostOfOneX_ = std::max(mostOfOneX_, sameX_);
        points_.push_back(point);
        const Status height = checkHeight(csv, point.z, points_.front().z);
        return height || headed_ || !commas_.possible() ? height : oneColumn(csv);
    }

    Result<ProfileFile> finish(const CsvReader& csv)
    {
        if (points_.size() < 2) return csv.error("is the only point, and a profile needs two");
        if (points_.front().x == points_.back().x)
            return fileError(csv.name(), "x does not advance: all are "
                                             + numberText(points_.front().x)
                                             + ": is this one column with decimal commas?");
        // A vertical face has two points at one x.
        if (!headed_ && (commas_.certain() || (commas_.possible() && mostOfOneX_ > 2)))
            return oneColumn(csv);
        return ProfileFile{{TerrainProfile(std::move(points_))}};
    }

private:
    static Error oneColumn(const CsvReader& csv)
    {
        return fileError(csv.name(), "is this one column with decimal commas? save it with a "
                                     "point; points in whole metres need the header x_m,z_m");
    }

    bool headed_;
    std::vector<Vec2> points_;
    DecimalCommas commas_;
    int sameX_ = 0, mostOfOneX_ = 0;  ///< consecutive points
};

/// Reads every line of heights as a profile.
class HeightReader {
public:
    HeightReader(double step, bool blocks) : step_(step), blocks_(blocks) {}

    Status add(const CsvReader& csv, const std::vector<double>& line)
    {
        if (line.size() < 3)
            return csv.error("has " + std::to_string(line.size())
                             + " fields, and a profile needs three heights, all in one line");
        DecimalCommas commas;
        commas.add(csv);
        if (commas.certain() || (commas.possible() && alternates(line)))
            return csv.error("has whole numbers alone: are these heights with decimal commas? save "
                             "them with a point");
        for (const double height : line)
            if (Status status = checkHeight(csv, height, line.front()); !status) return status;
        file_.profiles.push_back(TerrainProfile::fromSamples(line, step_, blocks_));
        return Done{};
    }

    Result<ProfileFile> finish(const CsvReader&) { return std::move(file_); }

private:
    /// Returns true if every other number is equal, like the metres of heights below 1 m, and the
    /// others differ.
    static bool alternates(const std::vector<double>& line)
    {
        if (line.size() < 6 || line.size() % 2 != 0) return false;
        bool othersDiffer = false;
        for (std::size_t i = 2; i < line.size(); i += 2) {
            if (line[i] != line[0]) return false;
            othersDiffer = othersDiffer || line[i + 1] != line[1];
        }
        return othersDiffer;
    }

    double step_;
    bool blocks_;
    ProfileFile file_;
};

/// Reads the current line and all that follow.
template <class Reader>
Result<ProfileFile> readLines(CsvReader& csv, Reader reader)
{
    std::size_t count = 0;
    for (;;) {
        count += csv.fields().size();
        if (count > kMaxProfileNumbers)
            return csv.error("goes beyond the " + std::to_string(kMaxProfileNumbers)
                             + " numbers allowed in a file");
        const Result<std::vector<double>> line = numbersOf(csv, 0, csv.fields().size());
        if (!line) return line.error();
        if (const Status status = reader.add(csv, *line); !status) return status.error();
        const Result<bool> more = csv.next();
        if (!more) return more.error();
        if (!*more) return reader.finish(csv);
    }
}

/// Checks a header that is the current record, and goes to the next one. Returns its number of fields.
Result<std::size_t> readHeader(CsvReader& csv)
{
    csv.useAsHeader(std::vector<std::string>(csv.fields().size(), "m"));
    const std::size_t headed = csv.fields().size();
    if (namesMoreThanPoints(csv))
        return csv.error("is a header of " + std::to_string(headed)
                         + " columns: a profile has the two columns x_m,z_m alone");
    if (headed == 2 && !namesPoints(csv))
        return csv.error("is a header of two columns other than x,z or x_m,z_m");
    if (headed == 1)
        return csv.error("is a header of one column: a profile has points x,z, or its heights "
                         "in one line");
    const Result<bool> more = csv.next();
    if (!more) return more.error();
    if (!*more) return csv.error("is a header, and no profile follows it");
    return headed;
}

}  // namespace

bool namesLines(const CsvReader& csv)
{
    return std::ranges::find(csv.fields(), "y_m") != csv.fields().end();
}

Result<std::vector<double>> numbersOf(CsvReader& csv, std::size_t begin, std::size_t end)
{
    std::vector<double> values;
    for (std::size_t i = begin; i < end; ++i) {
        const Result<double> value = csv.number(i, "field " + std::to_string(i + 1));
        if (!value) return value.error();
        values.push_back(*value);
    }
    return values;
}

Status checkHeight(const CsvReader& csv, double height, double first)
{
    constexpr double kMaxRise = 5.0;  // [m] largest distance from the profile's first height
    if (std::abs(height) > kFarthest)
        return csv.error("the height " + numberText(height)
                         + " is more than 1000 km from 0: is it a height in metres?");
    if (std::abs(height - first) <= kMaxRise) return Done{};
    return csv.error("the height " + numberText(height)
                     + " is more than 5 m from the profile's first, " + numberText(first)
                     + " (is it in mm?)");
}

Result<ProfileFile> readProfilesFromHere(CsvReader csv, double step, bool blocks)
{
    std::size_t headed = 0;  // fields of the header
    if (isHeader(csv)) {
        const Result<std::size_t> fields = readHeader(csv);
        if (!fields) return fields.error();
        headed = *fields;
    }
    const std::size_t fields = headed != 0 ? headed : csv.fields().size();
    if (fields == 2) return readLines(csv, PointReader(headed != 0));
    return readLines(csv, HeightReader(step, blocks));
}

Result<ProfileFile> readProfiles(const std::string& path, double step, bool blocks)
{
    Result<CsvReader> csv = CsvReader::open(path);
    if (!csv) return csv.error();
    return readProfiles(*std::move(csv), step, blocks);
}

Result<ProfileFile> readProfiles(CsvReader csv, double step, bool blocks)
{
    if (!(step > 0.0) || !std::isfinite(step))
        throw std::invalid_argument("readProfiles: step is not above 0");
    if (const Result<bool> first = csv.next(); !first) return first.error();
    if (namesLines(csv))
        return csv.error("has a column y_m: this command takes profiles of one plane, without y");
    return readProfilesFromHere(std::move(csv), step, blocks);
}

}  // namespace terratact
