#include "core/bags/schema_texts.h"

#include <fmt/format.h>

#include "core/base/text.h"

namespace terratact {

Result<std::shared_ptr<const std::string>> SchemaTexts::keep(std::string_view type,
                                                             std::string_view text)
{
    if (text.size() > MessageSchema::kMaxText)
        return Error{fmt::format("the definition of {} has {} bytes, more than {}; it is left out",
                                 printable(type), text.size(), MessageSchema::kMaxText)};
    std::string of(type);
    if (const auto known = texts_.find({of, text}); known != texts_.end()) return known->second;
    if (text.size() > kMaxBytes - bytes_)
        return Error{fmt::format("the definition of {} is left out: with it, all definitions have "
                                 "more than {} bytes",
                                 printable(type), kMaxBytes)};
    bytes_ += text.size();
    const auto kept = std::make_shared<const std::string>(text);
    texts_.emplace(std::pair(std::move(of), std::string_view(*kept)), kept);
    return kept;
}

Result<std::shared_ptr<const std::string>>
SchemaTexts::keep(std::string_view type, std::string_view text, std::string_view encoding)
{
    const bool isRead = encoding == "ros1msg" || encoding == "ros2msg";
    return keep(type, isRead ? text : std::string_view());
}

}  // namespace terratact
