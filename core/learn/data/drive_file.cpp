#include "core/learn/data/drive_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <unordered_set>
#include <utility>

#include "core/base/text.h"
#include "core/learn/data/scene_values.h"
#include "core/robot/two_tracks.h"
#include "core/store/csv_reader.h"

namespace terratact {
namespace {

constexpr std::size_t kWayKind = 0, kSceneKind = 1;
constexpr std::size_t kDriveColumns = 1;  // numbers before those of a scene: travelled_m

/// Returns the columns of drives: those of scenes, and turned_rad behind them. Without `sds`, the last columns of
/// scenes, which hold the sd of heights, and turned_rad are left out.
SceneColumns withTravelled(SceneColumns columns, std::size_t sds, DriveColumns kind)
{
    if (kind == DriveColumns::Measured)
        columns.columns.push_back(
            Column{"turned_rad", "rad", -1e6, 1e6, {"", "is it in degrees?"}});
    else
        columns.columns.erase(columns.columns.end() - static_cast<std::ptrdiff_t>(sds),
                              columns.columns.end());
    columns.columns.insert(columns.columns.begin(),
                           Column{"travelled_m", "m", -1e6, 1e6, {"", "is it in mm?"}});
    columns.neverEmpty += kDriveColumns;
    columns.required += kDriveColumns;
    columns.kinds = {"way", "scene"};
    columns.most = kMaxDriveLines;
    return columns;
}

const SceneColumns& driveColumns(bool onePlane, DriveColumns kind = DriveColumns::Measured)
{
    using enum DriveColumns;
    static const auto plane = [](DriveColumns k) {
        return withTravelled(planeSceneColumns(), kPlaneSdColumns, k);
    };
    static const auto tracks = [](DriveColumns k) {
        return withTravelled(twoTrackSceneColumns(), kTwoTrackSdColumns, k);
    };
    static const std::array<SceneColumns, 4> all{plane(Simulated), plane(Measured),
                                                 tracks(Simulated), tracks(Measured)};
    return all.at((onePlane ? 0U : 2U) + (kind == Measured ? 1U : 0U));
}

DriveLine driveLineOf(const TwoTrackScene& scene, const SceneFileRow& row)
{
    const bool isScene = row.kind == kSceneKind;
    DriveLine line{.line = measurementOf(scene.s),
                   .isScene = isScene,
                   .truth = scene.truth,
                   .truthSd = scene.truthSd};
    line.line.time = scene.time;
    line.line.activity = isScene ? RobotActivity::Pressed : RobotActivity::Driving;
    line.line.travelled = row.values.front().value();
    line.line.turned = row.values.back();
    return line;
}

DriveLine driveLineOf(const SceneFileRow& row, bool onePlane)
{
    return driveLineOf(onePlane ? onBothSides(planeSceneOf(row, kDriveColumns))
                                : twoTrackSceneOf(row, kDriveColumns),
                       row);
}

bool hasHeights(const std::array<OptionalHeights, 2>& truth)
{
    return std::ranges::any_of(truth, [](const OptionalHeights& side) {
        return std::ranges::any_of(side, [](const auto& h) { return h.has_value(); });
    });
}

/// Collects the lines of each drive, and passes it on when the next one begins.
class DriveCollector {
public:
    DriveCollector(const CsvReader& csv, bool onePlane, bool turns,
                   const std::function<void(DriveLines&&)>& add)
        : csv_(csv), add_(add), turns_(turns), drive_{.run = {}, .onePlane = onePlane, .lines = {}}
    {
    }

    Status add(const SceneFileRow& row)
    {
        if (row.run != drive_.run)
            if (Status begun = begin(row.run); !begun) return begun;
        DriveLine line = driveLineOf(row, drive_.onePlane);
        if (!turns_) line.line.turned = 0.0;
        if (!line.isScene && (hasHeights(line.truth) || hasHeights(line.truthSd)))
            return csv_.error("has heights, which only lines of kind scene have");
        if (!drive_.lines.empty() && line.line.time < drive_.lines.back().line.time)
            return csv_.error("t_s is " + numberText(line.line.time) + " after "
                              + numberText(drive_.lines.back().line.time)
                              + ", expected lines of a run in the order of time");
        drive_.lines.push_back(line);
        return Done{};
    }

