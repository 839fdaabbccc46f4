#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/log/session_reader.h"

namespace terratact {

/// [ns] since 1970 of a row; the nearest end of 1970 … 2262 where a file claims another.
std::int64_t wallTimeOf(const SessionStart& start, SessionTime time);

/// "2026-10-26 14:13:20.000 UTC" of nanoseconds since 1970.
std::string utcText(std::int64_t wallTime);
/// The same in the machine's time zone, which is named.
std::string localText(std::int64_t wallTime);

/// "1792999999.000000123": seconds with all nine digits.
std::string nanosecondText(std::int64_t wallTime);

/// "12.345 s".
std::string momentText(SessionTime time);

/// "14:13:20.000 UTC (12.345 s) to …: cause".
std::string damageText(const SessionStart& start, const SessionDamage& damage);

/// Of the name of a session's file what names its drive.
std::string driveName(const std::string& path);

}  // namespace terratact
