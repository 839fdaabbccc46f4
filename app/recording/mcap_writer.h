#pragma once

#include <cstdint>
#include <map>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

namespace terratact {

/// CRC-32 of IEEE 802.3, as zip and MCAP use it.
std::uint32_t crc32(std::string_view bytes);

/// Writes an MCAP file of JSON messages: uncompressed chunks of about kChunk bytes with their CRC, an index of the
/// messages behind each, and a summary, so that readers can go to any time without reading all.
/// Source: the MCAP format specification, version 0.
class McapWriter {
public:
    static constexpr std::size_t kChunk = std::size_t{32} * 1024;
    using Map = std::map<std::string, std::string>;

    /// The stream must begin empty; whoever owns it checks it in the end.
    McapWriter(std::ostream& out, std::string_view library);

    /// A channel with the JSON schema of its messages; before the first message.
    std::uint16_t addChannel(const std::string& topic, const std::string& schemaName,
                             const std::string& jsonSchema);

    /// time: [ns] since 1970.  Throws std::invalid_argument for a channel that was not added.
    void write(std::uint16_t channel, std::uint64_t time, std::string_view json);

    void addMetadata(const std::string& name, const Map& values);

    /// Index, summary and end.  Nothing may follow.
    void finish();

private:
    struct IndexEntry {
        std::uint64_t time, offset;
    };
    struct ChunkIndex {
        std::uint64_t begin, end, at, length, indexLength, size;
        std::map<std::uint16_t, std::uint64_t> indexes;
    };
    struct MetadataIndex {
        std::uint64_t at, length;
        std::string name;
    };
    void put(std::string_view bytes);
    void endChunk();

    std::ostream& out_;
    std::uint64_t at_ = 0;                         ///< bytes written
    std::vector<std::string> schemas_, channels_;  ///< their records
    std::map<std::uint16_t, std::uint64_t> counts_;
    std::uint64_t messages_ = 0, first_ = 0, last_ = 0;
    std::vector<ChunkIndex> chunks_;
    std::vector<MetadataIndex> metadata_;

    std::string chunk_;  ///< records of the open chunk
    std::uint64_t chunkBegin_ = 0, chunkEnd_ = 0;
    std::map<std::uint16_t, std::vector<IndexEntry>> index_;  ///< of the open chunk
};

/// A text as JSON, with its quotes; bytes that are no UTF-8 become U+FFFD.
std::string jsonText(std::string_view text);

}  // namespace terratact
