#include "core/bags/recording.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <set>
#include <string_view>
#include <system_error>
#include <utility>

#include "core/bags/bag_recording.h"
#include "core/bags/csv_recording.h"
#include "core/bags/db3_recording.h"
#include "core/bags/mcap_recording.h"
#include "core/base/text.h"
#include "core/store/file_read.h"

namespace terratact {
namespace {

constexpr std::string_view kExpected = "expected MCAP, a ROS 1 bag, a ROS 2 bag (.db3) or CSV";

/// Returns how a compressed file is unpacked; empty: it is none.
std::string_view unpackerOf(std::string_view begins)
{
    constexpr std::array<std::pair<std::string_view, std::string_view>, 5> kPackers{
        {{"\x1f\x8b", "gzip -d"},
         {"\x28\xb5\x2f\xfd", "zstd -d"},
         {"\x04\x22\x4d\x18", "lz4 -d"},
         {"BZh", "bzip2 -d"},
         {"\xfd"
          "7zXZ",
          "xz -d"}}};
    for (const auto& [magic, command] : kPackers)
        if (begins.starts_with(magic)) return command;
    return {};
}

/// Returns the recordings in a folder, which a ROS 2 bag is.
std::string recordingsIn(const std::string& folder)
{
    constexpr std::size_t kMaxListed = 5;
    std::error_code none;
    std::set<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder, none))
        if (const auto end = entry.path().extension(); end == ".mcap" || end == ".db3")
            names.insert(entry.path().filename().string());
    std::string list;
    std::size_t count = 0;
    for (const std::string& name : names)
        if (++count <= kMaxListed) list += (list.empty() ? "" : ", ") + printable(name);
    return names.size() > kMaxListed ? list + ", …" : list;
}

/// Returns why a file that begins so is no recording; empty: it may be a CSV.
std::string whyNoRecording(std::string_view begins)
{
    constexpr std::string_view kMcapName = "\x89MCAP";
    if (begins.empty()) return fmt::format("is empty, {}: copy the recording again", kExpected);
    if (const std::string_view unpack = unpackerOf(begins); !unpack.empty())
        return fmt::format("is compressed as a whole: unpack it first ({})", unpack);
    if (begins.starts_with(kMcapName))
        return fmt::format("is MCAP of another version, {}, expected 0: convert it with the mcap "
                           "program",
                           shown(begins.substr(kMcapName.size(), 1)));
    return {};
}

/// Returns true if the name promises another format than CSV.
bool isNamedAsBag(const std::string& path)
{
    const std::string ending = std::filesystem::path(path).extension().string();
    return ending == ".mcap" || ending == ".bag" || ending == ".db3";
}

/// Returns true if the file has a definition of the topic, but in an encoding that is not read.
bool hasUnreadDefinition(const RecordedTopic& topic)
{
    return !topic.schemaEncoding.empty() && topic.schema
        && (!*topic.schema || (*topic.schema)->empty());
}

}  // namespace

Result<bool> Recording::read(RecordedMessage& message)
{
    auto more = next(message);
    if (watch_ && more && *more) watch_(message.offset, offsetUnit() == "byte");
    return more;
}

void Recording::remark(std::string text)
{
    if (damage_.empty()) damage_ = text;
    note(std::move(text));
}

void Recording::note(std::string text)
{
    constexpr std::size_t kMax = 20;  // one damaged file may have a fault in every chunk
    if (++remarked_ > kMax) return;
    remarks_.push_back(remarked_ < kMax ? std::move(text) : "more faults are not listed");
}

std::vector<std::string> Recording::consumeRemarks()
{
    return std::exchange(remarks_, {});
}

const Result<MessageDecoder>& Recording::decoderOf(std::size_t topic)
{
    decoderOfTopic_.resize(std::max(decoderOfTopic_.size(), topics_.size()));
    if (!decoderOfTopic_.at(topic)) {
        const RecordedTopic& t = topics_[topic];
        const DecoderKey key{t.type, t.encoding, t.schemaEncoding,
                             t.schema ? t.schema->get() : nullptr,
                             t.schema ? std::string() : t.schema.error().text};
        auto found = decoders_.find(key);
        if (found == decoders_.end()) found = decoders_.emplace(key, newDecoder(t)).first;
        decoderOfTopic_[topic] = &found->second;
    }
    return *decoderOfTopic_[topic];
}

Result<MessageDecoder> Recording::newDecoder(const RecordedTopic& topic)
{
    auto decoder = MessageDecoder::of(topic);
    if (!decoder) return decoder;
    if (decoder->parts() > kMaxParts - parts_)
        return Error{fmt::format("the definition of {} is left out: with it, the definitions of "
                                 "this recording have more than {} structs and fields",
                                 printable(topic.type), kMaxParts)};
    parts_ += decoder->parts();
    if (decoder->parts() > 0 && hasUnreadDefinition(topic))
        note(fmt::format("the definition of {} has the encoding {}, which is not read; the "
                         "shipped definition of this type was used",
                         printable(topic.type), shown(topic.schemaEncoding)));
    return decoder;
}

Result<FieldValue> Recording::decode(const RecordedMessage& message)
{
    const Result<MessageDecoder>& decoder = decoderOf(message.topic);
    const auto fault = [&](std::string_view cause) {
        return fileError(
            path_, fmt::format("topic {}: {}", printable(topics_[message.topic].name), cause));
    };
    if (!decoder) return fault(decoder.error().text);
    auto value = decoder->decode(message.data);
    if (value) return value;
    return fault(
        fmt::format("the message at {} {} {}", offsetUnit(), message.offset, value.error().text));
}

Result<std::unique_ptr<Recording>> openRecording(const std::string& path, const CsvTime& csv)
{
    std::error_code none;
    // The beginning is read to know the format, and again by its reader.
    if (std::filesystem::is_fifo(path, none) || std::filesystem::is_character_file(path, none))
        return fileError(path, "is a pipe or device, and a recording is read back and forth: save "
                               "it as a file first");
    if (std::filesystem::is_directory(path, none)) {
        const std::string inside = recordingsIn(path);
        return fileError(path, inside.empty() ? fmt::format("is a folder, {}", kExpected)
                                              : "is a folder, as a ROS 2 bag is one: give a file "
                                                "in it: "
                                                    + inside);
    }
    std::ifstream file(path, std::ios::binary);
    std::array<char, 16> head{};
    file.read(head.data(), head.size());
    const std::string_view begins(head.data(), static_cast<std::size_t>(file.gcount()));
    const bool isRead = file.is_open() && !file.bad();
    file.close();
    if (begins.starts_with(kMcapMagic)) return openMcap(path);
    if (begins.starts_with(kBagMagic)) return openBag(path);
    if (begins.starts_with("SQLite format 3")) return openDb3(path);
    if (const std::string why = isRead ? whyNoRecording(begins) : ""; !why.empty())
        return fileError(path, why);
    auto text = openCsvRecording(path, csv);
    if (!text && isRead && isNamedAsBag(path))
        return fileError(path, fmt::format("begins with {}, {}: copy the recording again",
                                           shown(begins), kExpected));
    return text;
}

}  // namespace terratact
