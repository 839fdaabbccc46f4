#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>

#include "core/base/text.h"
#include "core/clouds/cloud_fields.h"
#include "core/clouds/cloud_formats.h"
#include "core/clouds/cloud_value.h"
#include "core/clouds/lzf_stream.h"

namespace terratact {
namespace {

constexpr std::size_t kMaxPcdFields = 256, kMaxPcdHeaderLines = 200;
constexpr std::uint64_t kMaxPcdPoint = 65'536;  // [bytes]
// Most bytes that compressed ones may become: kSmallPcd, or kMaxPcdExpansion times as many.
constexpr std::uint64_t kSmallPcd = std::uint64_t{16} << 20U, kMaxPcdExpansion = 32;

struct PcdField {
    std::string name;
    std::optional<CloudNumber> number;  ///< empty: cannot be read, and only passed over
    std::uint64_t size = 4, count = 1;
    std::uint64_t offset = 0;  ///< [bytes] in a point
    std::uint64_t column = 0;  ///< first word in a line of DATA ascii
};

struct PcdHeader {
    std::vector<PcdField> fields;
    std::vector<std::string> sizes, types, counts;
    std::optional<std::uint64_t> width, height, points;
    std::string data;
    std::array<std::size_t, 3> xyz{};  ///< indices of the fields
    std::uint64_t stride = 0;          ///< [bytes] of a point
};

class PcdHeaderReader {
public:
    explicit PcdHeaderReader(CloudFile& file) : file_(file) {}

    Result<PcdHeader> read()
    {
        std::string line;
        for (std::size_t i = 0; header_.data.empty(); ++i) {
            const auto more = file_.line(line);
            if (!more) return more.error();
            if (!*more || i == kMaxPcdHeaderLines)
                return file_.error("has no line DATA in its PCD header: it is cut; write it again");
            if (Status done = addLine(line); !done) return done.error();
        }
        if (Status done = complete(); !done) return done.error();
        return std::move(header_);
    }

private:
    Status addLine(const std::string& line)
    {
        std::istringstream words(line);
        std::string key, word;
        words >> key;
        std::vector<std::string> values;
        while (words >> word && values.size() <= kMaxPcdFields) values.push_back(word);
        if (key.empty() || key.starts_with('#') || key == "VERSION" || key == "VIEWPOINT")
            return Done{};
        if (values.empty() || values.size() > kMaxPcdFields)
            return file_.lineError(
                fmt::format("{} needs 1 to {} values", shown(key), kMaxPcdFields));
        lineOf_[key == "COLUMNS" ? "FIELDS" : key] = file_.lines();
        if (key == "FIELDS" || key == "COLUMNS") {
            header_.fields.clear();
            for (const std::string& name : values)
                header_.fields.push_back({.name = name, .number = {}});
        } else if (key == "SIZE") {
            header_.sizes = values;
        } else if (key == "TYPE") {
            header_.types = values;
        } else if (key == "COUNT") {
            header_.counts = values;
        } else if (key == "DATA") {
            header_.data = values.front();
        } else if (key == "WIDTH" || key == "HEIGHT" || key == "POINTS") {
            return addNumber(key, values.front());
        } else {
            return file_.lineError(fmt::format(
                "{} is no key of a PCD header: FIELDS, SIZE, TYPE, COUNT, WIDTH, HEIGHT, "
                "VIEWPOINT, POINTS and DATA are",
                shown(key)));
        }
        return Done{};
    }

    Status addNumber(const std::string& key, const std::string& text)
    {
        const auto number = integerFrom<std::uint64_t>(text);
        if (!number || *number > kMaxCloudPoints)
            return file_.lineError(
                fmt::format("{} is {}: a number of points was expected", key, shown(text)));
        (key == "WIDTH"    ? header_.width
         : key == "HEIGHT" ? header_.height
                           : header_.points) = number;
        return Done{};
    }

