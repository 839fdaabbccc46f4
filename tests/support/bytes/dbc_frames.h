#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "core/wire/can_codec.h"
#include "core/wire/dbc/dbc_file.h"

namespace terratact {

/// Return the messages of resources/dbc/terratact.dbc.
const std::vector<DbcMessage>& dbc();
const DbcMessage& message(FrameKind kind);
const DbcMessage& message(std::string_view name);

bool isSigned(const DbcSignal& s);
std::int64_t rawOf(double value, const DbcSignal& s);
void setBits(CanFrame& frame, const DbcSignal& s, std::int64_t raw);
double physical(const CanFrame& frame, const DbcSignal& s);

/// Sets counter and checksum as the file defines them.
void seal(CanFrame& frame, const DbcMessage& m, std::uint8_t counter);

/// Returns a frame with every signal as near to 0 as its range allows; an arm's reading has an sd.
CanFrame blank(const DbcMessage& m, std::uint8_t counter = 0);

std::optional<FrameFault> faultOf(const CanFrame& frame);
Unpacked contentOf(const CanFrame& frame);

}  // namespace terratact
