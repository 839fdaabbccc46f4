#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/base/text.h"
#include "core/clouds/cloud_fields.h"
#include "core/clouds/cloud_formats.h"
#include "core/store/csv_field.h"

namespace terratact {
namespace {

bool isTextRemark(std::string_view line)
{
    return line.starts_with('#') || line.starts_with("//");
}

/// Returns the axis that a column names: "x", "X", "x_m", "//X", "Points:0"; 3: none.
std::size_t axisNamed(std::string_view name)
{
    std::string text = lowerCase(name);
    text.erase(0, text.find_first_not_of("/#\""));
    while (text.ends_with('"')) text.pop_back();
    for (std::size_t k = 0; k < 3; ++k) {
        const std::string axis(1, "xyz"[k]);
        for (const std::string& known :
             {axis, axis + "_m", axis + "[m]", "points:" + std::to_string(k)})
            if (text == known) return k;
    }
    return 3;
}

class TextCloud : public CloudReader {
public:
    explicit TextCloud(CloudFile file) : file_(std::move(file)) {}
    std::string_view format() const override { return "text"; }

    Result<bool> next(std::vector<CloudPoint>& block) override
    {
        block.clear();
        std::size_t lines = 0;
        for (; block.size() < kCloudBlock && lines < 4 * kCloudBlock; ++lines) {
            const auto more = file_.line(line_);
            if (!more) return more.error();
            if (!*more) return finish(!block.empty() || lines > 0);
            if (!begun_ && nameColumns()) continue;
            if (isTextRemark(line_)) continue;
            splitCloudFields(line_, fields_);
            if (fields_.empty()) continue;
            if (!begun_ && fields_.size() == 1 && integerFrom<std::uint64_t>(fields_[0])) {
                begun_ = true;  // PTS: the number of points
                continue;
            }
            begun_ = true;
            if (Status added = addLine(block); !added) return added.error();
        }
        return true;
    }

private:
    Result<bool> finish(bool more)
    {
        if (points() == 0)
            return file_.error("holds no point: lines with x y z in m were expected");
        return more;
    }

    /// Returns true if the line names the columns; a comment may.
    bool nameColumns()
    {
        std::string_view names = line_;
        names.remove_prefix(std::min(names.find_first_not_of("#/ \t"), names.size()));
        splitCloudFields(names, fields_);
        std::array<std::size_t, 3> found{};
        std::array<bool, 3> known{};
        for (std::size_t i = 0; i < fields_.size(); ++i)
            if (const std::size_t axis = axisNamed(fields_[i]); axis < 3 && !known.at(axis)) {
                known.at(axis) = true;
                found.at(axis) = i;
            }
        if (!std::ranges::all_of(known, [](bool b) { return b; })) return false;
        columns_ = found;
        begun_ = true;
        return true;
    }

    Status addLine(std::vector<CloudPoint>& block)
    {
        std::array<double, 3> xyz{};
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t column = columns_.at(k);
            if (column >= fields_.size())
                return file_.lineError(
                    fmt::format("has {} fields: x, y and z were expected", fields_.size()));
            const auto value = cloudCoordinate(fields_[column]);
            if (!value)
                return file_.lineError(
                    fmt::format("{} is {}, and no number: a cloud as text has x, y "
                                "and z in m first, or a first line that names them",
                                std::string(1, "xyz"[k]), shown(fields_[column])));
            xyz.at(k) = *value;
        }
        add(block, {xyz[0], xyz[1], xyz[2]});
        return Done{};
    }

    CloudFile file_;
    std::string line_;
    std::vector<std::string_view> fields_;
    std::array<std::size_t, 3> columns_{0, 1, 2};
    bool begun_ = false;
};

}  // namespace

Result<std::unique_ptr<CloudReader>> openTextCloud(CloudFile file)
{
    return std::unique_ptr<CloudReader>(std::make_unique<TextCloud>(std::move(file)));
}

}  // namespace terratact
