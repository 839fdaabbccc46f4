#pragma once

#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/wire/log_frame.h"

namespace terratact {

// Logs of CAN traffic as can-utils and python-can write them, one frame per line, in two dialects:
//
//   compact, of candump -l and -L       (1436509052.249713) vcan0 044#2A366C2BBA
//   long, of candump without these       (1436509052.249713)  vcan0  044   [5]  2A 36 6C 2B BA
//
// An identifier has 3 digits, or 8 where it is extended or, with bit 29 set, an error frame; a remote frame
// is 044#R or 044#R4, a CAN FD frame 044##<flags><data>.  A direction (R or T; RX or TX of candump -x) may
// stand with it.  An old long dialect begins with <0x18EEFF01> and has no interface; can0 is taken for it.  The long
// dialect may lack the time, or tell a date (-tA), which is local time.  Lines that begin
// with # are passed over, and so is what candump writes about errors below an error frame (-e) and beside the bytes
// (-a); swapped or binary bytes (-S, -i) and colours (-c) are refused.

/// The frame of one line, without its line end.  Errors say what was expected where.
Result<LoggedFrame> frameFromCandump(std::string_view line);

/// A line of the compact dialect, without its line end, that every can-utils and python-can read: six digits
/// after the point, no direction.  Throws std::invalid_argument for what has no such line: a time that is
/// negative or not finite, an interface name that is empty, longer than 15 bytes or holds blanks, an
/// identifier beyond its bits, a length that its kind cannot have, bytes that are not known, two kinds of frame
/// in one.
std::string candumpLine(double time, std::string_view interface, const CanFrame& frame);

}  // namespace terratact
