#include "core/robot/robot_model.h"

#include <toml++/toml.h>

#include <cmath>
#include <numbers>
#include <set>
#include <string_view>

#include "core/file_read.h"
#include "core/robot/toml_depth.h"
#include "core/text.h"

namespace terratact {
namespace {

constexpr std::size_t kMostBytes = std::size_t{64} * 1024;
constexpr int kDeepest = 16;
constexpr std::size_t kMostPoints = 64;  ///< of a polygon, and polygons of a body

/// Why the file is refused.  Thrown and caught in this file only: a sentence that lacks the file's name.
struct Refused {
    std::string cause;
};

/// Both ends belong to the range.
struct Range {
    double least, most;
};
constexpr Range kPosition{-2.0, 2.0};   ///< [m]
constexpr Range kReadingSd{1e-4, 0.5};  ///< [m]
constexpr Range kLength{0.001, 2.0};    ///< [m]
constexpr Range kRadius{0.001, 0.5};    ///< [m]
constexpr Range kMass{0.01, 1000.0};    ///< [kg]
constexpr Range kShare{0.0, 1.0};
constexpr Range kPositive{0.001, 10000.0};
constexpr Range kForce{0.001, 1000.0};  ///< [N]
constexpr Range kResistance{1.0, 1e8};  ///< [Ω]
constexpr Range kSupply{1.0, 5.0};      ///< [V] what the link can carry

std::string expectedNumber(Range range)
{
    return "expected a number from " + numberText(range.least) + " to " + numberText(range.most);
}

std::string lineOf(const toml::node& node)
{
    return "line " + std::to_string(node.source().begin.line);
}

double numberOf(const toml::node& node, const std::string& key, Range range)
{
    const std::string place = lineOf(node) + ": " + key;
    if (!node.is_number()) throw Refused{place + " is not a number, " + expectedNumber(range)};
    const double value = node.value<double>().value_or(std::nan(""));
    if (value >= range.least && value <= range.most) return value;
    throw Refused{place + " is " + numberText(value) + ", " + expectedNumber(range)};
}

const toml::array& arrayOf(const toml::node& node, const std::string& key, std::size_t least,
                           std::size_t most)
{
    const toml::array* const array = node.as_array();
    if (array && array->size() >= least && array->size() <= most) return *array;
    const std::string count = least == most ? std::to_string(least)
                                            : std::to_string(least) + " to " + std::to_string(most);
    throw Refused{lineOf(node) + ": " + key + " is not an array of " + count + " elements"};
}

Vec2 pointOf(const toml::node& node, const std::string& key)
{
    const toml::array& pair = arrayOf(node, key, 2, 2);
    return {numberOf(pair[0], key, kPosition), numberOf(pair[1], key, kPosition)};
}

/// Every corner lies strictly on the same side of every edge it is not part of.
bool isConvex(const std::vector<Vec2>& polygon)
{
    const std::size_t n = polygon.size();
    int left = 0, right = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const Vec2 a = polygon[i], b = polygon[(i + 1) % n];
        for (std::size_t j = 2; j < n; ++j) {
            const Vec2 c = polygon[(i + j) % n];
            const double area = (b.x - a.x) * (c.z - a.z) - (b.z - a.z) * (c.x - a.x);
            left += area > 0.0;
            right += area < 0.0;
        }
    }
    const int all = static_cast<int>(n * (n - 2));
    return left == all || right == all;
}

std::vector<Vec2> polygonOf(const toml::node& node, const std::string& key)
{
    std::vector<Vec2> polygon;
    for (const toml::node& point : arrayOf(node, key, 3, kMostPoints))
        polygon.push_back(pointOf(point, key));
    if (!isConvex(polygon))
        throw Refused{lineOf(node) + ": " + key + " holds a polygon that is not convex"};
    return polygon;
}

/// One table of the file.  Every key it is asked for must be there; the others are refused in the end.
class Section {
public:
    Section(const toml::table& table, std::string prefix)
        : table_(table), prefix_(std::move(prefix))
    {
    }

