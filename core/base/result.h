#pragma once

#include <string>
#include <utility>
#include <variant>

namespace terratact {

/// Failure of a file, a bus or a model: one sentence for a person that names the thing, the place
/// and the cause. A wrong argument is not an Error: it throws std::invalid_argument.
struct Error {
    std::string text;
    int code = 0;  ///< errno if the system gave one, else 0
};

/// A value, or the Error that prevented it. Reading the absent one throws std::bad_variant_access.
template <class T>
class [[nodiscard]] Result {
public:
    Result(T value) : content_(std::move(value)) {}
    Result(Error error) : content_(std::move(error)) {}

    explicit operator bool() const { return std::holds_alternative<T>(content_); }
    T& operator*() & { return std::get<T>(content_); }
    const T& operator*() const& { return std::get<T>(content_); }
    T&& operator*() && { return std::get<T>(std::move(content_)); }
    T* operator->() { return &std::get<T>(content_); }
    const T* operator->() const { return &std::get<T>(content_); }
    const Error& error() const { return std::get<Error>(content_); }

private:
    std::variant<T, Error> content_;
};

/// Success without a value.
struct Done {
    bool operator==(const Done&) const = default;
};
using Status = Result<Done>;

}  // namespace terratact
