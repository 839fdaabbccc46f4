#include "app/modelling/robots/robot_proposal.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

#include "core/robot/robot_file_lines.h"
#include "core/store/file_read.h"

namespace terratact {
namespace {

using P = FloorParameter;

/// A parameter that is a number of the robot file.
struct FileNumber {
    std::size_t parameter;
    const char* key;
    const char* cure;  ///< what identifies it
};
constexpr std::array<FileNumber, 5> kFileNumbers{{
    {P::TrackAxle, "track.axle_distance_m",
     "press both axles down so that the robot stands on wheels that reach beyond the pivots; else "
     "measure it with a tape"},
    {P::FrontLength, "front_flipper.axle_distance_m",
     "hold the front flippers down so that they lift the nose, at five angles from -0.2 to -0.9 "
     "rad"},
    {P::RearLength, "rear_flipper.axle_distance_m",
     "hold the rear flippers down so that they lift the tail, at five angles from -0.2 to -0.9 "
     "rad"},
    {P::FrontTip, "front_flipper.tip_radius_m", "measure it with a calliper"},
    {P::RearTip, "rear_flipper.tip_radius_m", "measure it with a calliper"},
}};

struct SensorError {
    std::size_t parameter;
    const char* what;
    const char* mapping;  ///< where it is corrected
    double mappingSign;
    const char* cure;
};
constexpr const char* kPressCure =
    "press these flippers onto the floor with at least 1 A, with and without lifting the robot";
constexpr std::array<SensorError, 7> kSensorErrors{{
    {P::Encoders, "front left flipper", "[front_left] offset", -1.0, kPressCure},
    {P::Encoders + 1, "front right flipper", "[front_right] offset", -1.0, kPressCure},
    {P::Encoders + 2, "rear left flipper", "[rear_left] offset", -1.0, kPressCure},
    {P::Encoders + 3, "rear right flipper", "[rear_right] offset", -1.0, kPressCure},
    {P::ImuPitch, "IMU, pitch", "[pitch] offset", -1.0, "let the robot stand on its tracks"},
    {P::ImuRoll, "IMU, roll", "[roll] offset", -1.0, "let the robot stand on its tracks"},
    {P::ImuYaw, "IMU, turned to the left", "mount_rpy_deg, yaw in degrees", 57.29577951308232,
     "lift the nose and the tail with the flippers"},
}};

double fileValue(const RobotModel& robot, std::size_t parameter)
{
    return parametersOf(robot)[static_cast<Eigen::Index>(parameter)];
}

std::string commentOf(const Calibrated& c)
{
    return fmt::format("# calibrated: sd {:.4f}", c.sd);
}

/// Replaces the number of `key` in the lines of a robot file. Returns false if its line has another form.
bool replaceNumber(std::vector<std::string>& lines, std::size_t line, std::string_view key,
                   const Calibrated& c)
{
    const std::string_view last = key.substr(key.find('.') + 1);
    if (line == 0 || line > lines.size()) return false;
    std::string& text = lines[line - 1];
    const std::size_t begin = text.find_first_not_of(" \t");
    if (begin == std::string::npos || text.compare(begin, last.size(), last) != 0) return false;
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos) return false;
    std::size_t end = text.find_first_of(" \t#", text.find_first_not_of(" \t", equals + 1));
    if (end == std::string::npos) end = text.size();
    const std::string old = text.substr(equals + 1, end - equals - 1);
    const std::size_t comment = text.find('#', end);
    text = fmt::format(
        "{} {:.5f}  {}; was{}{}", text.substr(0, equals + 1), c.value, commentOf(c), old,
        comment == std::string::npos ? "" : "; " + text.substr(std::min(comment + 2, text.size())));
    return true;
}

std::vector<std::string> linesOf(const std::string& text)
{
    std::vector<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

}  // namespace

std::vector<std::string> calibrationReport(const RobotCalibration& calibration,
                                           const RobotModel& robot)
{
    std::vector<std::string> lines{
        fmt::format("calibration from {} standing poses, {} of them off the floor and left out; {} "
                    "are lifted by front flippers, {} by rear ones",
                    calibration.poses, calibration.poses - calibration.used,
                    calibration.onFrontTips, calibration.onRearTips),
        fmt::format(
            "measured less expected pitch, rms: {:.4f} rad by the file, {:.4f} rad calibrated",
            calibration.before, calibration.after)};
    std::vector<std::string> open;
    for (const FileNumber& number : kFileNumbers) {
        const Calibrated& c = calibration.parameter.at(number.parameter);
        if (c.isIdentified)
            lines.push_back(fmt::format("{} = {:.4f} ± {:.4f}, the file has {:.4f}", number.key,
                                        c.value, c.sd, fileValue(robot, number.parameter)));
        else
            open.push_back(fmt::format("not identified: {}: {}", number.key, number.cure));
    }
    const auto& torque = calibration.torquePerAmpere;
    if (torque && torque->isIdentified)
        lines.push_back(
            fmt::format("flipper_drive.torque_per_ampere_nm = {:.3f} ± {:.3f}, the file has "
                        "{:.3f}; as exact as its masses",
                        torque->value, torque->sd, robot.torquePerAmpere));
    else
        open.emplace_back(
            "not identified: flipper_drive.torque_per_ampere_nm: lift the nose or the "
            "tail with at least 1 A in three poses");
    for (const SensorError& error : kSensorErrors) {
        const Calibrated& c = calibration.parameter.at(error.parameter);
        if (c.isIdentified)
            lines.push_back(
                fmt::format("{} reads {:+.4f} ± {:.4f} rad: add {:+.4f} to {} of the mapping",
                            error.what, c.value, c.sd, error.mappingSign * c.value, error.mapping));
        else
            open.push_back(fmt::format("not identified: {}: {}", error.what, error.cure));
    }
    lines.insert(lines.end(), open.begin(), open.end());
    lines.emplace_back(
        "never identified by standing poses: the scale of all lengths (the file's pivots set it), "
        "pivots, radii of wheels, masses, centres of mass, and the IMU's place; a floor that is "
        "not "
        "level counts as a turned IMU");
    return lines;
}

Result<std::string> proposedRobotFile(const std::string& name, const std::string& text,
                                      const RobotCalibration& calibration)
{
    std::vector<std::string> lines = linesOf(text);
    const auto replace = [&](const std::string& key, const Calibrated& c) -> Status {
        const std::size_t line = lineOfKey(text, key);
        if (replaceNumber(lines, line, key, c)) return Done{};
        return fileError(name,
                         fmt::format("line {}: {} does not stand on a line of its own, expected "
                                     "\"key = number\"; write it so for --out",
                                     line, key));
    };
    for (const FileNumber& number : kFileNumbers)
        if (const Calibrated& c = calibration.parameter.at(number.parameter); c.isIdentified)
            if (Status done = replace(number.key, c); !done) return done.error();
    if (const auto& torque = calibration.torquePerAmpere; torque && torque->isIdentified)
        if (Status done = replace("flipper_drive.torque_per_ampere_nm", *torque); !done)
            return done.error();
    std::string proposed;
    for (const std::string& line : lines) proposed += line + "\n";
    if (const auto robot = robotModelFrom(name, proposed); !robot)
        return Error{"the calibrated numbers make no robot file: " + robot.error().text};
    return proposed;
}

}  // namespace terratact
