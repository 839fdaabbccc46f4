#include "core/learn/profile_file.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/text.h"

namespace terratact {
namespace {

constexpr double kMostHeight = 5.0;  ///< [m] from the profile's first
constexpr double kMostX = 1000.0;    ///< [m]

bool isHeader(const CsvReader& csv)
{
    return std::none_of(csv.fields().begin(), csv.fields().end(),
                        [](std::string_view field) { return field.empty() || numberFrom(field); });
}

bool namesPoints(const CsvReader& csv)
{
    const auto& names = csv.fields();
    return (names[0] == "x" && names[1] == "z") || (names[0] == "x_m" && names[1] == "z_m");
}

/// The numbers of a line.
Result<std::vector<double>> numbers(const CsvReader& csv)
{
    std::vector<double> values;
    for (std::size_t i = 0; i < csv.fields().size(); ++i) {
        const Result<double> value = csv.number(i, "field " + std::to_string(i + 1));
        if (!value) return value.error();
        values.push_back(*value);
    }
    return values;
}

/// Done where a height is believable beside the profile's first.
Status checkHeight(const CsvReader& csv, double height, double first)
{
    if (std::abs(height - first) <= kMostHeight) return Done{};
    return csv.error("the height " + numberText(height)
                     + " is more than 5 m from the profile's first, " + numberText(first)
                     + " (is it in mm?)");
}

/// Reads lines of points into one profile, the present line being the first.
class PointReader {
public:
    Status take(const CsvReader& csv, const std::vector<double>& line)
    {
        if (line.size() != 2)
            return csv.error("has " + std::to_string(line.size())
                             + " fields where the lines before have x,z");
        const Vec2 point{line[0], line[1]};
        if (std::abs(point.x) > kMostX)
            return csv.error("x is " + numberText(point.x) + ", beyond ±1000 m (is it in mm?)");
        if (!points_.empty() && point.x < points_.back().x)
            return csv.error("x decreases from " + numberText(points_.back().x) + " to "
                             + numberText(point.x));
        points_.push_back(point);
        return checkHeight(csv, point.z, points_.front().z);
    }

    Result<ProfileFile> finish(const CsvReader& csv)
    {
        if (points_.size() < 2) return csv.error("is the only point, and a profile needs two");
        return ProfileFile{{TerrainProfile(std::move(points_))}};
    }

private:
    std::vector<Vec2> points_;
};

/// Reads every line of heights as a profile.
class HeightReader {
public:
    /// fields: how many every line must have, 0 for any number.
    HeightReader(double step, bool blocks, std::size_t fields)
        : step_(step), blocks_(blocks), fields_(fields)
    {
    }

    Status take(const CsvReader& csv, const std::vector<double>& line)
    {
        if (line.size() < 3)
            return csv.error("has " + std::to_string(line.size())
                             + " fields, and a profile needs three heights");
        if (fields_ != 0 && line.size() != fields_)
            return csv.error("has " + std::to_string(line.size()) + " fields where the header has "
                             + std::to_string(fields_));
        for (const double height : line)
            if (Status status = checkHeight(csv, height, line.front()); !status) return status;
        file_.profiles.push_back(TerrainProfile::fromSamples(line, step_, blocks_));
        return Done{};
    }

    Result<ProfileFile> finish(const CsvReader&) { return std::move(file_); }

private:
    double step_;
    bool blocks_;
    std::size_t fields_;
    ProfileFile file_;
};

/// Takes the present line and all that follow.
template <class Reader>
Result<ProfileFile> readLines(CsvReader& csv, Reader reader)
{
    std::size_t count = 0;
    for (;;) {
        count += csv.fields().size();
        if (count > kMostProfileNumbers)
            return csv.error("goes beyond the " + std::to_string(kMostProfileNumbers)
                             + " numbers allowed in a file");
        const Result<std::vector<double>> line = numbers(csv);
        if (!line) return line.error();
        if (const Status status = reader.take(csv, *line); !status) return status.error();
        const Result<bool> more = csv.next();
        if (!more) return more.error();
        if (!*more) return reader.finish(csv);
    }
}

}  // namespace

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

    std::size_t headed = 0;  // fields of the header
    if (isHeader(csv)) {
        headed = csv.fields().size();
        if (headed == 2 && !namesPoints(csv))
            return csv.error("is a header of two columns other than x,z or x_m,z_m");
        const Result<bool> more = csv.next();
        if (!more) return more.error();
        if (!*more) return csv.error("is a header, and no profile follows it");
    }
    const std::size_t fields = headed != 0 ? headed : csv.fields().size();
    if (fields == 2) return readLines(csv, PointReader{});
    return readLines(csv, HeightReader(step, blocks, headed));
}

}  // namespace terratact
