#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <sstream>

#include "core/base/text.h"
#include "core/clouds/cloud_fields.h"
#include "core/clouds/cloud_formats.h"
#include "core/clouds/cloud_value.h"

namespace terratact {
namespace {

constexpr std::size_t kMaxPlyHeaderLines = 1000, kMaxPlyProperties = 256, kMaxPlyElements = 16;
constexpr double kMaxPlyList = 65'536.0;  // items

struct PlyProperty {
    std::string name;
    CloudNumber number;
    std::optional<CloudNumber> listCount{};  ///< a list: type of its length
};

struct PlyElement {
    std::string name;
    std::uint64_t count = 0;
    std::vector<PlyProperty> properties;
};

struct PlyHeader {
    std::string format;
    std::vector<PlyElement> elements;  ///< up to the vertices
    bool endsWithVertices = false;     ///< nothing follows them in the file
    std::array<std::size_t, 3> xyz{};
};

std::optional<CloudNumber> plyNumber(std::string_view name)
{
    using Kind = CloudNumber::Kind;
    struct Named {
        std::string_view old, now;
        CloudNumber number;
    };
    static constexpr std::array<Named, 8> kNames{{{"char", "int8", {Kind::Signed, 1}},
                                                  {"uchar", "uint8", {Kind::Unsigned, 1}},
                                                  {"short", "int16", {Kind::Signed, 2}},
                                                  {"ushort", "uint16", {Kind::Unsigned, 2}},
                                                  {"int", "int32", {Kind::Signed, 4}},
                                                  {"uint", "uint32", {Kind::Unsigned, 4}},
                                                  {"float", "float32", {Kind::Float, 4}},
                                                  {"double", "float64", {Kind::Float, 8}}}};
    for (const Named& known : kNames)
        if (name == known.old || name == known.now) return known.number;
    return std::nullopt;
}

class PlyHeaderReader {
public:
    explicit PlyHeaderReader(CloudFile& file) : file_(file) {}

    Result<PlyHeader> read()
    {
        std::string line;
        for (std::size_t i = 0;; ++i) {
            const auto more = file_.line(line);
            if (!more) return more.error();
            if (!*more || i == kMaxPlyHeaderLines)
                return file_.error("has no line end_header: it is cut; write it again");
            std::istringstream words(line);
            std::string key;
            words >> key;
            if (key == "end_header") break;
            if (Status done = addLine(key, words); !done) return done.error();
        }
        if (header_.format.empty()) return file_.error("has no line format in its PLY header");
        if (Status done = findVertices(); !done) return done.error();
        return std::move(header_);
    }

private:
    Status addLine(const std::string& key, std::istringstream& words)
    {
        if (key == "format") return addFormat(words);
        if (key == "element") return addElement(words);
        if (key == "property") return addProperty(words);
        if (key.empty() || key == "ply" || key == "comment" || key == "obj_info") return Done{};
        return file_.lineError(fmt::format(
            "{} is no key of a PLY header: format, element, property and end_header are",
            shown(key)));
    }

    Status addFormat(std::istringstream& words)
    {
        words >> header_.format;
        for (const char* known : {"ascii", "binary_little_endian", "binary_big_endian"})
            if (header_.format == known) return Done{};
        return file_.lineError(fmt::format(
            "format is {}: ascii, binary_little_endian or binary_big_endian was expected",
            shown(header_.format)));
    }

    Status addElement(std::istringstream& words)
    {
        std::string name, count;
        words >> name >> count;
        const auto number = integerFrom<std::uint64_t>(count);
        if (!number || *number > kMaxCloudPoints)
            return file_.lineError(
                fmt::format("element {} has the number {}: a number up to {} was expected",
                            shown(name), shown(count), kMaxCloudPoints));
        if (header_.elements.size() == kMaxPlyElements)
            return file_.lineError(fmt::format("element {} is one more than the {} that are read",
                                               shown(name), kMaxPlyElements));
        header_.elements.push_back({name, *number, {}});
        return Done{};
    }

    Status addProperty(std::istringstream& words)
    {
        std::string type, name, countType;
        words >> type;
        if (type == "list") words >> countType >> type;
        words >> name;
        const auto number = plyNumber(type);
        const auto length = countType.empty() ? std::nullopt : plyNumber(countType);
        if (!number || (!countType.empty() && !length) || header_.elements.empty()
            || header_.elements.back().properties.size() == kMaxPlyProperties)
            return file_.lineError(
                fmt::format("property {} has the type {}: char, uchar, short, ushort, "
                            "int, uint, float or double of an element was expected",
                            shown(name), shown(type)));
        header_.elements.back().properties.push_back({name, *number, length});
        return Done{};
    }

    Status findVertices()
    {
        const auto vertex = std::ranges::find(header_.elements, "vertex", &PlyElement::name);
        if (vertex == header_.elements.end())
            return file_.error("has no element vertex: a cloud was expected");
        for (std::size_t k = 0; k < 3; ++k) {
            const std::string name(1, "xyz"[k]);
            const auto found = std::ranges::find(vertex->properties, name, &PlyProperty::name);
            if (found == vertex->properties.end() || found->listCount)
                return file_.error(
                    fmt::format("its vertices have no property {}: x, y and z are needed", name));
            header_.xyz.at(k) = static_cast<std::size_t>(found - vertex->properties.begin());
        }
        header_.endsWithVertices =
            std::all_of(vertex + 1, header_.elements.end(),
                        [](const PlyElement& element) { return element.count == 0; });
        header_.elements.erase(vertex + 1, header_.elements.end());
        return Done{};
    }

