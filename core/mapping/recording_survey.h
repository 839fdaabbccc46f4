#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/bags/recording.h"
#include "core/base/result.h"

namespace terratact {

/// Range of one numeric field of a topic.
struct FieldSurvey {
    std::string path;
    std::uint64_t count = 0;         ///< finite values
    std::uint64_t notFinite = 0;     ///< nulls, NaN and infinities
    double least = 0.0, most = 0.0;  ///< of the finite values
    bool operator==(const FieldSurvey&) const = default;
};

/// One topic of a recording.
struct TopicSurvey {
    RecordedTopic topic{};
    std::uint64_t messages = 0;
    std::int64_t first = 0, last = 0;  ///< [ns] smallest and largest time
    std::int64_t longestGap = 0;       ///< [ns] between messages that follow each other in the file
    std::int64_t gapAt = 0;            ///< [ns] time before that gap
    std::uint64_t gaps = 0;            ///< gaps longer than kSurveyGap
    std::optional<double> stampOffset{};  ///< [s] median of recorder's time − header.stamp
    std::string why{};                    ///< why the messages are not decoded; empty: they are
    std::vector<FieldSurvey> fields{};

    double seconds() const { return static_cast<double>(last - first) * 1e-9; }
    /// Returns messages per second; 0 for fewer than two.
    double rate() const;
};

inline constexpr std::size_t kMaxSurveyFields = 200;   ///< fields of a topic
inline constexpr std::size_t kMaxSurveyElements = 16;  ///< elements of an array
inline constexpr std::size_t kMaxSurveyBytes =
    65'536;                                ///< a topic with larger messages is not decoded
inline constexpr double kSurveyGap = 0.5;  ///< [s]

/// Reads all messages of the selected topics once. Topics with images or clouds are only counted.
/// Errors are those of Recording::next().
Result<std::vector<TopicSurvey>> surveyRecording(Recording& recording);

}  // namespace terratact
