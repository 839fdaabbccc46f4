#include "core/mapping/mapping.h"

#include <fmt/format.h>

#include <span>

#include "core/base/degree.h"
#include "core/base/text.h"
#include "core/robot/toml_section.h"
#include "core/store/file_read.h"

namespace terratact {
namespace {

constexpr auto kQuantityNames = namesOf<Quantity>(
    "pitch", "roll", "front_left", "front_right", "rear_left", "rear_right", "front_left_current",
    "front_right_current", "rear_left_current", "rear_right_current", "travelled", "speed",
    "turned", "differential", "activity", "refusal");

constexpr TomlRange kScaleRange{-1e9, 1e9}, kDelayRange{-3600.0, 3600.0}, kOffsetRange{-1e9, 1e9};

/// Unit of a field, and its factor to SI.
struct FieldUnit {
    std::string_view name;
    double factor = 1.0;
    bool isTorque = false;
};
constexpr std::array kAngleUnits{FieldUnit{"rad"}, FieldUnit{"deg", kDegree}};
constexpr std::array kCurrentUnits{FieldUnit{"A"}, FieldUnit{"mA", 1e-3},
                                   FieldUnit{"N m", 1.0, true}};
constexpr std::array kForceUnits{FieldUnit{"N"}, FieldUnit{"kN", 1e3}};
constexpr std::array kWayUnits{FieldUnit{"m"}, FieldUnit{"mm", 1e-3}, FieldUnit{"cm", 1e-2}};
constexpr std::array kSpeedUnits{FieldUnit{"m/s"}, FieldUnit{"km/h", 1.0 / 3.6}};
constexpr std::array kNoUnits{FieldUnit{"1"}};

std::span<const FieldUnit> unitsOf(Quantity quantity)
{
    switch (quantity) {
    case Quantity::FrontLeftCurrent:
    case Quantity::FrontRightCurrent:
    case Quantity::RearLeftCurrent:
    case Quantity::RearRightCurrent: return kCurrentUnits;
    case Quantity::Travelled: return kWayUnits;
    case Quantity::Speed: return kSpeedUnits;
    case Quantity::Activity:
    case Quantity::Refusal: return kNoUnits;
    default: return kAngleUnits;
    }
}

FieldUnit unitOf(TomlSection& section, std::span<const FieldUnit> units)
{
    if (!section.has("unit")) return units.front();
    const std::string wanted = section.text("unit");
    std::string names;
    for (const FieldUnit& unit : units) {
        if (unit.name == wanted) return unit;
        names += fmt::format("{}\"{}\"", names.empty() ? "" : " or ", unit.name);
    }
    throw TomlRefused{Message::verbatim(fmt::format("{}: {} is {}, expected {}",
                                                    tomlLine(section.node("unit")).english(),
                                                    section.path("unit"), shown(wanted), names))};
}

double optionalNumber(TomlSection& section, std::string_view key, TomlRange range, double otherwise)
{
    return section.has(key) ? section.number(key, range) : otherwise;
}

std::string optionalText(TomlSection& section, std::string_view key, std::string otherwise = {})
{
    return section.has(key) ? section.text(key) : std::move(otherwise);
}

bool tomlFlag(TomlSection& section, std::string_view key)
{
    const auto value = section.node(key).value<bool>();
    if (!value)
        throw TomlRefused{Message::verbatim(fmt::format("{}: {} is neither true nor false",
                                                        tomlLine(section.node(key)).english(),
                                                        section.path(key)))};
    return *value;
}

/// Reads topic, delay and the place in the file. `section` is the table `table`.
FieldSource topicOf(TomlSection& section, std::string_view table)
{
    FieldSource source;
    source.topic = optionalText(section, "topic", kCsvTopic);
    source.delay = optionalNumber(section, "delay_s", kDelayRange, 0.0);
    source.table = std::string(table);
    if (section.has("optional")) source.isOptional = tomlFlag(section, "optional");
    return source;
}

/// Reads sign, scale, unit and offset as well.
FieldSource scaledSource(TomlSection& section, std::string_view table,
                         std::span<const FieldUnit> units)
{
    FieldSource source = topicOf(section, table);
    const FieldUnit unit = unitOf(section, units);
    const double sign = optionalNumber(section, "sign", {-1.0, 1.0}, 1.0);
    if (sign != 1.0 && sign != -1.0)
        throw TomlRefused{Message::verbatim(fmt::format("{}: {} is {}, expected 1 or -1",
                                                        tomlLine(section.node("sign")).english(),
                                                        section.path("sign"), sign))};
    source.factor = sign * unit.factor * optionalNumber(section, "scale", kScaleRange, 1.0);
    source.offset = optionalNumber(section, "offset", kOffsetRange, 0.0);
    source.isTorque = unit.isTorque;
    source.unless = optionalText(section, "unless");
    return source;
}

void readQuantities(TomlSection& file, Mapping& mapping)
{
    for (std::size_t q = 0; q < kQuantities; ++q) {
        const std::string_view table = kQuantityNames[q];
        if (!file.has(table)) continue;
        file.section(table, [&](TomlSection& s) {
            FieldSource source = scaledSource(s, table, unitsOf(static_cast<Quantity>(q)));
            source.field = s.text("field");
            mapping.fields[q] = std::move(source);
        });
        mapping.fields[q]->line = file.node(table).source().begin.line;
    }
}

void readForces(TomlSection& file, Mapping& mapping)
{
    for (std::size_t side = 0; side < kForceTables.size(); ++side) {
        const std::string_view table = kForceTables[side];
        if (!file.has(table)) continue;
        file.section(table, [&](TomlSection& s) {
            FieldSource source = scaledSource(s, table, kForceUnits);
            if (s.has("fields")) {
                const std::string key = s.path("fields");
                const toml::array& six =
                    tomlArray(s.node("fields"), key, kForceElements, kForceElements);
                for (std::size_t e = 0; e < kForceElements; ++e) {
                    const auto text = six[e].value<std::string>();
                    if (!text || !isReadableName(*text))
                        throw TomlRefused{Message::verbatim(fmt::format(
                            "{}: {} does not hold six texts, the fields of elements 1 to 6",
                            tomlLine(six[e]).english(), key))};
                    mapping.elements[side][e] = *text;
                }
            } else {
                source.field = s.text("field");
                for (std::size_t e = 0; e < kForceElements; ++e)
                    mapping.elements[side][e] = fmt::format("{}[{}]", source.field, e);
            }
            mapping.forces[side] = std::move(source);
        });
        mapping.forces[side]->line = file.node(table).source().begin.line;
    }
}

std::array<double, 3> mountOf(TomlSection& section)
{
    std::array<double, 3> mount{};
    if (!section.has("mount_rpy_deg")) return mount;
    const std::string key = section.path("mount_rpy_deg");
    const toml::array& angles = tomlArray(section.node("mount_rpy_deg"), key, 3, 3);
    for (std::size_t i = 0; i < 3; ++i)
        mount[i] = kDegree * tomlNumber(angles[i], key, {-360.0, 360.0});
    return mount;
}

void readPoses(TomlSection& file, Mapping& mapping)
{
    if (file.has("attitude")) {
        file.section("attitude", [&](TomlSection& s) {
            AttitudeSource attitude{.source = topicOf(s, "attitude")};
            attitude.source.field = s.text("quaternion");
            attitude.mount = mountOf(s);
            attitude.baseFrame = optionalText(s, "base_frame");
            mapping.attitude = std::move(attitude);
        });
        mapping.attitude->source.line = file.node("attitude").source().begin.line;
    }
    if (file.has("odometry")) {
        file.section("odometry", [&](TomlSection& s) {
            OdometrySource odometry{.source = topicOf(s, "odometry")};
            odometry.frame = optionalText(s, "frame");
            if (odometry.isTransform()) {
                odometry.baseFrame = s.text("base_frame");
                odometry.source.topic = "/tf";
            } else {
                odometry.source.field = s.text("position");
                odometry.orientation = s.text("orientation");
            }
            mapping.odometry = std::move(odometry);
        });
        mapping.odometry->source.line = file.node("odometry").source().begin.line;
    }
}

void readFrames(TomlSection& section, FramesSource& frames)
{
    frames.topic = section.text("topic");
    for (const auto& [key, field] :
         std::initializer_list<std::pair<const char*, std::string*>>{{"id", &frames.id},
                                                                     {"extended", &frames.extended},
                                                                     {"remote", &frames.remote},
                                                                     {"error", &frames.error},
                                                                     {"fd", &frames.fd},
                                                                     {"sent", &frames.sent},
                                                                     {"length", &frames.length},
                                                                     {"data", &frames.data}})
        if (section.has(key)) *field = section.text(key);
}

void readTime(TomlSection& section, Mapping& mapping)
{
    if (section.has("source"))
        mapping.byHeader = section.choice("source", {"recorder", "header"}) == 1;
    mapping.rate = optionalNumber(section, "rate_hz", {0.1, 1000.0}, 0.0);
    mapping.maxGap = optionalNumber(section, "max_gap_s", {0.001, 60.0}, mapping.maxGap);
}

void readCsvTime(TomlSection& section, CsvTime& csv)
{
    csv.column = optionalText(section, "time_column");
    constexpr std::array kUnits{1.0, 1e-3, 1e-6, 1e-9};
    if (section.has("time_unit"))
        csv.unit = kUnits.at(section.choice("time_unit", {"s", "ms", "us", "ns"}));
}

void readScenes(TomlSection& section, PressRule& rule)
{
    rule.minCurrent = optionalNumber(section, "min_current_a", {0.0, 1000.0}, rule.minCurrent);
    rule.minForce = optionalNumber(section, "min_force_n", {0.0, 10000.0}, rule.minForce);
    rule.still = optionalNumber(section, "still_s", {0.05, 60.0}, rule.still);
    rule.maxTurn = optionalNumber(section, "max_turn_rad", {1e-4, 1.0}, rule.maxTurn);
    rule.maxWay = optionalNumber(section, "max_way_m", {1e-4, 1.0}, rule.maxWay);
}

/// Refuses a mapping without a pose, or with the same quantity twice.
void checkMapping(const Mapping& mapping)
{
    const auto refuse = [](std::string cause) {
        throw TomlRefused{Message::verbatim(std::move(cause))};
    };
    if (mapping.frames) return;
    if (mapping.attitude && (mapping.of(Quantity::Pitch) || mapping.of(Quantity::Roll)))
        refuse("has both [attitude] and [pitch] or [roll]; leave out one of them");
    if (!mapping.attitude && !mapping.of(Quantity::Pitch))
        refuse("lacks the pitch: add [attitude] with a quaternion, or [pitch]");
    for (const Quantity q :
         {Quantity::FrontLeft, Quantity::FrontRight, Quantity::RearLeft, Quantity::RearRight})
        if (!mapping.of(q))
            refuse(
                fmt::format("lacks [{}]: no estimate is possible without all four flipper angles. "
                            "Name the same field twice where one motor moves both sides",
                            name(q)));
    const int ways = (mapping.odometry ? 1 : 0) + (mapping.of(Quantity::Travelled) ? 1 : 0)
                   + (mapping.of(Quantity::Speed) ? 1 : 0);
    if (ways > 1)
        refuse("has more than one of [odometry], [travelled] and [speed]; leave one of them");
    if (mapping.odometry && mapping.of(Quantity::Turned))
        refuse("has both [odometry] and [turned]; leave out one of them");
}

void readMappingFrom(TomlSection& file, Mapping& mapping)
{
    mapping.name = file.text("name");
    if (file.has("time")) file.section("time", [&](TomlSection& s) { readTime(s, mapping); });
    if (file.has("csv")) file.section("csv", [&](TomlSection& s) { readCsvTime(s, mapping.csv); });
    if (file.has("frames"))
        file.section("frames", [&](TomlSection& s) { readFrames(s, mapping.frames.emplace()); });
    if (file.has("scenes"))
        file.section("scenes", [&](TomlSection& s) { readScenes(s, mapping.scenes); });
    readQuantities(file, mapping);
    readForces(file, mapping);
    readPoses(file, mapping);
    checkMapping(mapping);
}

}  // namespace

std::string_view name(Quantity quantity)
{
    return nameIn(kQuantityNames, quantity);
}

Result<Mapping> readMapping(const std::string& path)
{
    Mapping mapping;
    Status read = readTomlFile(path, [&](TomlSection& file) { readMappingFrom(file, mapping); });
    return read ? Result<Mapping>(std::move(mapping)) : Result<Mapping>(read.error());
}

Result<Mapping> mappingFrom(const std::string& name, const std::string& text)
{
    Mapping mapping;
    Status read = readToml(name, text, [&](TomlSection& file) { readMappingFrom(file, mapping); });
    return read ? Result<Mapping>(std::move(mapping)) : Result<Mapping>(read.error());
}

}  // namespace terratact
