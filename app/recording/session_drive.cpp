#include "app/recording/session_drive.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "app/recording/session_text.h"
#include "core/learn/data/drive_file.h"
#include "core/learn/data/two_track_scene.h"
#include "core/store/file_read.h"
#include "core/wire/telemetry_listener.h"

namespace terratact {
namespace {

constexpr double kLineWay = 0.01, kLineTurn = 0.005, kLineTime = 0.5;  // [m], [rad], [s]

/// Returns a line with the readings of both sides, or with their means.
DriveLine lineOf(const Measurement& m, double time, bool onePlane)
{
    DriveLine line;
    line.line = onePlane ? measurementOf(onBothSides(Scene{.run = {}, .s = proprioception(m)}).s)
                         : measurementOf(twoTrackReadings(m));
    line.line.time = time;
    line.line.activity = RobotActivity::Driving;
    line.line.travelled = m.travelled;
    line.line.turned = m.turned;
    return line;
}

/// Returns true if a line differs enough from the last kept one.
bool isFurther(const Measurement& line, const Measurement& before)
{
    const double turn =
        line.turned && before.turned ? std::abs(turnBetween(*before.turned, *line.turned)) : 0.0;
    return std::abs(*line.travelled - *before.travelled) >= kLineWay
        || std::abs(line.pitch - before.pitch) >= kLineTurn || turn >= kLineTurn
        || line.time - before.time >= kLineTime;
}

void addWay(SessionReader& session, const RobotModel& robot, SessionDrive& into)
{
    TelemetryListener listener(robot);
    DriveLines& drive = into.drive;
    std::optional<Measurement> last;
    for (std::size_t i = 0; i < session.batches().size(); ++i)
        for (const FrameRow& row : session.frames(i)) {
            const auto received = listener.receive(row.frame, secondsOf(row.time));
            if (!received || !received->travelled) continue;
            DriveLine line = lineOf(*received, secondsOf(row.time), drive.onePlane);
            if (last && (line.line.time < last->time || !isFurther(line.line, *last))) continue;
            if (!isPlausible(drive, line)) {
                ++into.leftOut;
                continue;
            }
            last = line.line;
            drive.lines.push_back(line);
        }
}

void addScenes(const SessionReader& session, const std::set<std::int64_t>& repeated,
               SessionDrive& into)
{
    DriveLines& drive = into.drive;
    for (const SceneRow& row : session.scenes()) {
        if (repeated.contains(row.id)) continue;
        DriveLine line = lineOf(row.measurement, secondsOf(row.time), drive.onePlane);
        line.isScene = true;
        line.line.activity = RobotActivity::Pressed;
        for (const std::size_t side : {0U, 1U}) {
            if (row.truth && drive.onePlane)
                std::ranges::copy(*row.truth, line.truth.at(side).begin());
            if (row.sideTruth && !drive.onePlane)
                std::ranges::copy(row.sideTruth->at(side), line.truth.at(side).begin());
        }
        if (!line.line.travelled || !isPlausible(drive, line)) {
            ++into.leftOut;
            continue;
        }
        ++into.scenes;
        drive.lines.push_back(line);
    }
}

}  // namespace

Result<SessionDrive> sessionDrive(SessionReader& session, const RobotModel& robot, bool onePlane,
                                  const std::set<std::int64_t>& repeated)
{
    SessionDrive found;
    found.drive.run = driveName(session.path());
    found.drive.onePlane = onePlane;
    addWay(session, robot, found);
    if (found.drive.lines.empty())
        return fileError(session.path(),
                         "its telemetry holds no way, which the memory of the method trail needs: "
                         "import it with [odometry] in the mapping, or with [travelled] and "
                         "[turned]");
    addScenes(session, repeated, found);
    if (found.scenes == 0)
        return fileError(session.path(), "holds no scene: the robot must stand with its flippers "
                                         "pressed, as docs/import.md says");
    std::ranges::stable_sort(found.drive.lines, {},
                             [](const DriveLine& line) { return line.line.time; });
    return found;
}

}  // namespace terratact
