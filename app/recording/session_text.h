#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/message.h"
#include "core/log/session_reader.h"

namespace terratact {

/// Returns a row's time [ns] since 1970, clamped to 1970 … 2262 if a file claims another time.
std::int64_t wallTimeOf(const SessionStart& start, SessionTime time);

/// Returns "2026-10-26 14:13:20.000 UTC". wallTime: [ns] since 1970.
std::string utcText(std::int64_t wallTime);
/// Returns the time in the machine's time zone, which the text names.
std::string localText(std::int64_t wallTime);

/// Returns "1792999999.000000123": seconds with nine decimals.
std::string nanosecondText(std::int64_t wallTime);

/// Returns "12.345 s".
std::string momentText(SessionTime time);

/// Returns "14:13:20.000 UTC (12.345 s) to …: cause".
Message damageMessage(const SessionStart& start, const SessionDamage& damage);
/// Returns damageMessage() in English.
std::string damageText(const SessionStart& start, const SessionDamage& damage);

/// Returns the part of a session's file name that names its drive.
std::string driveName(const std::string& path);

}  // namespace terratact
