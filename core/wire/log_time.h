#pragma once

#include <optional>
#include <string_view>

namespace terratact {

// Logs that tell a date tell it in the local time of the machine that recorded them; it is taken for the time zone of
// this machine, as can-utils and python-can do.

/// A moment of the calendar.
struct LogDate {
    int year = 0, month = 0, day = 0;  ///< both from 1
    int hour = 0, minute = 0;
    double second = 0.0;
};

/// [s] since 1970; empty: there is no such moment between 1970 and 2200.
std::optional<double> secondsOfLocal(const LogDate& date);

/// "2025-01-10" and "12:34:56.789" of one moment.
std::optional<double> secondsOfDate(std::string_view date, std::string_view clock);

/// Reads "12:34:56.789" into a date.
bool takeClock(std::string_view clock, LogDate& date);

}  // namespace terratact
