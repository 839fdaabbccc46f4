#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "core/bags/message_schema.h"
#include "core/base/result.h"

namespace terratact {

/// Keeps the definitions of a recording's messages, equal ones of one type once. Memory is bounded
/// whatever a file's compressed chunks hold.
class SchemaTexts {
public:
    static constexpr std::size_t kMaxBytes = 4 * MessageSchema::kMaxText;  ///< of all texts

    /// Returns the text of a type's definition. Errors name the type: the text has more than
    /// MessageSchema::kMaxText bytes, or all texts would have more than kMaxBytes.
    Result<std::shared_ptr<const std::string>> keep(std::string_view type, std::string_view text);
    /// The same for a text in this encoding. Returns an empty text if the encoding is not read: neither
    /// ros1msg nor ros2msg.
    Result<std::shared_ptr<const std::string>> keep(std::string_view type, std::string_view text,
                                                    std::string_view encoding);

private:
    /// By type and text, which is the kept one.
    std::map<std::pair<std::string, std::string_view>, std::shared_ptr<const std::string>> texts_;
    std::size_t bytes_ = 0;
};

}  // namespace terratact