    /// Returns "file: line 3: cause" with the key's line; without a line if the header lacks the key.
    Error errorAt(const std::string& key, std::string_view cause) const
    {
        const auto found = lineOf_.find(key);
        return found == lineOf_.end() ? file_.error(cause) : file_.lineError(cause, found->second);
    }

    Status complete()
    {
        auto& h = header_;
        if (h.fields.empty()) return file_.error("has no line FIELDS in its PCD header");
        if (!h.points && h.width)
            h.points = *h.width * std::min<std::uint64_t>(h.height.value_or(1), 1'000'000);
        if (!h.points) return file_.error("has neither POINTS nor WIDTH in its PCD header");
        if (h.width && h.height
            && (*h.height == 0 || *h.points % *h.height > 0 || *h.points / *h.height != *h.width))
            return errorAt("POINTS",
                           fmt::format("POINTS is {}, but WIDTH and HEIGHT are {} and {}: "
                                       "correct the PCD header",
                                       *h.points, *h.width, *h.height));
        for (const auto& [key, list] :
             {std::pair("SIZE", &h.sizes), {"TYPE", &h.types}, {"COUNT", &h.counts}})
            if (!list->empty() && list->size() != h.fields.size())
                return errorAt(key, fmt::format("FIELDS names {} fields, but {} has {} values: "
                                                "correct the PCD header",
                                                h.fields.size(), key, list->size()));
        std::uint64_t column = 0;
        for (std::size_t i = 0; i < h.fields.size(); ++i)
            if (Status done = completeField(i, column); !done) return done;
        if (h.stride > kMaxPcdPoint)
            return errorAt("COUNT",
                           fmt::format("a point has {} bytes, more than {}: correct SIZE and COUNT",
                                       h.stride, kMaxPcdPoint));
        return findAxes();
    }

    Status completeField(std::size_t i, std::uint64_t& column)
    {
        auto& h = header_;
        PcdField& field = h.fields[i];
        if (!h.sizes.empty()) {
            const auto size = integerFrom<std::uint64_t>(h.sizes[i]);
            if (!size || *size == 0 || *size > 8)
                return errorAt("SIZE",
                               fmt::format("SIZE of field {} is {}: 1, 2, 4 or 8 was expected",
                                           shown(field.name), shown(h.sizes[i])));
            field.size = *size;
        }
        if (!h.counts.empty()) {
            const auto count = integerFrom<std::uint64_t>(h.counts[i]);
            if (!count || *count > kMaxPcdPoint)
                return errorAt("COUNT",
                               fmt::format("COUNT of field {} is {}: at most {} was expected",
                                           shown(field.name), shown(h.counts[i]), kMaxPcdPoint));
            field.count = *count;
        }
        const std::string type = h.types.empty() ? "F" : h.types[i];
        using Kind = CloudNumber::Kind;
        if (type != "F" && type != "I" && type != "U")
            return errorAt("TYPE", fmt::format("TYPE of field {} is {}: F, I or U was expected",
                                               shown(field.name), shown(type)));
        field.number = cloudNumber(type == "F"   ? Kind::Float
                                   : type == "I" ? Kind::Signed
                                                 : Kind::Unsigned,
                                   static_cast<std::size_t>(field.size));
        field.offset = h.stride;
        field.column = column;
        h.stride += field.size * field.count;
        column += field.count;
        return Done{};
    }

    Status findAxes()
    {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::string name(1, "xyz"[axis]);
            const auto field = std::ranges::find(header_.fields, name, &PcdField::name);
            if (field == header_.fields.end())
                return errorAt("FIELDS",
                               fmt::format("FIELDS has no {}: a cloud needs x, y and z", name));
            if (!field->number || field->count != 1)
                return errorAt(
                    "FIELDS",
                    fmt::format("field {} is no number of TYPE F with SIZE 4 or 8, or I, U", name));
            header_.xyz.at(axis) = static_cast<std::size_t>(field - header_.fields.begin());
        }
        return Done{};
    }

