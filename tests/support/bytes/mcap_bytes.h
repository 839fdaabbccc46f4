#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "tests/support/bytes/message_bytes.h"
#include "tests/support/bytes/packed.h"

namespace terratact {

/// Writes records of an MCAP file without an index, from the specification.
class McapBytes {
public:
    static constexpr const char* kMagic = "\x89MCAP0\r\n";

    McapBytes() { header(); }

    McapBytes& schema(std::uint16_t id, std::string_view type, std::string_view encoding,
                      std::string_view text)
    {
        auto b = MessageBytes::ros1();
        b.add(id).text(type).text(encoding).text(text);
        return record(0x03, b.bytes());
    }
    McapBytes& channel(std::uint16_t id, std::uint16_t schema, std::string_view topic,
                       std::string_view encoding)
    {
        auto b = MessageBytes::ros1();
        b.add(id).add(schema).text(topic).text(encoding).text("");
        return record(0x04, b.bytes());
    }
    McapBytes& message(std::uint16_t channel, std::uint64_t time, std::string_view data)
    {
        auto b = MessageBytes::ros1();
        b.add(channel).add(std::uint32_t{0}).add(time).add(time);
        return record(0x05, b.bytes() + std::string(data));
    }
    /// Moves the records so far into a chunk.
    McapBytes& chunk(std::string_view method, std::uint32_t checksum = 0)
    {
        const std::string plain = bytes_.substr(begin_);
        bytes_.resize(begin_);
        const std::string content = packed(method, plain);
        auto b = MessageBytes::ros1();
        b.add(std::uint64_t{0})
            .add(std::uint64_t{0})
            .add(std::uint64_t{plain.size()})
            .add(checksum);
        b.text(method).add(std::uint64_t{content.size()});
        record(0x06, b.bytes() + content);
        begin_ = bytes_.size();
        return *this;
    }
    McapBytes& record(std::uint8_t op, std::string_view content)
    {
        auto b = MessageBytes::ros1();
        b.add(op).add(std::uint64_t{content.size()});
        bytes_ += b.bytes();
        bytes_ += content;
        return *this;
    }
    /// Returns the file with an end of the data and a footer without a summary.
    std::string file() const
    {
        McapBytes end = *this;
        auto footer = MessageBytes::ros1();
        footer.add(std::uint64_t{0}).add(std::uint64_t{0}).add(std::uint32_t{0});
        end.record(0x0F, std::string(4, '\0')).record(0x02, footer.bytes());
        return end.bytes_ + std::string(kMagic, 8);
    }
    const std::string& torn() const { return bytes_; }  ///< the file so far, without an end

private:
    void header()
    {
        bytes_ = std::string(kMagic, 8);
        auto b = MessageBytes::ros1();
        b.text("ros2").text("test");
        record(0x01, b.bytes());
        begin_ = bytes_.size();
    }

    std::string bytes_;
    std::size_t begin_ = 0;
};

}  // namespace terratact
