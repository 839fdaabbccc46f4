#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/bags/csv_recording.h"
#include "core/base/named.h"
#include "core/base/result.h"
#include "core/mapping/standing_presses.h"
#include "core/robot/angles_and_currents.h"
#include "core/robot/measurement.h"

namespace terratact {

/// What a field of a recording measures. Signs and units are those of Measurement.
enum class Quantity : std::uint8_t {
    TERRATACT_ANGLES_AND_CURRENTS,
    Travelled,     ///< [m] along the tracks since any time
    Speed,         ///< [m/s] forward; integrated to Travelled
    Turned,        ///< [rad] left positive
    Differential,  ///< [rad] left track nose up
    Activity,      ///< RobotActivity, as a number or in words
    Refusal,       ///< Refusal, as a number or in words
};
inline constexpr std::size_t kQuantities = enumerators<Quantity>();

/// Returns the name of a quantity's table in a mapping file: "front_left_current".
std::string_view name(Quantity quantity);

/// Arrays of force elements: the tables [front_left_force] to [rear_right_force].
inline constexpr std::array<std::string_view, 4> kForceTables{
    "front_left_force", "front_right_force", "rear_left_force", "rear_right_force"};

/// Where a quantity comes from: value = factor · field + offset.
struct FieldSource {
    std::string topic{}, field{};
    std::string unless{};  ///< path: a message that has this field does not measure the quantity
    double factor = 1.0, offset = 0.0;
    double delay = 0.0;       ///< [s] by which the message is later than the measurement
    bool isOptional = false;  ///< no error and no remark if the file lacks it
    bool isTorque = false;    ///< a torque [N m] of one motor, of which the quantity is the current
    std::string table{};      ///< name of its table in the mapping file
    std::uint32_t line = 0;   ///< of that table
};

/// Attitude from a quaternion that turns the sensor's axes to axes with z up.
struct AttitudeSource {
    FieldSource source;  ///< field: with members x, y, z, w
    std::array<double, 3>
        mount{};              ///< [rad] roll, pitch, yaw of the sensor in the base (ROS: z-y-x)
    std::string baseFrame{};  ///< non-empty: the mounting comes from the transforms instead
};

/// Way and heading from poses: fields of a topic, or transforms from frame to baseFrame.
struct OdometrySource {
    FieldSource source;         ///< field: position with members x, y, z
    std::string orientation{};  ///< quaternion beside it
    std::string frame{};        ///< non-empty: poses come from /tf and /tf_static
    std::string baseFrame{};

    bool isTransform() const { return !frame.empty(); }
};

/// Frames of a CAN bus as messages.
struct FramesSource {
    std::string topic;
    std::string id = "id", extended = "extended", remote = "remote", error = "error", fd = "fd",
                sent = "sent", length = "length", data = "data";
};

/// Which topics and fields of a recording are the robot's telemetry.
struct Mapping {
    std::string name;
    bool byHeader = false;  ///< times are those of header.stamp, not those of the recorder
    double rate = 0.0;      ///< [Hz] lines of telemetry; 0: one for each message of pitch
    double maxGap =
        0.5;  ///< [s] longest time between two messages in which a value is interpolated
    CsvTime csv{};
    std::array<std::optional<FieldSource>, kQuantities> fields{};
    std::array<std::optional<FieldSource>, kForceTables.size()> forces{};  ///< an array of six, or:
    /// fields of the six elements by themselves; empty: the array
    std::array<std::array<std::string, kForceElements>, kForceTables.size()> elements{};
    std::optional<AttitudeSource> attitude{};
    std::optional<OdometrySource> odometry{};
    std::optional<FramesSource> frames{};  ///< the frames are the telemetry; nothing else is read
    PressRule scenes{};

    const std::optional<FieldSource>& of(Quantity quantity) const
    {
        return fields.at(static_cast<std::size_t>(quantity));
    }
};

/// Reads a mapping file (TOML; docs/import.md shows every key). Errors name the file, the line, the key
/// and what was expected.
Result<Mapping> readMapping(const std::string& path);

/// Reads a mapping from a text; errors call it `name`.
Result<Mapping> mappingFrom(const std::string& name, const std::string& text);

}  // namespace terratact
