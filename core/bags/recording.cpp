#include "core/bags/recording.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <system_error>
#include <utility>

#include "core/bags/bag_recording.h"
#include "core/bags/csv_recording.h"
#include "core/bags/db3_recording.h"
#include "core/bags/mcap_recording.h"
#include "core/base/text.h"
#include "core/store/file_read.h"

namespace terratact {

Result<bool> Recording::read(RecordedMessage& message)
{
    auto more = next(message);
    if (watch_ && more && *more) watch_(message.offset, offsetUnit() == "byte");
    return more;
}

void Recording::remark(std::string text)
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
        const DecoderKey key{t.type, t.encoding, t.schemaEncoding, t.schema.get()};
        auto found = decoders_.find(key);
        if (found == decoders_.end()) found = decoders_.emplace(key, MessageDecoder::of(t)).first;
        decoderOfTopic_[topic] = &found->second;
    }
    return *decoderOfTopic_[topic];
}

Result<FieldValue> Recording::decode(const RecordedMessage& message)
{
    const Result<MessageDecoder>& decoder = decoderOf(message.topic);
    const std::string name = printable(topics_[message.topic].name);
    if (!decoder) return fileError(path_, fmt::format("topic {}: {}", name, decoder.error().text));
    auto value = decoder->decode(message.data);
    if (value) return value;
    return fileError(path_, fmt::format("topic {}: the message at {} {} {}", name, offsetUnit(),
                                        message.offset, value.error().text));
}

Result<std::unique_ptr<Recording>> openRecording(const std::string& path, const CsvTime& csv)
{
    std::error_code none;
    // The beginning is read to know the format, and again by its reader.
    if (std::filesystem::is_fifo(path, none) || std::filesystem::is_character_file(path, none))
        return fileError(path, "is a pipe or device, and a recording is read back and forth: save "
                               "it as a file first");
    std::ifstream file(path, std::ios::binary);
    std::array<char, 16> head{};
    file.read(head.data(), head.size());
    const std::string_view begins(head.data(), static_cast<std::size_t>(file.gcount()));
    file.close();
    if (begins.starts_with(kMcapMagic)) return openMcap(path);
    if (begins.starts_with(kBagMagic)) return openBag(path);
    if (begins.starts_with("SQLite format 3")) return openDb3(path);
    return openCsvRecording(path, csv);
}

}  // namespace terratact
