#pragma once

#include <cstdint>
#include <optional>
#include <utility>

namespace terratact {

/// An optional value whose changes are counted. A view keeps the revision instead of a copy of the value. The same
/// revision of the same object is the same value.
template <class T>
class Revised {
public:
    Revised& operator=(T value)
    {
        value_ = std::move(value);
        ++revision_;
        return *this;
    }
    Revised& operator=(std::optional<T> value)
    {
        if (!value) {
            reset();
            return *this;
        }
        return *this = std::move(*value);
    }
    void reset()
    {
        if (!value_) return;
        value_.reset();
        ++revision_;
    }

    const std::optional<T>& value() const { return value_; }
    explicit operator bool() const { return value_.has_value(); }
    const T& operator*() const { return *value_; }
    const T* operator->() const { return &*value_; }
    /// Returns the number of changes so far.
    std::uint64_t revision() const { return revision_; }

private:
    std::optional<T> value_;
    std::uint64_t revision_ = 0;
};

}  // namespace terratact
