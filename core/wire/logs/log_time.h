#pragma once

#include <optional>
#include <string_view>

namespace terratact {

// Times of logs with a date. The date is in the local time of the recording machine. The time zone
// of this machine is assumed, as in can-utils and python-can.

/// Date and time of day.
struct LogDate {
    int year = 0, month = 0, day = 0;  ///< month and day from 1
    int hour = 0, minute = 0;
    double second = 0.0;
};

/// Returns seconds since 1970; empty: there is no such moment between 1970 and 2200.
std::optional<double> secondsOfLocal(const LogDate& date);

/// Returns the moment of a date "2025-01-10" and a clock "12:34:56.789".
std::optional<double> secondsOfDate(std::string_view date, std::string_view clock);

/// Reads "12:34:56.789" into a date.
bool consumeClock(std::string_view clock, LogDate& date);

}  // namespace terratact
