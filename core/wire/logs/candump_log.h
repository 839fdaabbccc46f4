#pragma once

#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/wire/logs/log_frame.h"

namespace terratact {

// Logs of CAN traffic from can-utils and python-can, one frame per line, in two dialects:
//
//   compact: candump -l and -L           (1436509052.249713) vcan0 044#2A366C2BBA
//   long: candump without these options  (1436509052.249713)  vcan0  044   [5]  2A 36 6C 2B BA
//
// An identifier has 3 digits. It has 8 digits if it is extended or, with bit 29 set, an error
// frame. A remote frame is 044#R or 044#R4, a CAN FD frame 044##<flags><data>. A direction may
// follow (R or T; RX or TX of candump -x).
// An old long dialect begins with <0x18EEFF01> and has no interface; it gets can0. The long dialect
// may lack the time, or give a date (-tA), which is local time.
// Skipped are lines that begin with #, candump's texts below an error frame (-e), and its
// characters beside the bytes (-a). Swapped or binary bytes (-S, -i) and colours (-c) are refused.

/// Returns the frame of one line, given without its line end. Errors name what was expected and
/// where. LogReader decides on a torn last line (core/wire/logs/log_reader.h).
Result<LoggedFrame> frameFromCandump(std::string_view line);

/// Returns a line of the compact dialect, without its line end. Every version of can-utils and
/// python-can reads it: six digits after the point, no direction. Throws std::invalid_argument if
/// there is no such line. The time may be negative or not finite, or the interface name empty,
/// longer than 15 bytes or with blanks. The identifier may exceed its bits, or the length be
/// impossible for its kind. Data bytes may be unknown, or the frame have two kinds.
std::string candumpLine(double time, std::string_view interface, const CanFrame& frame);

}  // namespace terratact
