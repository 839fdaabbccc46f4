// The drive strip of the terrain page, and the contacts in the picture.
#include <cmath>

#include "app/display/drive_text.h"
#include "app/display/place_text.h"
#include "app/pages/terrain_page.h"
#include "core/limits.h"
#include "core/robot/side_plane.h"
#include "widgets/control/drive_strip.h"
#include "widgets/terrain/terrain_profile_view.h"

namespace terratact {
namespace {

/// Returns the front end of the tracks on level ground, forward from the IMU [m].
double frontOfTracks(const RobotModel& robot)
{
    return robot.trackAxle / 2.0 + robot.trackRadius - robot.imu.x;
}

/// A flipper in the plane in which it is drawn.
struct DrawnFlipper {
    const FlipperGeometry& geometry;
    double angle;  ///< [rad]
    Pose pose;
    const std::array<double, kForceElements>& shares;
};

void addContacts(std::vector<ContactPoint>& points, const FlipperContacts& contacts,
                 Flipper flipper, const DrawnFlipper& drawn, const QString& prefix)
{
    const auto strongest = contacts.strongest(flipper);
    for (int e = 0; e < kForceElements; ++e) {
        const auto i = static_cast<std::size_t>(e);
        if (!contacts.flippers[indexOf(flipper)][i].touches) continue;
        const Vec2 at = edgePoint(drawn.geometry, drawn.angle, drawn.pose, drawn.shares[i]);
        const bool isNamed = strongest && strongest->element == e;
        points.push_back({{at.x, at.z}, isNamed ? prefix + QString::number(e + 1) : QString()});
    }
}

/// Returns the contacts of one side, in its plane, or in that of the whole robot.
void addSide(std::vector<ContactPoint>& points, const FlipperContacts& contacts,
             const RobotModel& robot, const Measurement& m, Side side, bool onePlane)
{
    const Proprioception middle = proprioception(m);
    const TwoTrackReadings readings = twoTrackReadings(m);
    const double front = onePlane ? middle.front : readings.flippers[indexOf(frontFlipper(side))];
    const double rear = onePlane ? middle.rear : readings.flippers[indexOf(rearFlipper(side))];
    const RobotModel plane =
        onePlane ? robot : inSidePlane(robot, m.roll, signOf(side) * robot.lateral.flipperY);
    const Pose pose = poseInDem(plane, m.pitch, front, rear);
    const QString letter = contacts.sidesKnown ? sideLetter(side) : QString();
    addContacts(points, contacts, frontFlipper(side),
                {robot.front, front, pose, robot.elementShare}, letter);
    if (robot.rearElementShare)
        addContacts(points, contacts, rearFlipper(side),
                    {robot.rear, rear, pose, *robot.rearElementShare},
                    QLatin1Char('r') + sideLetter(side));
}

}  // namespace

/// Returns the values of the drive strip. Levels and contacts are always those of the newest measurement.
DriveViewState TerrainPage::driveViewState(const TerrainViewState& viewState)
{
    DriveViewState drive;
    const bool fresh = viewState.measurement && viewState.age <= kStaleAfter;
    if (!fresh) {
        contacts_.clear();
        speed_.clear();
        return drive;
    }
    const Measurement& m = *viewState.measurement;
    if (viewState.count != driveCount_) {
        contacts_.add(m);
        speed_.add(m);
        driveCount_ = viewState.count;
    }
    const Attitude& a = viewState.attitude;
    drive.pitch = DriveViewState::Angle{m.pitch, a.pitch, a.pitchLimits, a.pitchTips};
    drive.roll = DriveViewState::Angle{m.roll, a.roll, a.rollLimits, a.rollTips};
    if (viewState.forcesAge.value_or(viewState.age) <= kStaleAfter)
        drive.contact = contacts_.state();
    else
        contacts_.clear();
    drive.speed = speed_.speed();
    drive.way = viewState.remembered.way;
    drive.feltTo = viewState.remembered.feltTo;
    drive.feltEnds = drive.way && drive.feltTo.value_or(-1.0) < frontOfTracks(robot_);
    return drive;
}

void TerrainPage::showDrive(const TerrainViewState& viewState)
{
    DriveViewState drive = driveViewState(viewState);
    const DriveViewState& shown = driving_->viewState();
    const auto levelOf = [](const std::optional<DriveViewState::Angle>& angle) {
        return angle ? std::optional(angle->level) : std::nullopt;
    };
    const auto moves = [](const std::optional<double>& speed) {
        return speed ? std::optional(DriveText::speed(*speed) != DriveText::speed(0.0))
                     : std::nullopt;
    };
    const bool isOther =
        levelOf(drive.pitch) != levelOf(shown.pitch) || levelOf(drive.roll) != levelOf(shown.roll)
        || moves(drive.speed) != moves(shown.speed)
        || drive.way.has_value() != shown.way.has_value()
        || drive.feltTo.has_value() != shown.feltTo.has_value() || drive.feltEnds != shown.feltEnds;
    // Slow enough to read. A contact, a stop, a new estimate and the end of felt ground are shown at once.
    if (!viewState.numbersDue && !isOther) {
        const std::optional<FlipperContacts> contact = drive.contact;
        drive = shown;
        drive.contact = contact;
    }
    const int before = driving_->minimumSizeHint().width();
    driving_->setViewState(drive);
    if (driving_->minimumSizeHint().width() != before) layout_->measure();  // rear elements came in
}

/// Marks the contacts, unless the robot stands at an estimate, which has its own marks of contacts.
void TerrainPage::showContacts(const TerrainViewState& viewState)
{
    using enum RobotActivity;
    const Measurement* const m = viewState.measurement;
    const bool moves = m && (m->activity == Driving || m->activity == Pressing);
    marksContacts_ = !viewState.past && (moves || !viewState.estimate);
    drawContacts();
}

/// Marks the contacts on the robot as it is drawn.
void TerrainPage::drawContacts()
{
    const auto& contacts = driving_->viewState().contact;
    std::vector<ContactPoint> points;
    if (marksContacts_ && posed_ && contacts && contacts->touches()) {
        const ShownSides shown = terrain_->shownSides();
        const bool isMean = !contacts->sidesKnown;
        if (shown != ShownSides::Right)
            addSide(points, *contacts, robot_, *posed_, Side::Left, isOnePlane_);
        if (shown != ShownSides::Left && !isMean)
            addSide(points, *contacts, robot_, *posed_, Side::Right, isOnePlane_);
    }
    terrain_->setContacts(std::move(points));
}

}  // namespace terratact
