#include "core/clouds/cloud_messages.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/bags/byte_cursor.h"
#include "core/bags/recording.h"
#include "core/base/text.h"
#include "core/clouds/cloud_value.h"
#include "core/store/file_read.h"

namespace terratact {
namespace {

constexpr std::uint32_t kMaxCloudFieldsOfMessage = 256;

/// Members of a message: packed in ROS 1, aligned to their size in CDR.
class CloudCursor {
public:
    static Result<CloudCursor> over(std::string_view encoding, std::string_view data)
    {
        if (encoding == "ros1") return CloudCursor(data, false, false);
        if (encoding != "cdr")
            return Error{
                fmt::format("its encoding is {}: ros1 or cdr was expected", shown(encoding)), 0};
        if (data.size() < 4) return Error{"has no CDR header of four bytes", 0};
        return CloudCursor(data.substr(4), true, data[1] % 2 == 0);
    }

    template <class T>
    T number()
    {
        align(sizeof(T));
        return cursor_.number<T>();
    }
    /// Returns a text; that of CDR ends with a zero byte.
    std::string_view text()
    {
        const auto size = number<std::uint32_t>();
        std::string_view text = cursor_.bytes(size);
        if (isCdr_ && text.ends_with('\0')) text.remove_suffix(1);
        return text;
    }
    std::string_view bytes() { return cursor_.bytes(number<std::uint32_t>()); }
    bool isValid() const { return cursor_.isValid(); }
    bool isRos1() const { return !isCdr_; }

private:
    CloudCursor(std::string_view data, bool isCdr, bool bigEndian)
        : cursor_(data, bigEndian), isCdr_(isCdr)
    {
    }
    void align(std::size_t size)
    {
        if (isCdr_ && cursor_.at() % size != 0) cursor_.bytes(size - cursor_.at() % size);
    }