    CloudFile& file_;
    PcdHeader header_;
    std::map<std::string, std::uint64_t> lineOf_;  ///< of each key; of COLUMNS under FIELDS
};

/// Base of the three kinds of DATA.
class PcdCloud : public CloudReader {
public:
    explicit PcdCloud(PcdHeader header) : header_(std::move(header)), left_(*header_.points) {}

protected:
    const PcdField& axis(std::size_t i) const { return header_.fields[header_.xyz.at(i)]; }
    std::size_t nextCount() const
    {
        return static_cast<std::size_t>(std::min<std::uint64_t>(left_, kCloudBlock));
    }

    PcdHeader header_;
    std::uint64_t left_;  ///< points
};

class AsciiPcd : public PcdCloud {
public:
    AsciiPcd(CloudFile file, PcdHeader header) : PcdCloud(std::move(header)), file_(std::move(file))
    {
    }
    std::string_view format() const override { return "PCD, ascii"; }

    Result<bool> next(std::vector<CloudPoint>& block) override
    {
        block.clear();
        if (left_ == 0) return atEnd();
        for (std::size_t i = nextCount(); i > 0;) {
            const auto more = file_.line(line_);
            if (!more) return more.error();
            if (!*more)
                return file_.error(
                    fmt::format("ends at line {}, {} points before the {} that its header "
                                "declares: it is cut; write it again",
                                file_.lines(), left_, *header_.points));
            splitCloudFields(line_, fields_);
            if (fields_.empty()) continue;
            std::array<double, 3> xyz{};
            for (std::size_t k = 0; k < 3; ++k) {
                const auto value = fields_.size() > axis(k).column
                                     ? cloudCoordinate(fields_[axis(k).column])
                                     : std::nullopt;
                if (!value)
                    return file_.lineError(fmt::format("field {} is no number", axis(k).name));
                xyz.at(k) = *value;
            }
            add(block, {xyz[0], xyz[1], xyz[2]});
            --left_;
            --i;
        }
        return true;
    }

private:
    /// Refuses a file whose header declares too few points.
    Result<bool> atEnd()
    {
        for (;;) {
            const auto more = file_.line(line_);
            if (!more) return more.error();
            if (!*more) return false;
            splitCloudFields(line_, fields_);
            if (!fields_.empty())
                return file_.lineError(fmt::format("is behind the {} points that the header "
                                                   "declares: correct POINTS and WIDTH",
                                                   *header_.points));
        }
    }

    CloudFile file_;
    std::string line_;
    std::vector<std::string_view> fields_;
};

class BinaryPcd : public PcdCloud {
public:
    BinaryPcd(CloudFile file, PcdHeader header)
        : PcdCloud(std::move(header)), file_(std::move(file))
    {
    }
    std::string_view format() const override { return "PCD, binary"; }

    Result<bool> next(std::vector<CloudPoint>& block) override
    {
        block.clear();
        if (left_ == 0) return atEnd();
        const auto stride = static_cast<std::size_t>(header_.stride);
        const std::size_t count =
            std::min(nextCount(), std::max<std::size_t>(1, (1U << 20U) / stride));
        if (file_.read(count * stride, bytes_) != count * stride)
            return file_.error(
                fmt::format("ends within the last {} of {} points of {} bytes that its header "
                            "declares: it is cut; write it again",
                            left_, *header_.points, stride));
        for (std::size_t i = 0; i < count; ++i) {
            const std::string_view point = std::string_view(bytes_).substr(i * stride, stride);
            const auto value = [&](std::size_t k) {
                return cloudValue(*axis(k).number,
                                  point.substr(static_cast<std::size_t>(axis(k).offset)));
            };
            add(block, {value(0), value(1), value(2)});
        }
        left_ -= count;
        return true;
    }

private:
    /// Refuses a file whose header declares too few or too short points.
    Result<bool> atEnd()
    {
        auto padding =
            file_.behind(fmt::format("{} points of {} bytes", *header_.points, header_.stride));
        if (!padding) return padding.error();
        if (!padding->empty()) setRemark(*std::move(padding));
        return false;
    }

