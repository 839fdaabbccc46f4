#include "core/sim/fault_matrix.h"

#include <algorithm>
#include <array>

namespace terratact {
namespace {

constexpr std::array<std::string_view, 7> kMatrixKinds{"stuck",   "drift", "spikes",      "flipped",
                                                       "swapped", "late",  "out-of-range"};
constexpr std::array<std::string_view, 11> kMatrixSensors{"pitch",
                                                          "roll",
                                                          "front-left",
                                                          "front-right",
                                                          "rear-left",
                                                          "rear-right",
                                                          "front-left-current",
                                                          "front-right-current",
                                                          "rear-left-current",
                                                          "rear-right-current",
                                                          "odometry"};

/// Returns an amount that is large enough to harm, and that a drive of a minute shows.
std::string_view amountOf(std::string_view kind, const SensorFault& fault)
{
    const SensorKind sensor = kindOf(fault.sensors.front());
    if (kind == "drift") {
        if (sensor == SensorKind::Attitude || sensor == SensorKind::Angle) return ":0.1";
        return sensor == SensorKind::Force ? ":3" : ":1";
    }
    if (kind != "spikes") return "";
    if (sensor == SensorKind::Current) return ":3";
    return sensor == SensorKind::Force ? ":10" : "";
}

std::string_view reasonOfForce(std::string_view kind, Sensor sensor)
{
    const std::size_t element = elementOf(sensor);
    const bool isTip = element + 1 == kForceElements;
    if (kind == "drift") return "a minute of it is a newton or two at the end of a drive";
    if (kind == "stuck" || kind == "flipped" || kind == "late")
        return isTip ? "" : "most presses do not load this element at all";
    if (kind == "swapped" && element != 0 && !isTip)
        return "neighbours of the middle share most loads";
    return "";
}

std::string_view reasonOf(std::string_view kind, const SensorFault& fault)
{
    const Sensor sensor = fault.sensors.front();
    const bool isRear = sensor == Sensor::RearLeft || sensor == Sensor::RearRight;
    switch (kindOf(sensor)) {
    case SensorKind::Attitude:
        if (kind == "swapped") return "there is one of it";
        if (kind == "drift") return "a tilt of the whole world agrees with every other sensor";
        if (sensor == Sensor::Roll && (kind == "flipped" || kind == "late"))
            return "nothing else that is measured depends on roll";
        return "";
    case SensorKind::Angle:
    case SensorKind::Current:
        if (kind == "swapped") return "left and right are moved together";
        if (kind == "drift") return "left and right differ by another amount at every press";
        if (isRear && kind == "late") return "the rear flippers are held";
        return "";
    case SensorKind::Force: return reasonOfForce(kind, sensor);
    case SensorKind::Way:
        if (kind == "swapped") return "there is one of it";
        if (kind == "drift") return "slipping tracks report the same";
        if (kind == "flipped")
            return "telemetry does not say which way the robot was told to drive";
        return "";
    }
    return "";
}

void addRow(std::vector<MatrixCell>& cells, const std::string& sensor)
{
    for (const std::string_view kind : kMatrixKinds) {
        std::string text = std::string(kind) + ':' + sensor;
        const SensorFault fault = sensorFaultFrom(text).value();
        text += amountOf(kind, fault);
        cells.push_back({.sensor = sensor,
                         .kind = kind,
                         .fault = std::move(text),
                         .reason = reasonOf(kind, fault)});
    }
}

}  // namespace

std::vector<std::string_view> matrixKinds()
{
    return {kMatrixKinds.begin(), kMatrixKinds.end()};
}

std::vector<MatrixCell> faultMatrix()
{
    std::vector<MatrixCell> cells;
    for (const std::string_view sensor : kMatrixSensors) addRow(cells, std::string(sensor));
    for (const char* side : {"", "left-", "right-"})
        for (int e = 1; e <= kForceElements; ++e)
            addRow(cells, std::string(side) + "force-" + std::to_string(e));
    return cells;
}

}  // namespace terratact