    CloudFile& file_;
    PlyHeader header_;
};

class PlyCloud : public CloudReader {
public:
    PlyCloud(CloudFile file, PlyHeader header)
        : file_(std::move(file)), header_(std::move(header)), left_(header_.elements.back().count)
    {
    }
    std::string_view format() const override
    {
        return isText() ? "PLY, ascii" : isBigEndian() ? "PLY, big endian" : "PLY, little endian";
    }

    Result<bool> next(std::vector<CloudPoint>& block) override
    {
        block.clear();
        if (Status done = passElementsBefore(); !done) return done.error();
        if (left_ == 0) return atEnd();
        for (auto i = std::min<std::uint64_t>(left_, kCloudBlock); i > 0; --i, --left_) {
            if (Status done = readItem(header_.elements.back()); !done) return done.error();
            add(block, {values_[header_.xyz[0]], values_[header_.xyz[1]], values_[header_.xyz[2]]});
        }
        return true;
    }

private:
    bool isText() const { return header_.format == "ascii"; }
    bool isBigEndian() const { return header_.format == "binary_big_endian"; }

    Status passElementsBefore()
    {
        while (header_.elements.size() > 1) {
            const PlyElement& first = header_.elements.front();
            if (first.count > file_.left())
                return cut();  // each takes a byte at least, or is empty
            for (std::uint64_t i = 0; i < first.count; ++i)
                if (Status done = readItem(first); !done) return done;
            header_.elements.erase(header_.elements.begin());
        }
        return Done{};
    }

    /// Refuses a file whose header declares too few vertices, if nothing else may follow them.
    Result<bool> atEnd()
    {
        if (!header_.endsWithVertices) return false;
        const std::string vertices = fmt::format("{} vertices", header_.elements.back().count);
        if (!isText()) {
            auto padding = file_.behind(vertices);
            if (!padding) return padding.error();
            if (!padding->empty()) setRemark(*std::move(padding));
            return false;
        }
        for (;;) {
            const auto more = file_.line(line_);
            if (!more) return more.error();
            if (!*more) return false;
            splitCloudFields(line_, fields_);
            if (!fields_.empty())
                return file_.lineError(fmt::format(
                    "is behind the {} that the header declares: correct their number", vertices));
        }
    }

    /// Reads the properties of an item; lists are passed over.
    Status readItem(const PlyElement& element)
    {
        values_.assign(element.properties.size(), 0.0);
        return isText() ? readLine(element) : readBytes(element);
    }

    Status readBytes(const PlyElement& element)
    {
        for (std::size_t p = 0; p < element.properties.size(); ++p) {
            const PlyProperty& property = element.properties[p];
            const CloudNumber first = property.listCount.value_or(property.number);
            if (file_.read(first.size, bytes_) != first.size) return cut();
            values_[p] = cloudValue(first, bytes_, isBigEndian());
            if (!property.listCount) continue;
            if (!(values_[p] >= 0.0 && values_[p] <= kMaxPlyList))
                return file_.error(fmt::format("a list at byte {} has more than {} items",
                                               file_.at(), kMaxPlyList));
            const std::size_t size = static_cast<std::size_t>(values_[p]) * property.number.size;
            if (file_.read(size, bytes_) != size) return cut();
        }
        return Done{};
    }

    Status readLine(const PlyElement& element)
    {
        const auto more = file_.line(line_);
        if (!more) return more.error();
        if (!*more) return cut();
        splitCloudFields(line_, fields_);
        std::size_t at = 0;
        for (std::size_t p = 0; p < element.properties.size(); ++p, ++at) {
            const auto value = at < fields_.size() ? cloudCoordinate(fields_[at]) : std::nullopt;
            if (!value)
                return file_.lineError(
                    fmt::format("property {} is no number", shown(element.properties[p].name)));
            values_[p] = *value;
            if (element.properties[p].listCount) {
                if (!(*value >= 0.0 && *value <= kMaxPlyList))
                    return file_.lineError(
                        fmt::format("a list has more than {} items", kMaxPlyList));
                at += static_cast<std::size_t>(*value);
            }
        }
        return Done{};
    }

    Error cut() const
    {
        return file_.error(
            fmt::format("ends at byte {}, {} vertices before the end that its header "
                        "declares: it is cut; write it again",
                        file_.at(), left_));
    }

    CloudFile file_;
    PlyHeader header_;
    std::uint64_t left_;  ///< vertices
    std::vector<double> values_;
    std::string bytes_, line_;
    std::vector<std::string_view> fields_;
};

}  // namespace

Result<std::unique_ptr<CloudReader>> openPly(CloudFile file)
{
    auto header = PlyHeaderReader(file).read();
    if (!header) return header.error();
    return std::unique_ptr<CloudReader>(
        std::make_unique<PlyCloud>(std::move(file), *std::move(header)));
}

}  // namespace terratact
