#pragma once

#include <string>
#include <utility>
#include <variant>

#include "core/base/message.h"

namespace terratact {

/// Failure of a file, a bus or a model. Its one sentence names the object, the place and the cause.
/// A wrong argument is not an Error: it throws std::invalid_argument.
struct Error {
    Error(Message said, int number = 0)
        : text(said.english()), code(number), message(std::move(said))
    {
    }
    /// The text in English, as the command line prints it.
    Error(std::string english, int number = 0)
        : text(english), code(number), message(Message::verbatim(std::move(english)))
    {
    }

    std::string text;  ///< in English
    int code;          ///< errno where the system gave one, else 0
    Message message;   ///< translatable form of `text`
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