    CloudFile file_;
    std::string bytes_;
};

/// Compressed points lie field by field: all x, then all y, and so on. Each coordinate has a stream of its
/// own over the file, so that memory does not grow with it.
class CompressedPcd : public PcdCloud {
public:
    CompressedPcd(std::vector<LzfStream> axes, PcdHeader header, std::string padding)
        : PcdCloud(std::move(header)), axes_(std::move(axes))
    {
        setRemark(std::move(padding));
    }
    std::string_view format() const override { return "PCD, compressed"; }

    Result<bool> next(std::vector<CloudPoint>& block) override
    {
        block.clear();
        if (left_ == 0) return false;
        for (std::size_t k = 0; !begun_ && k < 3; ++k)
            if (Status done = axes_[k].skip(axis(k).offset * *header_.points); !done)
                return done.error();
        begun_ = true;
        const std::size_t count = nextCount();
        for (std::size_t k = 0; k < 3; ++k)
            if (Status done = axes_[k].read(count * axis(k).number->size, bytes_.at(k)); !done)
                return done.error();
        for (std::size_t i = 0; i < count; ++i) {
            const auto value = [&](std::size_t k) {
                return cloudValue(*axis(k).number,
                                  std::string_view(bytes_.at(k)).substr(i * axis(k).number->size));
            };
            add(block, {value(0), value(1), value(2)});
        }
        left_ -= count;
        return true;
    }

private:
    std::vector<LzfStream> axes_;
    std::array<std::string, 3> bytes_;
    bool begun_ = false;
};

Result<std::unique_ptr<CloudReader>> openCompressedPcd(CloudFile file, PcdHeader header)
{
    std::string sizes;
    if (file.read(8, sizes) != 8)
        return file.error("ends before its compressed points: it is cut; write it again");
    const CloudNumber size{CloudNumber::Kind::Unsigned, 4};
    const auto packed = static_cast<std::uint64_t>(cloudValue(size, sizes));
    const auto unpacked =
        static_cast<std::uint64_t>(cloudValue(size, std::string_view(sizes).substr(4)));
    if (unpacked != header.stride * *header.points)
        return file.error(
            fmt::format("declares {} points of {} bytes, but {} bytes behind the header: "
                        "correct POINTS, SIZE and COUNT",
                        *header.points, header.stride, unpacked));
    if (unpacked > std::max(kSmallPcd, kMaxPcdExpansion * packed))
        return file.error(fmt::format(
            "has {} bytes that unpack to {}, which is no cloud: write it again as DATA binary",
            packed, unpacked));
    if (packed > file.left())
        return file.error(fmt::format(
            "has {} of its {} compressed bytes: it is cut; write it again", file.left(), packed));
    const std::uint64_t begin = file.at();
    file.goTo(begin + packed);
    auto padding = file.behind(fmt::format("{} compressed bytes", packed));
    if (!padding) return padding.error();
    std::vector<LzfStream> axes;
    axes.reserve(3);
    for (int k = 0; k < 3; ++k) {
        auto own = CloudFile::open(file.path());
        if (!own) return own.error();
        own->goTo(begin);
        axes.emplace_back(*std::move(own), packed);
    }
    return std::unique_ptr<CloudReader>(
        std::make_unique<CompressedPcd>(std::move(axes), std::move(header), *std::move(padding)));
}

}  // namespace

Result<std::unique_ptr<CloudReader>> openPcd(CloudFile file)
{
    auto header = PcdHeaderReader(file).read();
    if (!header) return header.error();
    if (header->data == "ascii")
        return std::unique_ptr<CloudReader>(
            std::make_unique<AsciiPcd>(std::move(file), *std::move(header)));
    if (header->data == "binary")
        return std::unique_ptr<CloudReader>(
            std::make_unique<BinaryPcd>(std::move(file), *std::move(header)));
    if (header->data == "binary_compressed")
        return openCompressedPcd(std::move(file), *std::move(header));
    return file.lineError(
        fmt::format("DATA is {}: ascii, binary or binary_compressed was expected; write the cloud "
                    "again as one of these",
                    shown(header->data)));
}

}  // namespace terratact
