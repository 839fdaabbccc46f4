#include <fmt/core.h>
#include <fmt/ranges.h>

#include "app/cli/commands.h"
#include "app/runtime/print_text.h"
#include "core/base/text.h"
#include "core/robot/force_calibration.h"
#include "core/robot/robot_model.h"
#include "core/store/csv_reader.h"

namespace terratact {
namespace {

constexpr const char* kHeader = "side,element,force_n,voltage_v";

Result<Side> sideOf(const CsvReader& csv)
{
    const std::string_view side = csv.fields()[0];
    if (side == "left") return Side::Left;
    if (side == "right") return Side::Right;
    return csv.error("names the side " + shown(side) + ", expected left or right");
}

Result<ForceReading> readingOf(CsvReader& csv)
{
    const auto side = sideOf(csv);
    if (!side) return side.error();
    const auto element = csv.number(1, "element");
    if (!element) return element.error();
    const auto applied = csv.number(2, "force_n");
    if (!applied) return applied.error();
    const auto voltage = csv.number(3, "voltage_v");
    if (!voltage) return voltage.error();
    for (int e = 1; e <= kForceElements; ++e) {
        if (*element != e) continue;
        if (*applied >= 0.0) return ForceReading{*side, e - 1, *applied, *voltage};
        return csv.error("force_n is negative");
    }
    return csv.error("element is " + numberText(*element) + ", expected 1 to 6");
}

Result<std::vector<ForceReading>> readRecording(const std::string& path)
{
    Result<CsvReader> csv = CsvReader::open(path);
    if (!csv) return csv.error();
    if (const auto header = csv->next(); !header) return header.error();
    if (fmt::format("{}", fmt::join(csv->fields(), ",")) != kHeader)
        return csv->error(fmt::format("is not the header {}", kHeader));
    csv->useAsHeader({"", "", "N", "V"});
    std::vector<ForceReading> readings;
    for (;;) {
        const Result<bool> more = csv->next();
        if (!more) return more.error();
        if (!*more) return readings;
        const auto reading = readingOf(*csv);
        if (!reading) return reading.error();
        readings.push_back(*reading);
    }
}

void print(const ForceCalibration& c)
{
    printText("\nfor the robot file:\n[force_calibration]\nsupply_v = {}\nreference_ohm = {}\n",
              c.supply, c.reference);
    printText("curve_n_ohm = [");
    for (std::size_t i = 0; i < c.curve.size(); ++i)
        printText("{}[{:.4f}, {:.1f}]", i == 0 ? "" : ", ", c.curve[i].force,
                  c.curve[i].resistance);
    printText("]\nbias_left_n = [{:.4f}]\nbias_right_n = [{:.4f}]\n", fmt::join(c.biasLeft, ", "),
              fmt::join(c.biasRight, ", "));
    printText("open_below_v = {}\nshort_above_v = {}\n", c.openBelow, c.shortAbove);
}

}  // namespace

Status calibrateForces(const CalibrateOptions& options)
{
    const auto robot = readRobotModel(options.robot);
    if (!robot) return robot.error();
    const auto readings = readRecording(options.data);
    if (!readings) return readings.error();
    const auto fitted = calibrate(*readings, robot->forceCalibration, robot->forceArrays);
    if (!fitted) return Error{options.data + ": " + fitted.error().text, 0};
    printText("{} readings\n", readings->size());
    printText("force read less force applied: median {:.3f} N, worst {:.3f} N\n",
              fitted->medianError, fitted->worstError);
    print(fitted->calibration);
    return Done{};
}

}  // namespace terratact
