#include "core/robot/robot_model.h"

#include <cmath>
#include <numbers>
#include <string_view>
#include <utility>

#include "core/base/text.h"
#include "core/robot/toml_section.h"

namespace terratact {
namespace {

constexpr std::size_t kMaxPoints = 64;  ///< points of a polygon, and polygons of a body

using Range = TomlRange;
constexpr Range kPosition{-2.0, 2.0};   ///< [m]
constexpr Range kReadingSd{1e-4, 0.5};  ///< [m]
constexpr Range kAngleSd{1e-4, 0.5};    ///< [rad]
constexpr Range kLength{0.001, 2.0};    ///< [m]
constexpr Range kRadius{0.001, 0.5};    ///< [m]
constexpr Range kMass{0.01, 1000.0};    ///< [kg]
constexpr Range kShare{0.0, 1.0};
constexpr Range kPositive{0.001, 10000.0};
constexpr Range kForce{0.001, 1000.0};  ///< [N]
constexpr Range kResistance{1.0, 1e8};  ///< [Ω]
constexpr Range kSupply{1.0, 5.0};      ///< [V] range that the link can carry

Vec2 pointOf(const toml::node& node, const std::string& key)
{
    const toml::array& pair = tomlArray(node, key, 2, 2);
    return {tomlNumber(pair[0], key, kPosition), tomlNumber(pair[1], key, kPosition)};
}

Vec2 pointOf(TomlSection& section, std::string_view key)
{
    return pointOf(section.node(key), section.path(key));
}

/// Returns true if every corner lies strictly on the same side of every edge that it is not part
/// of.
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
    for (const toml::node& point : tomlArray(node, key, 3, kMaxPoints))
        polygon.push_back(pointOf(point, key));
    if (!isConvex(polygon))
        throw TomlRefused{Message(TR_NOOP("core", "%1: %2 holds a polygon that is not convex"),
                                  tomlLine(node), key)};
    return polygon;
}

void readBody(TomlSection& section, RobotModel& robot)
{
    robot.bodyMass = section.number("mass_kg", kMass);
    robot.bodyCom = pointOf(section, "com_m");
    const std::string key = section.path("polygons_m");
    for (const toml::node& polygon : tomlArray(section.node("polygons_m"), key, 1, kMaxPoints))
        robot.body.push_back(polygonOf(polygon, key));
}

void readFlipper(TomlSection& section, FlipperGeometry& flipper)
{
    flipper.pivot = pointOf(section, "pivot_m");
    flipper.pivotRadius = section.number("pivot_radius_m", kRadius);
    flipper.tipRadius = section.number("tip_radius_m", {0.001, flipper.pivotRadius});
    flipper.axleDistance = section.number("axle_distance_m", {flipper.pivotRadius, kLength.most});
    flipper.mass = section.number("mass_kg", kMass);
    flipper.comDistance = section.number("com_distance_m", {0.0, flipper.axleDistance});
}

std::array<double, kForceElements> biasOf(TomlSection& section, std::string_view name, double most)
{
    const std::string key = section.path(name);
    const toml::array& array = tomlArray(section.node(name), key, kForceElements, kForceElements);
    std::array<double, kForceElements> bias{};
    for (std::size_t i = 0; i < bias.size(); ++i) bias[i] = tomlNumber(array[i], key, {0.0, most});
    return bias;
}

std::vector<ForcePoint> curveOf(const toml::node& node, const std::string& key)
{
    std::vector<ForcePoint> curve;
    for (const toml::node& point : tomlArray(node, key, 2, kMaxPoints)) {
        const toml::array& pair = tomlArray(point, key, 2, 2);
        curve.push_back({tomlNumber(pair[0], key, kForce), tomlNumber(pair[1], key, kResistance)});
        const std::size_t n = curve.size();
        const bool falls = n < 2
                        || (curve[n - 1].force > curve[n - 2].force
                            && curve[n - 1].resistance < curve[n - 2].resistance);
        if (!falls)
            throw TomlRefused{Message(
                TR_NOOP("core",
                        "%1: %2 must rise in force and fall in resistance from point to point"),
                tomlLine(point), key)};
    }
    return curve;
}

void readForceCalibration(TomlSection& section, const RobotModel& robot,
                          ForceCalibration& calibration)
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

std::array<double, kForceElements> edgeSharesOf(TomlSection& section)
{
    const std::string key = section.path("edge_share");
    const toml::node& node = section.node("edge_share");
    const toml::array& array = tomlArray(node, key, kForceElements, kForceElements);
    std::array<double, kForceElements> shares{};
    for (std::size_t i = 0; i < shares.size(); ++i) {
        shares[i] = tomlNumber(array[i], key, kShare);
        if (i > 0 && shares[i] <= shares[i - 1])
            throw TomlRefused{Message(TR_NOOP("core", "%1: %2 does not increase from pivot to tip"),
                                      tomlLine(node), key)};
    }
    return shares;
}

/// Reads [lateral]. Parts that overlap are refused.
LateralGeometry lateralOf(TomlSection& section)
{
    constexpr double kTouch = 1e-3;  // [m] rounding of the file's numbers
    LateralGeometry lateral;
    lateral.trackWidth = section.number("track_width_m", kLength);
    lateral.trackY = section.number("track_y_m", {0.5 * lateral.trackWidth, kLength.most});
    lateral.flipperWidth = section.number("flipper_width_m", kLength);
    lateral.flipperY = section.number("flipper_y_m", {0.5 * lateral.flipperWidth, kLength.most});
    lateral.bodyComY = section.number("body_com_y_m", {-lateral.trackY, lateral.trackY});
    const double room = std::abs(lateral.flipperY - lateral.trackY);
    const double widths = 0.5 * (lateral.trackWidth + lateral.flipperWidth);
    const double needed = std::round(widths * 1e6) / 1e6;
    if (room < needed - kTouch)
        throw TomlRefused{Message(
            TR_NOOP("core", "%1: %2 is %3, expected at least %4 m from track_y_m: flipper and "
                            "track overlap"),
            tomlLine(section.node("flipper_y_m")), section.path("flipper_y_m"), lateral.flipperY,
            needed)};
    return lateral;
}

TrackDifferential differentialOf(TomlSection& section)
{
    return {.locked = section.choice("state", {"locked", "free"}) == 0,
            .limit = section.number("limit_rad", {0.001, 1.5})};
}

/// Reads the optional tables about left and right.
void readSides(TomlSection& file, RobotModel& robot)
{
    if (file.has("lateral"))
        file.section("lateral", [&](TomlSection& s) {
            robot.lateral = lateralOf(s);
            robot.halfWidth = robot.lateral.trackY + 0.5 * robot.lateral.trackWidth;
        });
    if (file.has("track_differential"))
        file.section("track_differential",
                     [&](TomlSection& s) { robot.differential = differentialOf(s); });
    if (file.has("rear_force_elements"))
        file.section("rear_force_elements",
                     [&](TomlSection& s) { robot.rearElementShare = edgeSharesOf(s); });
    if (file.has("arm_side"))
        file.section("arm_side",
                     [&](TomlSection& s) { robot.armReachY = s.number("reach_y_m", kLength); });
    if (file.has("tip_over"))
        file.section("tip_over",
                     [&](TomlSection& s) { robot.halfWidth = s.number("half_width_m", kLength); });
}

/// Marks the elements. Each must be free in `taken`.
void readElements(TomlSection& section, ForceArrayLayout& array,
                  std::array<bool, kForceElements>& taken)
{
    const std::string key = section.path("elements");
    const toml::node& node = section.node("elements");
    for (const toml::node& entry : tomlArray(node, key, 1, kForceElements)) {
        const double number = tomlNumber(entry, key, {1.0, kForceElements});
        const auto e = static_cast<std::size_t>(number) - 1;
        if (number != std::floor(number))
            throw TomlRefused{Message(TR_NOOP("core", "%1: %2 holds %3, expected whole numbers"),
                                      tomlLine(entry), key, numberText(number))};
        if (taken[e])
            throw TomlRefused{Message(
                TR_NOOP("core",
                        "%1: %2 names element %3 of that side again, expected one array for each"),
                tomlLine(entry), key, numberText(number))};
        taken[e] = array.has[e] = true;
    }
}

ForceArrayLayout forceArrayOf(TomlSection& section,
                              std::array<std::array<bool, kForceElements>, 2>& taken)
{
    ForceArrayLayout array;
    array.name = section.text("name");
    if (array.name.size() > kMaxForceArrayNameLength)
        throw TomlRefused{Message(TR_NOOP("core", "%1: %2 is %3, expected at most %4 bytes"),
                                  tomlLine(section.node("name")), section.path("name"),
                                  shown(array.name), kMaxForceArrayNameLength)};
    array.side = section.choice("side", {"left", "right"}) == 0 ? Side::Left : Side::Right;
    readElements(section, array, taken[indexOf(array.side)]);
    return array;
}

void requireAllElements(const toml::node& node, const RobotModel& robot)
{
    for (int e = 0; e < kForceElements; ++e)
        if (!haveElement(robot.forceArrays, Side::Left, e)
            && !haveElement(robot.forceArrays, Side::Right, e))
            throw TomlRefused{
                Message(TR_NOOP("core", "%1: no force_array has element %2, expected each of 1 to "
                                        "6 left, right or on both sides"),
                        tomlLine(node), e + 1)};
}

void readForceArrays(TomlSection& file, RobotModel& robot)
{
    constexpr std::string_view kKey = "force_array";
    if (!file.has(kKey)) return;
    const toml::node& node = file.node(kKey);
    const toml::array* const tables = node.as_array();
    if (!tables || tables->empty())
        throw TomlRefused{Message(
            TR_NOOP("core", "%1: force_array is no list of tables, expected [[force_array]]"),
            tomlLine(node))};
    if (tables->size() > kMaxForceArrays)
        throw TomlRefused{
            Message(TR_NOOP("core", "%1: one [[force_array]] more than the %2 expected at most"),
                    tomlLine((*tables)[kMaxForceArrays]), kMaxForceArrays)};
    robot.forceArrays.clear();
    std::array<std::array<bool, kForceElements>, 2> taken{};
    for (const toml::node& entry : *tables) {
        const toml::table* const table = entry.as_table();
        if (!table)
            throw TomlRefused{
                Message(TR_NOOP("core", "%1: force_array holds no table"), tomlLine(entry))};
        TomlSection section(*table, "force_array.");
        ForceArrayLayout array = forceArrayOf(section, taken);
        for (const ForceArrayLayout& other : robot.forceArrays)
            if (other.name == array.name)
                throw TomlRefused{Message(
                    TR_NOOP("core",
                            "%1: %2 is %3 again, expected a name of its own for each array"),
                    tomlLine(section.node("name")), section.path("name"), shown(array.name))};
        robot.forceArrays.push_back(std::move(array));
        section.refuseUnknown();
    }
    requireAllElements(node, robot);
}

RobotModel robotOf(TomlSection& file)
{
    RobotModel robot;
    robot.name = file.text("name");
    file.section("base", [&](TomlSection& s) { robot.baseHeight = s.number("height_m", kLength); });
    file.section("imu", [&](TomlSection& s) {
        robot.imu = {s.number("x_m", kPosition), s.number("z_m", kPosition)};
    });
    file.section("track", [&](TomlSection& s) {
        robot.trackAxle = s.number("axle_distance_m", kLength);
        robot.trackRadius = s.number("wheel_radius_m", kRadius);
        robot.trackZ = s.number("wheel_z_m", kPosition);
    });
    file.section("body", [&](TomlSection& s) { readBody(s, robot); });
    file.section("front_flipper", [&](TomlSection& s) { readFlipper(s, robot.front); });
    file.section("rear_flipper", [&](TomlSection& s) { readFlipper(s, robot.rear); });
    file.section("force_elements", [&](TomlSection& s) {
        robot.elementShare = edgeSharesOf(s);
        robot.forceSaturation = s.number("saturation_n", kPositive);
    });
    file.section("force_calibration",
                 [&](TomlSection& s) { readForceCalibration(s, robot, robot.forceCalibration); });
    readForceArrays(file, robot);
    file.section("flipper_drive", [&](TomlSection& s) {
        robot.torquePerAmpere = s.number("torque_per_ampere_nm", kPositive);
        robot.maxFlipperTorque = s.number("max_torque_nm", kPositive);
        robot.flipperSpeed = s.number("speed_rad_s", {0.001, 2.0 * std::numbers::pi});
    });
    file.section("arm", [&](TomlSection& s) {
        robot.armReachBegin = s.number("reach_begin_m", kPosition);
        robot.armReachEnd = s.number("reach_end_m", {robot.armReachBegin, kPosition.most});
        robot.armSd = s.number("reading_sd_m", kReadingSd);
    });
    file.section("odometry", [&](TomlSection& s) {
        robot.travelledSdShare = s.number("travelled_sd_share", kShare);
        robot.pitchSd = s.number("pitch_sd_rad", kAngleSd);
    });
    readSides(file, robot);
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
    RobotModel robot;
    const Status read = readTomlFile(path, [&](TomlSection& file) { robot = robotOf(file); });
    if (!read) return read.error();
    return robot;
}

Result<RobotModel> robotModelFrom(const std::string& name, const std::string& text)
{
    RobotModel robot;
    const Status read = readToml(name, text, [&](TomlSection& file) { robot = robotOf(file); });
    if (!read) return read.error();
    return robot;
}

}  // namespace terratact