    void finish()
    {
        if (drive_.lines.empty()) return;
        add_(DriveLines{drive_.run, drive_.onePlane, std::exchange(drive_.lines, {})});
    }

private:
    Status begin(const std::string& run)
    {
        finish();
        if (!seen_.insert(run).second)
            return csv_.error("is of run " + shown(run)
                              + ", whose lines do not stand together: others precede it");
        drive_.run = run;
        return Done{};
    }

    const CsvReader& csv_;
    const std::function<void(DriveLines&&)>& add_;
    bool turns_;  ///< the file has a column turned_rad
    DriveLines drive_;
    std::unordered_set<std::string> seen_;
};

double toResolution(double value)
{
    // + 0.0: no negative zero.  Divided: the nearest double to the decimal number.
    return std::round(value / kDriveResolution) / std::round(1.0 / kDriveResolution) + 0.0;
}

/// Returns the row of a line of a drive in one plane.
SceneFileRow planeRow(const DriveLine& line)
{
    const Scene scene{.run = {},
                      .time = {},
                      .s = proprioception(line.line),
                      .truth = line.truth[0],
                      .truthSd = line.truthSd[0]};
    if (onBothSides(scene).s != twoTrackReadings(line.line) || line.truth[1] != line.truth[0]
        || line.truthSd[1] != line.truthSd[0])
        throw std::invalid_argument("driveText: the sides of one plane differ");
    return sceneRow(scene);
}

SceneFileRow trackRow(const DriveLine& line)
{
    return sceneRow(TwoTrackScene{.run = {},
                                  .time = {},
                                  .s = twoTrackReadings(line.line),
                                  .truth = line.truth,
                                  .truthSd = line.truthSd});
}

SceneFileRow driveRow(const DriveLines& drive, const DriveLine& line,
                      DriveColumns columns = DriveColumns::Measured)
{
    if (!line.line.travelled) throw std::invalid_argument("driveText: a line without travelled");
    if (!line.isScene && (hasHeights(line.truth) || hasHeights(line.truthSd)))
        throw std::invalid_argument("driveText: a line of the way has heights");
    SceneFileRow row = drive.onePlane ? planeRow(line) : trackRow(line);
    row.run = drive.run;
    row.time = toResolution(line.line.time);
    row.kind = line.isScene ? kSceneKind : kWayKind;
    row.values.insert(row.values.begin(), line.line.travelled);
    row.values.push_back(line.line.turned);
    if (columns == DriveColumns::Simulated)
        row.values.resize(driveColumns(drive.onePlane, columns).columns.size());
    for (std::optional<double>& value : row.values)
        if (value) value = toResolution(*value);
    return row;
}

}  // namespace

Result<std::vector<Message>> readDrives(const std::string& path,
                                        const std::function<void(DriveLines&&)>& add)
{
    Result<std::string> text = CsvReader::textOf(path, kMaxDriveFileBytes);
    if (!text) return text.error();
    Result<CsvReader> csv = CsvReader::over(path, *std::move(text));
    if (!csv) return csv.error();
    if (const Result<bool> first = csv->next(); !first) return first.error();
    const auto has = [&](std::string_view column) {
        return std::ranges::find(csv->fields(), column) != csv->fields().end();
    };
    const bool onePlane = !has("roll_rad");
    DriveCollector collector(*csv, onePlane, has("turned_rad"), add);
    auto notices = readSceneRows(*csv, driveColumns(onePlane),
                                 [&](const SceneFileRow& row) { return collector.add(row); });
    if (notices) collector.finish();
    return notices;
}

Result<DriveFile> readDrives(const std::string& path)
{
    DriveFile file;
    auto notices =
        readDrives(path, [&](DriveLines&& drive) { file.drives.push_back(std::move(drive)); });
    if (!notices) return notices.error();
    file.notices = *std::move(notices);
    return file;
}

std::string drivesHeader(bool onePlane, DriveColumns columns)
{
    return sceneHeader(driveColumns(onePlane, columns));
}

std::string driveText(const DriveLines& drive, DriveColumns columns)
{
    std::string text;
    for (const DriveLine& line : drive.lines)
        text += sceneLine(driveColumns(drive.onePlane, columns), driveRow(drive, line, columns));
    return text;
}

bool isPlausible(const DriveLines& drive, const DriveLine& line)
{
    const std::vector<Column>& columns = driveColumns(drive.onePlane).columns;
    const SceneFileRow row = driveRow(drive, line);
    for (std::size_t i = 0; i < row.values.size(); ++i)
        if (row.values[i] && !columns[i].holds(*row.values[i])) return false;
    return true;
}

}  // namespace terratact
