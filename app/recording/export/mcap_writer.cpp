#include "app/recording/export/mcap_writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>

namespace terratact {

namespace {

constexpr std::string_view kMagic("\x89MCAP0\r\n", 8);

enum class Op : std::uint8_t {
    Header = 0x01,
    Footer = 0x02,
    Schema = 0x03,
    Channel = 0x04,
    Message = 0x05,
    Chunk = 0x06,
    MessageIndex = 0x07,
    ChunkIndex = 0x08,
    Statistics = 0x0B,
    Metadata = 0x0C,
    MetadataIndex = 0x0D,
    SummaryOffset = 0x0E,
    DataEnd = 0x0F
};

constexpr std::array<std::uint32_t, 256> crcTable()
{
    std::array<std::uint32_t, 256> table{};
    for (std::uint32_t n = 0; n < table.size(); ++n) {
        std::uint32_t c = n;
        for (int bit = 0; bit < 8; ++bit) c = (c & 1U) != 0 ? 0xEDB88320U ^ (c >> 1U) : c >> 1U;
        table.at(n) = c;
    }
    return table;
}

/// Serializes the fields of a record, little-endian.
class Bytes {
public:
    template <class Number>
    Bytes& number(Number value)
    {
        for (std::size_t i = 0; i < sizeof value; ++i)
            bytes_ += static_cast<char>(value >> (8 * i) & 0xFFU);
        return *this;
    }
    Bytes& text(std::string_view value)
    {
        number(static_cast<std::uint32_t>(value.size()));
        bytes_ += value;
        return *this;
    }
    Bytes& raw(std::string_view value)
    {
        bytes_ += value;
        return *this;
    }
    Bytes& map(const McapWriter::Map& values)
    {
        Bytes pairs;
        for (const auto& [key, value] : values) pairs.text(key).text(value);
        return text(pairs.bytes_);
    }
    Bytes& map(const std::map<std::uint16_t, std::uint64_t>& values)
    {
        Bytes pairs;
        for (const auto& [key, value] : values) pairs.number(key).number(value);
        return text(pairs.bytes_);
    }
    const std::string& bytes() const { return bytes_; }

private:
    std::string bytes_;
};

std::string record(Op op, const Bytes& content)
{
    return Bytes()
        .number(static_cast<std::uint8_t>(op))
        .number(std::uint64_t{content.bytes().size()})
        .raw(content.bytes())
        .bytes();
}

/// Returns the length [B] of the UTF-8 character at the start of `text`; 0 if it is invalid.
std::size_t characterLength(std::string_view text)
{
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned first = byte(0);
    const std::size_t length = first < 0x80                  ? 1
                             : first >= 0xC2 && first < 0xE0 ? 2
                             : (first & 0xF0U) == 0xE0       ? 3
                             : first >= 0xF0 && first < 0xF5 ? 4
                                                             : 0;
    if (length == 0 || length > text.size()) return 0;
    for (std::size_t i = 1; i < length; ++i)
        if ((byte(i) & 0xC0U) != 0x80) return 0;
    if (length < 3) return length;
    const unsigned second = byte(1);
    const bool wrong = (first == 0xE0 && second < 0xA0) || (first == 0xED && second >= 0xA0)
                    || (first == 0xF0 && second < 0x90) || (first == 0xF4 && second >= 0x90);
    return wrong ? 0 : length;
}

}  // namespace

std::uint32_t crc32(std::string_view bytes)
{
    static constexpr auto kTable = crcTable();
    std::uint32_t crc = 0xFFFFFFFFU;
    for (const char c : bytes)
        crc = kTable.at((crc ^ static_cast<unsigned char>(c)) & 0xFFU) ^ (crc >> 8U);
    return crc ^ 0xFFFFFFFFU;
}

std::string jsonText(std::string_view text)
{
    std::string json = "\"";
    while (!text.empty()) {
        const std::size_t length = characterLength(text);
        const char c = text.front();
        if (length == 0)
            json += "\xEF\xBF\xBD";
        else if (c == '"' || c == '\\')
            json.append(1, '\\').append(1, c);
        else if (static_cast<unsigned char>(c) < 0x20)
            json += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
        else
            json += text.substr(0, length);
        text.remove_prefix(std::max<std::size_t>(length, 1));
    }
    return json + "\"";
}

McapWriter::McapWriter(std::ostream& out, std::string_view library) : out_(out)
{
    put(kMagic);
    put(record(Op::Header, Bytes().text("").text(library)));
}

void McapWriter::put(std::string_view bytes)
{
    out_.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    at_ += bytes.size();
}

std::uint16_t McapWriter::addChannel(const std::string& topic, const std::string& schemaName,
                                     const std::string& jsonSchema)
{
    const auto id = static_cast<std::uint16_t>(channels_.size() + 1);
    schemas_.push_back(record(
        Op::Schema, Bytes().number(id).text(schemaName).text("jsonschema").text(jsonSchema)));
    channels_.push_back(
        record(Op::Channel, Bytes().number(id).number(id).text(topic).text("json").map(Map{})));
    put(schemas_.back());
    put(channels_.back());
    counts_[id] = 0;
    return id;
}

void McapWriter::write(std::uint16_t channel, std::uint64_t time, std::string_view json)
{
    const auto count = counts_.find(channel);
    if (count == counts_.end()) throw std::invalid_argument("McapWriter: no such channel");
    if (chunk_.empty()) chunkBegin_ = chunkEnd_ = time;
    if (messages_ == 0) first_ = last_ = time;
    chunkBegin_ = std::min(chunkBegin_, time);
    chunkEnd_ = std::max(chunkEnd_, time);
    first_ = std::min(first_, time);
    last_ = std::max(last_, time);
    index_[channel].push_back({time, chunk_.size()});
    chunk_ += record(Op::Message, Bytes()
                                      .number(channel)
                                      .number(static_cast<std::uint32_t>(count->second))
                                      .number(time)
                                      .number(time)
                                      .raw(json));
    ++count->second;
    ++messages_;
    if (chunk_.size() >= kChunk) endChunk();
}

void McapWriter::endChunk()
{
    if (chunk_.empty()) return;
    ChunkIndex chunk{.begin = chunkBegin_,
                     .end = chunkEnd_,
                     .at = at_,
                     .length = 0,
                     .indexLength = 0,
                     .size = chunk_.size(),
                     .indexes = {}};
    put(record(Op::Chunk, Bytes()
                              .number(chunkBegin_)
                              .number(chunkEnd_)
                              .number(std::uint64_t{chunk_.size()})
                              .number(crc32(chunk_))
                              .text("")
                              .number(std::uint64_t{chunk_.size()})
                              .raw(chunk_)));
    chunk.length = at_ - chunk.at;
    for (const auto& [channel, entries] : index_) {
        Bytes pairs;
        for (const IndexEntry& entry : entries) pairs.number(entry.time).number(entry.offset);
        chunk.indexes[channel] = at_;
        put(record(Op::MessageIndex, Bytes().number(channel).text(pairs.bytes())));
    }
    chunk.indexLength = at_ - chunk.at - chunk.length;
    chunks_.push_back(std::move(chunk));
    chunk_.clear();
    index_.clear();
}

void McapWriter::addMetadata(const std::string& name, const Map& values)
{
    endChunk();
    const std::uint64_t at = at_;
    put(record(Op::Metadata, Bytes().text(name).map(values)));
    metadata_.push_back({at, at_ - at, name});
}

void McapWriter::finish()
{
    endChunk();
    put(record(Op::DataEnd,
               Bytes().number(std::uint32_t{0})));  // data section CRC: 0 means not available
    const std::uint64_t begin = at_;
    std::string summary;
    std::string offsets;
    const auto group = [&](Op op, const std::vector<std::string>& records) {
        if (records.empty()) return;
        const std::size_t from = summary.size();
        for (const std::string& r : records) summary += r;
        offsets += record(Op::SummaryOffset, Bytes()
                                                 .number(static_cast<std::uint8_t>(op))
                                                 .number(begin + from)
                                                 .number(std::uint64_t{summary.size() - from}));
    };
    std::vector<std::string> chunkIndexes, metadataIndexes;
    for (const ChunkIndex& c : chunks_)
        chunkIndexes.push_back(record(Op::ChunkIndex, Bytes()
                                                          .number(c.begin)
                                                          .number(c.end)
                                                          .number(c.at)
                                                          .number(c.length)
                                                          .map(c.indexes)
                                                          .number(c.indexLength)
                                                          .text("")
                                                          .number(c.size)
                                                          .number(c.size)));
    for (const MetadataIndex& m : metadata_)
        metadataIndexes.push_back(
            record(Op::MetadataIndex, Bytes().number(m.at).number(m.length).text(m.name)));
    group(Op::Schema, schemas_);
    group(Op::Channel, channels_);
    group(Op::Statistics,
          {record(Op::Statistics, Bytes()
                                      .number(messages_)
                                      .number(static_cast<std::uint16_t>(schemas_.size()))
                                      .number(static_cast<std::uint32_t>(channels_.size()))
                                      .number(std::uint32_t{0})  // number of attachments
                                      .number(static_cast<std::uint32_t>(metadata_.size()))
                                      .number(static_cast<std::uint32_t>(chunks_.size()))
                                      .number(first_)
                                      .number(last_)
                                      .map(counts_))});
    group(Op::ChunkIndex, chunkIndexes);
    group(Op::MetadataIndex, metadataIndexes);
    const std::uint64_t offsetsBegin = begin + summary.size();
    summary += offsets;
    // The CRC covers the summary and the footer up to the CRC field.
    summary += Bytes()
                   .number(static_cast<std::uint8_t>(Op::Footer))
                   .number(std::uint64_t{20})
                   .number(begin)
                   .number(offsetsBegin)
                   .bytes();
    summary += Bytes().number(crc32(summary)).bytes();
    put(summary);
    put(kMagic);
}

}  // namespace terratact
