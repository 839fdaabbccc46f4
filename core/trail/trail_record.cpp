#include "core/trail/trail_record.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/robot/kinematics.h"
#include "core/robot/side_plane.h"

namespace terratact {
namespace {

constexpr double kUncovered = std::numeric_limits<double>::infinity();
constexpr double kWindow = 0.05;            // [m] half a window of the attitude
constexpr double kMinForce = 0.6;           // [N] twice an element's noise
constexpr double kRounding = 1e-9;          // [m]
constexpr double kSameTilt = 0.02;          // [rad] of a scene that replaces one at its place
constexpr std::array kSlopes{-0.35, 0.35};  // of ground that carries a height

/// Returns the plane in which an arm reading lies.
std::size_t planeOf(ProbeSide side)
{
    switch (side) {
    case ProbeSide::Left: return 1;
    case ProbeSide::Right: return 2;
    case ProbeSide::Middle: break;
    }
    return 0;
}

/// Returns true if front forces are known of both sides.
bool hasBothSides(const Measurement& line)
{
    const auto known = [](const std::optional<double>& force) { return force.has_value(); };
    return std::ranges::any_of(line.sides.left, known)
        && std::ranges::any_of(line.sides.right, known);
}

/// Returns the parts that lie in stretches of both lists.
std::vector<GroundStretch> common(const std::vector<GroundStretch>& a,
                                  const std::vector<GroundStretch>& b)
{
    std::vector<GroundStretch> both;
    for (const GroundStretch& one : a)
        for (const GroundStretch& other : b) {
            const GroundStretch part{std::max(one.from, other.from), std::min(one.to, other.to)};
            if (part.from < part.to) both.push_back(part);
        }
    return both;
}

/// Writes a bin that the arm measured once or more (TrailRecord::kRememberedSd).
void writeArmBin(TrailGround& ground, std::size_t bin,
                 const std::vector<TrailRecord::CarriedReading>& readings)
{
    const auto [lowest, highest] =
        std::ranges::minmax_element(readings, {}, &TrailRecord::CarriedReading::height);
    const double apart = highest->height - lowest->height;
    if (apart > TrailRecord::kArmContradiction * std::hypot(lowest->sd, highest->sd)) {
        ground.armHeight[bin] = lowest->height;
        ground.armSd[bin] = apart;
        ground.felt[bin] = 0;
        return;
    }
    const auto surest = std::ranges::min_element(readings, {}, &TrailRecord::CarriedReading::sd);
    ground.armHeight[bin] = surest->height;
    ground.armSd[bin] = surest->sd;
}

/// Returns how far the ground beside a robot has moved sideways between two poses [m]. It is the
/// farthest of places up to 0.8 m ahead.
double sidewaysOf(const WayPose& from, const WayPose& to, double halfWidth)
{
    constexpr double kAhead = 0.8;  // [m] the arm's reach
    double farthest = 0.0;
    const double turn = from.heading - to.heading;
    const double east = from.planX - to.planX, north = from.planY - to.planY;
    const double moved = -std::sin(to.heading) * east + std::cos(to.heading) * north;
    for (const double x : {0.0, kAhead})
        for (const double y : {-halfWidth, halfWidth})
            farthest =
                std::max(farthest, std::abs(moved + std::sin(turn) * x + std::cos(turn) * y - y));
    return farthest;
}

struct PlaneOfLine {
    RobotModel robot;
    Proprioception s;
};

/// Returns the plane of a line: 0 the middle, 1 the left and 2 the right side at this y [m].
PlaneOfLine planeOf(const RobotModel& robot, const Measurement& line, std::size_t plane, double y)
{
    if (plane == 0) return {robot, proprioception(line)};
    const Side side = plane == 1 ? Side::Left : Side::Right;
    return {inSidePlane(robot, line.roll, signOf(side) * y),
            sideReadings(twoTrackReadings(line), side)};
}

TrailEnvelope envelopeOf(const PlaneOfLine& plane)
{
    const RobotShape shape =
        shapeAt(plane.robot, poseInDem(plane.robot, plane.s.pitch, plane.s.front, plane.s.rear));
    TrailEnvelope envelope{};
    for (std::size_t k = 0; k < kEnvelopePoints; ++k)
        envelope[k] = lowerEnvelope(shape, kEnvelopeBegin + kEnvelopeStep * static_cast<double>(k));
    return envelope;
}

/// Returns an envelope at x [m], linear between two points; +infinity beside the robot.
double envelopeAt(const TrailEnvelope& envelope, double x)
{
    const double at = (x - kEnvelopeBegin) / kEnvelopeStep;
    if (!(at >= 0.0) || at > static_cast<double>(kEnvelopePoints - 1)) return kUncovered;
    const auto k = std::min(static_cast<std::size_t>(at), kEnvelopePoints - 2);
    const double share = at - static_cast<double>(k);
    if (share == 0.0) return envelope[k];
    if (share == 1.0) return envelope[k + 1];
    return envelope[k] * (1.0 - share) + envelope[k + 1] * share;
}

/// Returns the mean over a bin of an envelope: half its centre, a quarter each of its borders.
double overBin(const TrailEnvelope& envelope, std::size_t bin)
{
    const auto centre = static_cast<std::size_t>(
        std::lround((binCentre(static_cast<int>(bin)) - kEnvelopeBegin) / kEnvelopeStep));
    return 0.25 * envelope[centre - 1] + 0.5 * envelope[centre] + 0.25 * envelope[centre + 1];
}

}  // namespace

TrailRecord::TrailRecord(const RobotModel& robot, const WayLimits& limits)
    : robot_(robot), way_(robot, limits)
{
}

void TrailRecord::end(SectionStart why)
{
    way_.end(why);
    forgetAfterBreak();
}

void TrailRecord::forgetAfterBreak()
{
    if (segment_ == way_.segment()) return;
    segment_ = way_.segment();
    begin_.reset();
    odometry_.reset();
    places_.clear();
    presses_.clear();
}

TrailRecord::Place TrailRecord::placeOf(const WayPose& pose, const Measurement& line,
                                        bool isScene) const
{
    Place place{pose.way, line.travelled.value_or(0.0), pose.imu, line.pitch, line.roll, {},
                isScene};
    for (std::size_t p = 0; p < kTrailPlanes; ++p)
        place.envelope[p] = envelopeOf(planeOf(robot_, line, p, robot_.lateral.trackY));
    return place;
}

void TrailRecord::add(const Measurement& line)
{
    way_.add(line);
    newest_ = line.time;
    forgetAfterBreak();
    const std::optional<WayPose> pose = way_.now();
    if (!pose) return;
    addOdometry(line);
    begin_ = std::min(begin_.value_or(*line.travelled), *line.travelled);
    dropAhead(*line.travelled);
    const bool isNear = !places_.empty() && pose->way - lastLine_ < kStep;
    if (isNear) return;
    lastLine_ = pose->way;
    places_.push_back(placeOf(*pose, line, false));
    dropOld(pose->way, *line.travelled);
}

void TrailRecord::addOdometry(const Measurement& line)
{
    const OdometryLine odometry = odometryOf(line);
    if (odometry_)
        odometry_->add(odometry);
    else
        odometry_.emplace(robot_, odometry);
    for (Press& press : presses_) {
        const OdometryLine& then = press.at.line;
        press.tilt.pitch = std::max(press.tilt.pitch, std::abs(line.pitch - then.pitch));
        press.tilt.roll = std::max(press.tilt.roll, std::abs(line.roll - then.roll));
    }
}

/// Drops what was learnt ahead of the robot, which has driven back.
void TrailRecord::dropAhead(double travelled)
{
    while (!places_.empty() && places_.back().travelled - travelled >= kStep) places_.pop_back();
    for (Press& press : presses_)
        press.isAhead = press.isAhead || press.at.line.travelled - travelled >= kStep;
}

void TrailRecord::dropOld(double way, double travelled)
{
    for (; !places_.empty() && way - places_.front().way > kLength; places_.pop_front())
        begin_ = std::max(*begin_, places_.front().travelled);
    while (!presses_.empty() && way - presses_.front().pose.way > kLength) presses_.pop_front();
    begin_ = std::max(*begin_, travelled - kLength);
}

double TrailRecord::length() const
{
    return odometry_ && begin_ ? odometry_->now().line.travelled - *begin_ : 0.0;
}

std::optional<WayPose> TrailRecord::poseAt(const Measurement& scene) const
{
    if (!newest_ || !scene.travelled || !begin_) return std::nullopt;
    StripWay way = way_;
    Measurement now = scene;
    now.time = std::max(scene.time, *newest_);
    way.add(now);
    if (way.segment() != segment_) return std::nullopt;
    return way.now();
}

/// Returns true if two poses lie more than half a flipper's width apart sideways.
bool TrailRecord::isAside(const WayPose& then, const WayPose& now) const
{
    return sidewaysOf(then, now, robot_.lateral.flipperY) > 0.5 * robot_.lateral.flipperWidth;
}

/// Returns true if the robot has not moved, tilted or turned since the arm measured. Small steps add up.
bool TrailRecord::standsAt(const ArmPlace& place, const Measurement& scene,
                           const WayPose& pose) const
{
    return scene.turned && std::abs(pose.way - place.pose.way) < kStep
        && std::abs(place.pitch - scene.pitch) < kSameTilt
        && std::abs(place.roll - scene.roll) < kSameTilt && !isAside(place.pose, pose);
}

void TrailRecord::addScene(const Measurement& scene)
{
    Measurement now = scene;
    now.time = std::max(scene.time, newest_.value_or(scene.time));
    add(now);
    const std::optional<WayPose> pose = way_.now();
    if (!pose) return;
    Press press{*pose, odometry_->now(), {}, {}, {}, {}};
    for (std::size_t p = 0; p < kTrailPlanes; ++p) {
        const PlaneOfLine plane = planeOf(robot_, scene, p, robot_.lateral.flipperY);
        const Pose inDem = poseInDem(plane.robot, plane.s.pitch, plane.s.front, plane.s.rear);
        for (std::size_t e = 0; e < std::size_t{kForceElements}; ++e) {
            const Vec2 at = elementPosition(plane.robot, inDem, plane.robot.elementShare[e]);
            press.elements[p][e] = {at.x, at.z, plane.s.force[e].value_or(0.0)};
        }
        press.pressed[p] = pressedStretches(plane.robot, plane.s);
    }
    if (hasBothSides(scene)) press.pressed[0] = common(press.pressed[1], press.pressed[2]);
    if (!presses_.empty() && std::abs(pose->way - presses_.back().pose.way) < kStep) {
        Press& before = presses_.back();
        if (before.armAt && standsAt(*before.armAt, scene, *pose)) {
            press.arm = std::move(before.arm);
            press.armAt = before.armAt;
        }
        presses_.pop_back();
        std::erase_if(places_, [&](const Place& place) {
            return place.isScene && std::abs(place.way - pose->way) < kStep;
        });
    }
    presses_.push_back(press);
    places_.push_back(placeOf(*pose, scene, true));
}

void TrailRecord::addArm(const Measurement& scene, const ArmReading& reading)
{
    const std::optional<WayPose> pose = poseAt(scene);
    if (!pose || presses_.empty()) return;
    Press& press = presses_.back();
    if (std::abs(pose->imu.x - press.pose.imu.x) >= kStep) return;
    std::erase_if(press.arm, [&](const ArmReading& other) {
        return other.bin == reading.bin && other.side == reading.side;
    });
    press.arm.push_back(reading);
    if (!press.armAt) press.armAt = ArmPlace{*pose, scene.pitch, scene.roll};
}

std::vector<ArmReading> TrailRecord::armHere() const
{
    return presses_.empty() ? std::vector<ArmReading>{} : presses_.back().arm;
}

void TrailRecord::forgetFelt()
{
    for (Press& press : presses_) {
        press.arm.clear();
        press.armAt.reset();
        for (auto& stretches : press.pressed) stretches.clear();
    }
}

TrailHistory TrailRecord::before(const Measurement& scene, double way) const
{
    TrailHistory history = emptyHistory(scene.pitch, scene.roll);
    const std::optional<WayPose> pose = poseAt(scene);
    if (!pose) return history;
    history.way = std::clamp(*scene.travelled - *begin_, 0.0, std::min(way, kTrailReach));
    writeAttitude(history, *scene.travelled);
    writeLowest(history, scene, *pose);
    writePressed(history, scene, *pose);
    writeFelt(history, scene, *pose);
    return history;
}

void TrailRecord::writeAttitude(TrailHistory& history, double travelled) const
{
    for (std::size_t k = 0; k < kTrailPlaces; ++k) {
        const double back = kTrailPlaceStep * static_cast<double>(k + 1);
        double pitch = 0.0, roll = 0.0;
        int count = 0;
        for (const Place& place : places_) {
            if (place.isScene || travelled - place.travelled > history.way + kRounding
                || std::abs(travelled - place.travelled - back) > kWindow)
                continue;
            pitch += place.pitch;
            roll += place.roll;
            ++count;
        }
        if (count == 0 && k == 0) continue;  // the scene's own
        history.pitch[k] = count > 0 ? pitch / count : history.pitch[k - 1];
        history.roll[k] = count > 0 ? roll / count : history.roll[k - 1];
    }
}

void TrailRecord::writeLowest(TrailHistory& history, const Measurement& scene,
                              const WayPose& pose) const
{
    const Place own = placeOf(pose, scene, true);
    for (std::size_t p = 0; p < kTrailPlanes; ++p) {
        TrailEnvelope lowest = own.envelope[p];
        for (const Place& place : places_) {
            if (*scene.travelled - place.travelled > history.way + kRounding) continue;
            const double dx = place.imu.x - pose.imu.x, dz = place.imu.z - pose.imu.z;
            for (std::size_t k = 0; k < kEnvelopePoints; ++k) {
                const double x = kEnvelopeBegin + kEnvelopeStep * static_cast<double>(k);
                lowest[k] = std::min(lowest[k], envelopeAt(place.envelope[p], x - dx) + dz);
            }
        }
        for (std::size_t bin = 0; bin < kTrailBins; ++bin)
            history.ground[p].lowest[bin] = overBin(lowest, bin);
    }
}

bool TrailRecord::isBefore(const Press& press, const Measurement& scene, const WayPose& pose,
                           double reach)
{
    const double behind = *scene.travelled - press.at.line.travelled;
    const double way = pose.way - press.pose.way;
    return std::abs(behind) <= reach + kRounding
        && std::abs(way) >= kStep;  // else the scene itself
}

std::optional<TrailRecord::Carried> TrailRecord::carried(const Press& press, double reach,
                                                         const Measurement& scene,
                                                         const WayPose& pose) const
{
    if (!scene.turned || !isBefore(press, scene, pose, reach)) return std::nullopt;
    const ReckonedState now = odometry_->after(odometryOf(scene));
    TiltRange tilt = press.tilt;
    tilt.pitch = std::max(tilt.pitch, std::abs(scene.pitch - press.at.line.pitch));
    tilt.roll = std::max(tilt.roll, std::abs(scene.roll - press.at.line.roll));
    Carried to;
    to.since = odometry_->motion(press.at, now, tilt);
    to.dx = press.pose.imu.x - pose.imu.x;
    to.dz = press.pose.imu.z - pose.imu.z;
    to.sd = carriedSd(to.since, kSlopes);
    to.slip = std::abs(to.since.slipForward);
    if (to.sd > kRememberedSd || isAside(press.pose, pose)) return std::nullopt;
    return to;
}

void TrailRecord::writeFelt(TrailHistory& history, const Measurement& scene,
                            const WayPose& pose) const
{
    std::array<std::vector<GroundStretch>, kTrailPlanes> felt;
    for (const Press& press : presses_) {
        if (press.isAhead) continue;
        const std::optional<Carried> to = carried(press, history.way, scene, pose);
        if (!to) continue;
        for (std::size_t p = 0; p < kTrailPlanes; ++p)
            for (const GroundStretch& pressed : press.pressed[p])
                felt[p].push_back(
                    {pressed.from + to->dx + to->slip, pressed.to + to->dx - to->slip});
    }
    for (std::size_t p = 0; p < kTrailPlanes; ++p) {
        FeltCells& cells = history.ground[p].felt;
        cells = cellsOf(felt[p]);
        // The history knows no heights beyond these bins.
        std::fill(cells.begin() + kTrailBins, cells.end(), std::uint16_t{0});
    }
    writeArm(history, scene, pose);
}

void TrailRecord::writeArm(TrailHistory& history, const Measurement& scene,
                           const WayPose& pose) const
{
    std::array<std::array<std::vector<CarriedReading>, kBins>, kTrailPlanes> readings;
    for (const Press& press : presses_) {
        const std::optional<Carried> to = carried(press, kTrailReach, scene, pose);
        if (!to) continue;
        for (const ArmReading& reading : press.arm) {
            const double x = binCentre(reading.bin) + to->dx;
            const auto bin = static_cast<int>(std::lround((x - binCentre(0)) / kBinWidth));
            if (bin < 0 || bin >= kBins) continue;
            const double away = std::abs(x - binCentre(bin)) + to->slip;
            readings[planeOf(reading.side)][static_cast<std::size_t>(bin)].push_back(
                {reading.height + to->dz, std::hypot(reading.sd, to->sd, kArmSlope * away)});
        }
    }
    for (std::size_t p = 0; p < kTrailPlanes; ++p)
        for (std::size_t bin = 0; bin < kBins; ++bin)
            if (!readings[p][bin].empty()) writeArmBin(history.ground[p], bin, readings[p][bin]);
}

void TrailRecord::writePressed(TrailHistory& history, const Measurement& scene,
                               const WayPose& pose) const
{
    for (const Press& press : presses_) {
        if (press.isAhead) continue;
        if (!isBefore(press, scene, pose, history.way)) continue;
        ++history.presses;
        const double dx = press.pose.imu.x - pose.imu.x, dz = press.pose.imu.z - pose.imu.z;
        for (std::size_t p = 0; p < kTrailPlanes; ++p)
            for (const Element& element : press.elements[p]) {
                if (element.force < kMinForce) continue;
                TrailGround& ground = history.ground[p];
                for (std::size_t bin = 0; bin < kTrailBins; ++bin) {
                    const double away = std::abs(element.x + dx - binCentre(static_cast<int>(bin)));
                    const double load = element.force * std::max(1.0 - away / kBinWidth, 0.0);
                    ground.load[bin] += load;
                    ground.pressed[bin] += load * (element.z + dz);
                }
            }
    }
    for (TrailGround& ground : history.ground)
        for (std::size_t bin = 0; bin < kTrailBins; ++bin)
            if (ground.load[bin] > 0.0) ground.pressed[bin] /= ground.load[bin];
}

}  // namespace terratact
