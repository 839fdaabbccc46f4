#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <new>

#include "core/base/poll.h"
#include "core/learn/kernels/huge_pages.h"

namespace terratact {

/// Returns the number of entries of a matrix.
constexpr std::size_t entriesOf(std::ptrdiff_t rows, std::ptrdiff_t columns)
{
    return static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns);
}

/// Tag for an AlignedArray that is filled before it is read.
struct Unset {};

/// Array on a 64-byte boundary, initialised to zero unless the caller passes Unset. From 2 MiB on
/// it uses whole huge pages if the system has them (preferHugePages).
template <class T>
class AlignedArray {
public:
    AlignedArray(std::size_t size, Unset) : size_(size), values_(allocate(size * sizeof(T))) {}
    explicit AlignedArray(std::size_t size = 0) : AlignedArray(size, Poll{}) {}
    /// poll: called before every huge page, which may take the system milliseconds; what it throws
    /// is rethrown.
    AlignedArray(std::size_t size, const Poll& poll) : AlignedArray(size, Unset{})
    {
        constexpr std::size_t kOfPage = kHugePage / sizeof(T);
        for (std::size_t from = 0; from < size; from += kOfPage) {
            callPoll(poll);
            std::fill_n(values_.get() + from, std::min(kOfPage, size - from), T{});
        }
    }

    std::size_t size() const { return size_; }
    T* data() { return values_.get(); }
    const T* data() const { return values_.get(); }
    void setZero()
    {
        for (std::size_t k = 0; k < size_; ++k) values_[k] = T{};
    }

private:
    struct Free {
        std::align_val_t boundary{64};
        void operator()(T* p) const { ::operator delete(p, boundary); }
    };
    using Values = std::unique_ptr<T[], Free>;

    static Values allocate(std::size_t bytes)
    {
        Free free;
        if (bytes >= kHugePage) {
            free.boundary = std::align_val_t{kHugePage};
            bytes = (bytes + kHugePage - 1) / kHugePage * kHugePage;
        }
        Values values(static_cast<T*>(::operator new(bytes, free.boundary)), free);
        preferHugePages(values.get(), bytes);
        return values;
    }

    std::size_t size_;
    Values values_;
};

}  // namespace terratact
