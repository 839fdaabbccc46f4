#pragma once

#include <string_view>

#include "core/bags/field_value.h"
#include "core/bags/message_schema.h"
#include "core/base/result.h"

namespace terratact {

/// Decodes a message of ROS 1: members follow each other without gaps, little-endian. Texts and counted
/// arrays have a length of 32 bits in front. Of long arrays only FieldValue::kMaxElements elements are
/// kept. Errors name the member, the byte of the message and what was expected. Bytes after the last
/// member are an error, because the definition does not match the message.
Result<FieldValue> decodeRos1(const MessageSchema& schema, std::string_view data);

/// Decodes a message of ROS 2: OMG CDR behind an encapsulation header of four bytes, plain CDR of
/// version 1 or 2 in either byte order. Members are aligned to their size, of version 2 to four bytes
/// at most. Up to seven bytes may follow the last member: writers pad. Errors are as above.
Result<FieldValue> decodeCdr(const MessageSchema& schema, std::string_view data);

}  // namespace terratact