    std::string path(std::string_view key) const { return prefix_ + std::string(key); }

    const toml::node& node(std::string_view key)
    {
        known_.emplace(key);
        const toml::node* const found = table_.get(key);
        if (!found) throw Refused{"the key " + path(key) + " is missing"};
        return *found;
    }
    double number(std::string_view key, Range range)
    {
        return numberOf(node(key), path(key), range);
    }
    Vec2 point(std::string_view key) { return pointOf(node(key), path(key)); }
    std::string text(std::string_view key)
    {
        const auto* const value = node(key).as_string();
        if (!value || value->get().empty() || value->get().size() > 100)
            throw Refused{lineOf(node(key)) + ": " + path(key)
                          + " is not a text of 1 to 100 characters"};
        return value->get();
    }

    /// Reads the section of that name with `read` and refuses what it did not ask for.
    template <class Read>
    void section(std::string_view key, Read read)
    {
        const toml::table* const table = node(key).as_table();
        if (!table) throw Refused{lineOf(node(key)) + ": " + path(key) + " is not a table"};
        Section inner(*table, path(key) + ".");
        read(inner);
        inner.refuseUnknown();
    }

    void refuseUnknown() const
    {
        for (const auto& [key, value] : table_)
            if (!known_.contains(std::string(key.str())))
                throw Refused{lineOf(value) + ": " + shown(path(key.str()))
                              + " is not a known key"};
    }

private:
    const toml::table& table_;
    std::string prefix_;
    std::set<std::string, std::less<>> known_;
};

void readBody(Section& section, RobotModel& robot)
{
    robot.bodyMass = section.number("mass_kg", kMass);
    robot.bodyCom = section.point("com_m");
    const std::string key = section.path("polygons_m");
    for (const toml::node& polygon : arrayOf(section.node("polygons_m"), key, 1, kMostPoints))
        robot.body.push_back(polygonOf(polygon, key));
}

void readFlipper(Section& section, FlipperGeometry& flipper)
{
    flipper.pivot = section.point("pivot_m");
    flipper.pivotRadius = section.number("pivot_radius_m", kRadius);
    flipper.tipRadius = section.number("tip_radius_m", {0.001, flipper.pivotRadius});
    flipper.axleDistance = section.number("axle_distance_m", {flipper.pivotRadius, kLength.most});
    flipper.mass = section.number("mass_kg", kMass);
    flipper.comDistance = section.number("com_distance_m", {0.0, flipper.axleDistance});
}

std::array<double, kForceElements> biasOf(Section& section, std::string_view name, double most)
{
    const std::string key = section.path(name);
    const toml::array& array = arrayOf(section.node(name), key, kForceElements, kForceElements);
    std::array<double, kForceElements> bias{};
    for (std::size_t i = 0; i < bias.size(); ++i) bias[i] = numberOf(array[i], key, {0.0, most});
    return bias;
}

std::vector<ForcePoint> curveOf(const toml::node& node, const std::string& key)
{
    std::vector<ForcePoint> curve;
    for (const toml::node& point : arrayOf(node, key, 2, kMostPoints)) {
        const toml::array& pair = arrayOf(point, key, 2, 2);
        curve.push_back({numberOf(pair[0], key, kForce), numberOf(pair[1], key, kResistance)});
        const std::size_t n = curve.size();
        const bool falls = n < 2
                        || (curve[n - 1].force > curve[n - 2].force
                            && curve[n - 1].resistance < curve[n - 2].resistance);
        if (!falls)
            throw Refused{lineOf(point) + ": " + key
                          + " must rise in force and fall in resistance from point to point"};
    }
    return curve;
}

void readForceCalibration(Section& section, const RobotModel& robot, ForceCalibration& calibration)
{
    calibration.supply = section.number("supply_v", kSupply);
    calibration.reference = section.number("reference_ohm", kResistance);
    const std::string key = section.path("curve_n_ohm");
    calibration.curve = curveOf(section.node("curve_n_ohm"), key);
    calibration.biasLeft = biasOf(section, "bias_left_n", robot.forceSaturation);
    calibration.biasRight = biasOf(section, "bias_right_n", robot.forceSaturation);
    calibration.openBelow = section.number("open_below_v", {0.0, calibration.supply});
    calibration.shortAbove =
        section.number("short_above_v", {calibration.openBelow, calibration.supply});
}

void readForceElements(Section& section, RobotModel& robot)
{
    const std::string key = section.path("edge_share");
    const toml::node& node = section.node("edge_share");
    const toml::array& shares = arrayOf(node, key, kForceElements, kForceElements);
    for (std::size_t i = 0; i < robot.elementShare.size(); ++i) {
        robot.elementShare[i] = numberOf(shares[i], key, kShare);
        if (i > 0 && robot.elementShare[i] <= robot.elementShare[i - 1])
            throw Refused{lineOf(node) + ": " + key + " does not increase from pivot to tip"};
    }
    robot.forceSaturation = section.number("saturation_n", kPositive);
}

RobotModel robotOf(Section& file)
{
    RobotModel robot;
    robot.name = file.text("name");
    file.section("base", [&](Section& s) { robot.baseHeight = s.number("height_m", kLength); });
    file.section("imu", [&](Section& s) {
        robot.imu = {s.number("x_m", kPosition), s.number("z_m", kPosition)};
    });
    file.section("track", [&](Section& s) {
        robot.trackAxle = s.number("axle_distance_m", kLength);
        robot.trackRadius = s.number("wheel_radius_m", kRadius);
        robot.trackZ = s.number("wheel_z_m", kPosition);
    });
    file.section("body", [&](Section& s) { readBody(s, robot); });
    file.section("front_flipper", [&](Section& s) { readFlipper(s, robot.front); });
    file.section("rear_flipper", [&](Section& s) { readFlipper(s, robot.rear); });
    file.section("force_elements", [&](Section& s) { readForceElements(s, robot); });
    file.section("force_calibration",
                 [&](Section& s) { readForceCalibration(s, robot, robot.forceCalibration); });
    file.section("flipper_drive", [&](Section& s) {
        robot.torquePerAmpere = s.number("torque_per_ampere_nm", kPositive);
        robot.maxFlipperTorque = s.number("max_torque_nm", kPositive);
        robot.flipperSpeed = s.number("speed_rad_s", {0.001, 2.0 * std::numbers::pi});
    });
    file.section("arm", [&](Section& s) {
        robot.armReachBegin = s.number("reach_begin_m", kPosition);
        robot.armReachEnd = s.number("reach_end_m", {robot.armReachBegin, kPosition.most});
        robot.armSd = s.number("reading_sd_m", kReadingSd);
    });
    file.refuseUnknown();
    return robot;
}

}  // namespace

double FlipperGeometry::taper() const
{
    const double fall = pivotRadius - tipRadius;
    return axleDistance > std::abs(fall) ? std::asin(fall / axleDistance) : 0.0;
}

double FlipperGeometry::edgeLength() const
{
    return axleDistance * std::cos(taper());
}

Result<RobotModel> readRobotModel(const std::string& path)
{
    const Result<std::string> text = readFile(path, kMostBytes);
    if (!text) return text.error();
    if (text->empty()) return fileError(path, "is empty");
    if (nestingDepth(*text) > kDeepest)
        return fileError(path, "nests deeper than " + std::to_string(kDeepest) + " levels");
    try {
        const toml::table table = toml::parse(std::string_view(*text));
        Section file(table, "");
        return robotOf(file);
    } catch (const toml::parse_error& error) {
        return fileError(path, "line " + std::to_string(error.source().begin.line)
                                   + ": is not TOML: " + std::string(error.description()));
    } catch (const Refused& refused) {
        return fileError(path, refused.cause);
    }
}

}  // namespace terratact
