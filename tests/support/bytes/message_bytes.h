#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace terratact {

/// Bytes of ROS messages, written from the specifications: ROS 1 without gaps, CDR with alignment.
class MessageBytes {
public:
    static MessageBytes ros1() { return MessageBytes("", 1); }
    static MessageBytes cdr() { return MessageBytes(std::string("\0\1\0\0", 4), 8); }

    template <class T>
    MessageBytes& add(T value)
    {
        pad(sizeof(T));
        char raw[sizeof(T)];
        std::memcpy(raw, &value, sizeof(T));
        bytes_.append(raw, sizeof(T));
        return *this;
    }
    MessageBytes& text(std::string_view value)
    {
        add(static_cast<std::uint32_t>(value.size() + (isCdr() ? 1 : 0)));
        bytes_ += value;
        if (isCdr()) bytes_ += '\0';
        return *this;
    }
    template <class T>
    MessageBytes& counted(const std::vector<T>& values)
    {
        add(static_cast<std::uint32_t>(values.size()));
        for (const T value : values) add(value);
        return *this;
    }
    const std::string& bytes() const { return bytes_; }

private:
    MessageBytes(std::string header, std::size_t alignment)
        : bytes_(std::move(header)), header_(bytes_.size()), alignment_(alignment)
    {
    }
    bool isCdr() const { return alignment_ > 1; }
    void pad(std::size_t size)
    {
        const std::size_t to = size < alignment_ ? size : alignment_;
        while ((bytes_.size() - header_) % to != 0) bytes_ += '\0';
    }

    std::string bytes_;
    std::size_t header_, alignment_;
};

}  // namespace terratact
