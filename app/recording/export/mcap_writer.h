#pragma once

#include <cstdint>
#include <map>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

namespace terratact {

/// Returns the CRC-32 of IEEE 802.3, which zip and MCAP use.
std::uint32_t crc32(std::string_view bytes);

/// Writes an MCAP file of JSON messages. Chunks of about kChunk bytes are uncompressed and have a CRC and a message
/// index. A summary lets readers seek without reading the whole file. Source: the MCAP format specification, version 0.
class McapWriter {
public:
    static constexpr std::size_t kChunk = std::size_t{32} * 1024;
    using Map = std::map<std::string, std::string>;

    /// The stream must be empty; its owner checks it at the end.
    McapWriter(std::ostream& out, std::string_view library);

    /// Adds a channel with the JSON schema of its messages; call before the first message.
    std::uint16_t addChannel(const std::string& topic, const std::string& schemaName,
                             const std::string& jsonSchema);

    /// Writes a message. time: [ns] since 1970. Throws std::invalid_argument for an unknown channel.
    void write(std::uint16_t channel, std::uint64_t time, std::string_view json);

    void addMetadata(const std::string& name, const Map& values);

    /// Writes index, summary and footer. No write may follow.
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
    std::vector<std::string> schemas_, channels_;  ///< records of the schemas and channels
    std::map<std::uint16_t, std::uint64_t> counts_;
    std::uint64_t messages_ = 0, first_ = 0, last_ = 0;
    std::vector<ChunkIndex> chunks_;
    std::vector<MetadataIndex> metadata_;

    std::string chunk_;  ///< records of the open chunk
    std::uint64_t chunkBegin_ = 0, chunkEnd_ = 0;
    std::map<std::uint16_t, std::vector<IndexEntry>> index_;  ///< index of the open chunk
};

/// Returns a text as a JSON string with quotes; bytes that are not UTF-8 become U+FFFD.
std::string jsonText(std::string_view text);

}  // namespace terratact
