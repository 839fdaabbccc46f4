#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace terratact {

/// Content of a decoded message: a number, a text, an array of them, or members with names.
struct FieldValue {
    enum class Kind : std::uint8_t { Nothing, Number, Text, Numbers, Texts, Members, Items };

    static constexpr std::size_t kMaxElements =
        4096;  ///< kept elements of an array; more are passed over
    static constexpr std::size_t kMaxValues = 100'000;  ///< most values of a message
    static constexpr int kDeepest = 32;                 ///< deepest nesting of a message

    Kind kind = Kind::Nothing;
    std::string name{};  ///< of a member
    double number = 0.0;
    std::string text{};
    std::vector<double> numbers{};  ///< NaN: not a number, or null
    std::vector<std::string> texts{};
    std::vector<FieldValue> parts{};  ///< members, or elements of an array

    static FieldValue of(double value);
    static FieldValue of(std::string value);

    const FieldValue* member(std::string_view wanted) const;
};

// A path names a field of a message, such as
//   orientation.x            a member of a member
//   data[2]                  an element, counted from 0
//   position[flipper_fl]     the element whose place in the texts `name` beside the array has this text
//   transforms[base].…       the element whose child_frame_id, name or header.frame_id is this text
//   missing[pitch]           an element of an array of texts, by its text
// A member whose name holds dots or brackets, such as a column of a CSV file, comes first.

/// Returns the number at the path. Empty if there is none; NaN is a number.
std::optional<double> numberAt(const FieldValue& message, std::string_view path);

/// Returns the text at the path; empty if there is none.
std::optional<std::string> textAt(const FieldValue& message, std::string_view path);

/// Returns true if the path names something that the message has, even if it is null.
bool hasField(const FieldValue& message, std::string_view path);

/// Returns the time header.stamp of a ROS message [ns]; empty if it has none or it is 0.
std::optional<std::int64_t> stampOf(const FieldValue& message);

/// Calls `visit(path, value)` for every number of a message, of an array for the first `most` elements.
void eachNumber(const FieldValue& message, std::size_t most,
                const std::function<void(const std::string& path, double value)>& visit);

}  // namespace terratact
