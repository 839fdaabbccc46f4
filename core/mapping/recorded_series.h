#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/bags/recording.h"
#include "core/base/result.h"
#include "core/mapping/even_clock.h"
#include "core/mapping/mapping.h"
#include "core/robot/robot_model.h"

namespace terratact {

/// One value of a quantity at its time.
struct SeriesSample {
    std::int64_t time = 0;   ///< [ns]
    double value = 0.0;      ///< in SI units, finite
    bool isMeasured = true;  ///< false: the message says that it was not measured
};
using Series = std::vector<SeriesSample>;

/// The mapped quantities of a recording, each in the order of its times.
struct RecordedSeries {
    std::array<Series, kQuantities> of{};
    /// Of each force array and element.
    std::array<std::array<Series, kForceElements>, kForceTables.size()> forces{};

    Series& series(Quantity quantity) { return of.at(static_cast<std::size_t>(quantity)); }
    const Series& series(Quantity quantity) const
    {
        return of.at(static_cast<std::size_t>(quantity));
    }
    /// Calls visit(series) with each series, those of the forces last.
    template <class Visit>
    void each(Visit visit)
    {
        for (Series& quantity : of) visit(quantity);
        for (auto& side : forces)
            for (Series& element : side) visit(element);
    }
    std::vector<std::string> remarks{};   ///< sentences about what is missing or was left out
    std::vector<ClockStep> clockSteps{};  ///< where the clock was set, in the order of time
    /// How far header.stamp lies before the recorder's time [s], at each topic's first message.
    std::map<std::string, double> stampOffsets{};
};

/// Reads the mapped topics of a recording. `progress` may be empty. Attitude becomes pitch and roll, poses
/// and speed become way and heading: the way is summed along the forward axis. Errors name the file, the topic, and
/// what to do. Causes: a missing topic or field that the pose needs; a frame that the transforms lack; times of topics
/// that do not overlap; more than mostSamples() values; a topic of which at most half of the messages can be decoded.
/// Left out with a remark are values that are not finite, texts instead of numbers and missing optional fields. So are
/// messages that cannot be decoded. Where the clock was set, times continue evenly (EvenClock).
Result<RecordedSeries> readSeries(Recording& recording, const Mapping& mapping,
                                  const RobotModel& robot);

inline constexpr std::size_t kMaxSamples = 20'000'000;  ///< 480 MB

/// Returns the largest number of mapped values of a recording of this size [bytes]. It is four for each byte, at least
/// a million, at most kMaxSamples. A small file asks for little memory, however it is compressed.
std::uintmax_t mostSamples(std::uintmax_t recordingBytes);

}  // namespace terratact
