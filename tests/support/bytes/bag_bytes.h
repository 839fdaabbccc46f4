#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "tests/support/bytes/message_bytes.h"
#include "tests/support/bytes/packed.h"

namespace terratact {

/// Writes records of a ROS 1 bag, from the description of format 2.0.
class BagBytes {
public:
    BagBytes() { header(0, 0, 0); }

    BagBytes& connection(std::uint32_t id, std::string_view topic, std::string_view type,
                         std::string_view definition)
    {
        const std::string about = field("topic", topic) + field("type", type) + field("md5sum", "*")
                                + field("message_definition", definition);
        const std::string bytes = record(op(7) + number("conn", id) + field("topic", topic), about);
        connections_ += bytes;
        ++count_;
        bytes_ += bytes;
        return *this;
    }
    BagBytes& message(std::uint32_t connection, std::uint32_t seconds, std::uint32_t nanoseconds,
                      std::string_view data)
    {
        auto time = MessageBytes::ros1();
        time.add(seconds).add(nanoseconds);
        bytes_ += record(op(2) + number("conn", connection) + field("time", time.bytes()), data);
        return *this;
    }
    /// Moves the records since the last chunk into one.
    BagBytes& chunk(std::string_view method)
    {
        const std::string plain = bytes_.substr(begin_);
        bytes_.resize(begin_);
        lastChunk_ = bytes_.size();
        bytes_ += record(op(5) + field("compression", method)
                             + number("size", static_cast<std::uint32_t>(plain.size())),
                         packed(method, plain));
        begin_ = bytes_.size();
        return *this;
    }
    /// Adds the index: the last chunk has these connections.
    BagBytes& index(const std::vector<std::uint32_t>& connections)
    {
        const std::uint64_t at = bytes_.size();
        auto counts = MessageBytes::ros1();
        for (const std::uint32_t id : connections) counts.add(id).add(std::uint32_t{1});
        bytes_ += connections_
                + record(op(6) + number("ver", std::uint32_t{1}) + number("chunk_pos", lastChunk_)
                             + number("count", static_cast<std::uint32_t>(connections.size())),
                         counts.bytes());
        const std::string rest = bytes_.substr(first_);
        header(at, count_, 1);
        bytes_ += rest;
        return *this;
    }
    const std::string& bytes() const { return bytes_; }

private:
    static std::string field(std::string_view name, std::string_view value)
    {
        auto b = MessageBytes::ros1();
        b.text(std::string(name) + "=" + std::string(value));
        return b.bytes();
    }
    template <class T>
    static std::string number(std::string_view name, T value)
    {
        auto b = MessageBytes::ros1();
        b.add(value);
        return field(name, b.bytes());
    }
    static std::string op(std::uint8_t value) { return number("op", value); }
    static std::string record(std::string_view header, std::string_view data)
    {
        auto b = MessageBytes::ros1();
        b.text(header).text(data);
        return b.bytes();
    }
    /// Writes magic and the padded first record.
    void header(std::uint64_t index, std::uint32_t connections, std::uint32_t chunks)
    {
        const std::string fields = op(3) + number("index_pos", index)
                                 + number("conn_count", connections)
                                 + number("chunk_count", chunks);
        bytes_ = "#ROSBAG V2.0\n" + record(fields, std::string(4096 - 8 - fields.size(), ' '));
        first_ = begin_ = bytes_.size();
    }

    std::string bytes_, connections_;
    std::size_t begin_ = 0, first_ = 0;
    std::uint64_t lastChunk_ = 0;
    std::uint32_t count_ = 0;
};

}  // namespace terratact