    ByteCursor cursor_;
    bool isCdr_;
};

struct CloudAxis {
    std::uint32_t offset = 0;
    CloudNumber number{};
    bool isKnown = false;
};

/// Returns the number of a PointField's datatype, 1 to 8.
std::optional<CloudNumber> pointFieldNumber(std::uint8_t type)
{
    using Kind = CloudNumber::Kind;
    constexpr std::array<CloudNumber, 8> kTypes{{{Kind::Signed, 1},
                                                 {Kind::Unsigned, 1},
                                                 {Kind::Signed, 2},
                                                 {Kind::Unsigned, 2},
                                                 {Kind::Signed, 4},
                                                 {Kind::Unsigned, 4},
                                                 {Kind::Float, 4},
                                                 {Kind::Float, 8}}};
    if (type < 1 || type > kTypes.size()) return std::nullopt;
    return kTypes.at(type - 1U);
}

Result<std::array<CloudAxis, 3>> axesOf(CloudCursor& cursor)
{
    std::array<CloudAxis, 3> axes{};
    const auto fields = cursor.number<std::uint32_t>();
    if (fields > kMaxCloudFieldsOfMessage)
        return Error{fmt::format("has {} fields: at most {} were expected", fields,
                                 kMaxCloudFieldsOfMessage),
                     0};
    for (std::uint32_t i = 0; i < fields && cursor.isValid(); ++i) {
        const std::string_view name = cursor.text();
        const auto offset = cursor.number<std::uint32_t>();
        const auto number = pointFieldNumber(cursor.number<std::uint8_t>());
        cursor.number<std::uint32_t>();  // count
        for (std::size_t k = 0; k < 3; ++k)
            if (name == std::string_view("xyz").substr(k, 1) && number)
                axes.at(k) = {offset, *number, true};
    }
    if (!std::ranges::all_of(axes, &CloudAxis::isKnown))
        return Error{"lacks a numeric field x, y or z: a cloud of points was expected", 0};
    return axes;
}

bool isFar(double v)
{
    return !(std::abs(v) <= kFarthestPoint);
}

}  // namespace

Result<CloudMessage> cloudMessage(const RecordedTopic& topic, std::string_view data)
{
    auto cursor = CloudCursor::over(topic.encoding, data);
    if (!cursor) return cursor.error();
    CloudMessage message;
    if (cursor->isRos1()) cursor->number<std::uint32_t>();  // seq
    const double seconds =
        cursor->isRos1() ? cursor->number<std::uint32_t>() : cursor->number<std::int32_t>();
    message.stamp = seconds + 1e-9 * cursor->number<std::uint32_t>();
    message.frame = cursor->text();
    const auto height = cursor->number<std::uint32_t>(), width = cursor->number<std::uint32_t>();
    const auto axes = axesOf(*cursor);
    if (!axes) return axes.error();
    const bool bigEndian = cursor->number<std::uint8_t>() != 0;
    const auto pointStep = cursor->number<std::uint32_t>(),
               rowStep = cursor->number<std::uint32_t>();
    const std::string_view bytes = cursor->bytes();
    if (!cursor->isValid()) return Error{"ends too early: it is cut, or no PointCloud2", 0};
    for (const CloudAxis& axis : *axes)
        if (std::uint64_t{axis.offset} + axis.number.size > pointStep)
            return Error{
                fmt::format("has a field at byte {} of points of {} bytes", axis.offset, pointStep),
                0};
    const std::uint64_t row = std::uint64_t{width} * pointStep;
    if (height > 0 && (rowStep < row || std::uint64_t{height - 1} * rowStep + row > bytes.size()))
        return Error{fmt::format("declares {} x {} points of {} bytes, but holds {} bytes", width,
                                 height, pointStep, bytes.size()),
                     0};
    message.points.reserve(
        pointStep == 0 ? 0 : std::min<std::size_t>(bytes.size() / pointStep, 1'000'000));
    for (std::uint64_t r = 0; r < height; ++r)
        for (std::uint64_t c = 0; c < width; ++c) {
            const std::string_view point =
                bytes.substr(static_cast<std::size_t>(r * rowStep + c * pointStep));
            const auto value = [&](std::size_t k) {
                return cloudValue(axes->at(k).number, point.substr(axes->at(k).offset), bigEndian);
            };
            const CloudPoint p{value(0), value(1), value(2)};
            if (isFar(p.x) || isFar(p.y) || isFar(p.z))
                ++message.leftOut;
            else
                message.points.push_back(p);
        }
    return message;
}

Result<CloudMessages> readCloudMessages(const std::string& path, const std::string& topic,
                                        const std::function<bool(const CloudMessage& cloud)>& add)
{
    auto recording = openRecording(path);
    if (!recording) return recording.error();
    (*recording)->select({topic});
    CloudMessages read;
    for (RecordedMessage message;;) {
        const auto more = (*recording)->next(message);
        if (!more) return more.error();
        if (!*more) break;
        const RecordedTopic& from = (*recording)->topics().at(message.topic);
        if (from.name != topic) continue;
        if (!from.type.ends_with("PointCloud2"))
            return fileError(
                path,
                fmt::format("topic {}: its type is {}: PointCloud2 was expected; choose another "
                            "--topic",
                            printable(topic), printable(from.type)));
        auto cloud = cloudMessage(from, message.data);
        if (!cloud)
            return fileError(path, fmt::format("topic {}: message at {} {}: {}", printable(topic),
                                               (*recording)->offsetUnit(), message.offset,
                                               cloud.error().text));
        ++read.clouds;
        read.points += cloud->points.size() + cloud->leftOut;
        read.leftOut += cloud->leftOut;
        if (!(cloud->stamp > 0.0)) cloud->stamp = 1e-9 * static_cast<double>(message.time);
        if (!add(*cloud)) break;
    }
    read.remarks = (*recording)->consumeRemarks();
    if (read.clouds > 0) return read;
    std::string names;
    for (const RecordedTopic& known : (*recording)->topics())
        if (names.size() < 200) names += (names.empty() ? "" : ", ") + printable(known.name);
    return fileError(path, fmt::format("has no message of topic {}; its topics are {}",
                                       printable(topic), names));
}

}  // namespace terratact
