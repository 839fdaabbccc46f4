#pragma once

#include <cstddef>
#include <memory>
#include <new>

namespace terratact {

/// For an AlignedArray that is filled before it is read.
struct Unset {};

/// Numbers on a 64-byte boundary, zero at first unless the caller says Unset.
template <class T>
class AlignedArray {
public:
    AlignedArray(std::size_t size, Unset)
        : size_(size), values_(static_cast<T*>(::operator new(size * sizeof(T), kBoundary)))
    {
    }
    explicit AlignedArray(std::size_t size = 0) : AlignedArray(size, Unset{})
    {
        for (std::size_t k = 0; k < size; ++k) values_[k] = T{};
    }

    std::size_t size() const { return size_; }
    T* data() { return values_.get(); }
    const T* data() const { return values_.get(); }
    void setZero()
    {
        for (std::size_t k = 0; k < size_; ++k) values_[k] = T{};
    }

private:
    static constexpr std::align_val_t kBoundary{64};
    struct Free {
        void operator()(T* p) const { ::operator delete(p, kBoundary); }
    };
    std::size_t size_;
    std::unique_ptr<T[], Free> values_;
};

}  // namespace terratact
