#include "core/robot/watch/ground_watch.h"

#include <algorithm>
#include <cmath>

namespace terratact {
namespace {

constexpr int kPressLines = 6;
constexpr double kFelt = 2.0;          // [N] load of an element that counts
constexpr double kFeltAtAll = 6.0;     // [N] least load of all elements together
constexpr double kHangingFree = -1.0;  // [rad] below this angle the flippers may hang free
constexpr std::size_t kContacts = 32;

constexpr double kSd = 0.022;        // [m] sd of a contact against the ground
constexpr double kSdOfPitch = 0.13;  // [m/rad] sd per turn of the robot since the contact
constexpr double kPassed =
    0.1;  // [m] a point this far in front of the base origin is behind the tracks' front end
constexpr double kCutContact = 2.5;   // largest deviation of a contact, in its sd
constexpr double kMaxShift = 2.0;     // largest effect of kOffset, in that sd
constexpr double kOneEnd = 2.5;       // log-likelihood of a press that loads one end only
constexpr double kFirstAlone = 0.05;  // share of the edge beyond the outermost element
constexpr double kPerMetre = 30.0;    // log-likelihood per metre of better fit
constexpr double kCutOrder = 0.04;    // [m]

constexpr double kRearStep = 0.1;  // [m] way between two checks
constexpr std::size_t kRearCells = 5;
constexpr double kCutRear = 0.05;     // [m]
constexpr double kDrain = 0.005;      // [m]
constexpr double kWeightShare = 0.5;  // largest share of the weight that the rear flippers carry
constexpr double kMaxLever = 0.15;    // [m]
constexpr double kEarthGravity = 9.81;

Measurement withRearFlipped(Measurement line)
{
    line.rearLeft = -line.rearLeft;
    line.rearRight = -line.rearRight;
    return line;
}

}  // namespace

GroundWatch::GroundWatch(const RobotModel& robot) : robot_(robot), ground_(robot), flipped_(robot)
{
}

void GroundWatch::reset()
{
    rear_ = {};
    ground_ = DrivenGround(robot_);
    flipped_ = DrivenGround(robot_);
    contacts_.clear();
    press_.reset();
    turned_.reset();
    judgedAt_ = 0.0;
    found_.clear();
}

bool GroundWatch::isCleared(const SensorSuspicion& s) const
{
    if (s.trouble == SensorTrouble::WrongOrder) return wrongOrder_ < kOrderLimit / 2.0;
    if (s.trouble != SensorTrouble::OffGround) return false;
    return s.sensor <= Sensor::FrontRight ? tooHigh_ < kFrontLimit / 2.0
                                          : wrongRear_ < kRearLimit / 2.0;
}

void GroundWatch::suspect(Sensor first, Sensor last, SensorTrouble trouble, double now,
                          double amount)
{
    for (std::size_t i = indexOf(first); i <= indexOf(last); ++i)
        found_.push_back(suspicionFor(kHold, sensorAt(i), trouble, now, amount));
}

void GroundWatch::add(const Measurement& line)
{
    found_.clear();
    if (!line.travelled) return;
    const double turned = line.turned.value_or(0.0);
    if (std::abs(turnBetween(turned_.value_or(turned), turned)) > kTurn) reset();
    turned_ = turned_.value_or(turned);
    rear_.add(line);
    ground_.add(line, rear_.isLoaded());
    flipped_.add(withRearFlipped(line), rear_.isLoaded());
    for (Contact& contact : contacts_)
        contact.pitchChange =
            std::max(contact.pitchChange, std::abs(ground_.smoothPitch() - contact.pitch));
    follow(line);
    if (!ground_.hasMoved()) return;
    judgeRear(line.time);
    judgePassed(line.time);
}

void GroundWatch::follow(const Measurement& line)
{
    if (line.activity != RobotActivity::Pressed) {
        press_.reset();
        return;
    }
    if (!press_) press_ = Press{};
    if (press_->lines++ >= kPressLines) return;
    press_->pitch += line.pitch / kPressLines;
    press_->front += (line.frontLeft + line.frontRight) / (2.0 * kPressLines);
    for (std::size_t e = 0; e < press_->force.size(); ++e)
        if (!line.missing[kFirstForceFeature + e]) press_->force[e] += line.force[e] / kPressLines;
    if (press_->lines == kPressLines) feel(*press_);
}

void GroundWatch::feel(const Press& press)
{
    double sum = 0.0, felt = 0.0, mirrored = 0.0;
    const auto& shares = robot_.elementShare;
    for (std::size_t e = 0; e < shares.size(); ++e) {
        if (press.force[e] < kFelt) continue;
        sum += press.force[e];
        felt += press.force[e] * shares[e];
        mirrored += press.force[e] * shares[shares.size() - 1 - e];
    }
    if (sum < kFeltAtAll || press.front < kHangingFree) return;
    const Pose pose = ground_.poseWith(press.pitch, press.front);
    const double share = felt / sum;
    contacts_.push_back({.felt = elementPosition(robot_, pose, share),
                         .mirrored = elementPosition(robot_, pose, mirrored / sum),
                         .share = share,
                         .pitch = press.pitch});
    if (contacts_.size() > kContacts) contacts_.pop_front();
    if (share > shares.back() - kFirstAlone) wrongOrder_ = std::max(0.0, wrongOrder_ - kOneEnd);
    if (share < shares.front() + kFirstAlone) wrongOrder_ += kOneEnd;
}

void GroundWatch::judgePassed(double now)
{
    while (!contacts_.empty()) {
        const Contact contact = contacts_.front();
        if (std::max(contact.felt.x, contact.mirrored.x) > ground_.pose().base.x + kPassed) return;
        contacts_.pop_front();
        judgeContact(contact, now);
    }
}

void GroundWatch::judgeContact(const Contact& contact, double now)
{
    const auto highest = ground_.highestAt(contact.felt.x);
    if (!highest) return;
    const double room = *highest - contact.felt.z;
    const double sd = std::hypot(kSd, kSdOfPitch * contact.pitchChange);
    const double shift =
        std::min(kMaxShift, kOffset * contact.share * robot_.front.edgeLength() / sd);
    const double z = std::clamp(-room / sd, -kCutContact, kCutContact);
    tooHigh_ = std::clamp(tooHigh_ + shift * (z - shift / 2.0), 0.0, 2.0 * kFrontLimit);
    if (tooHigh_ > kFrontLimit)
        suspect(Sensor::FrontLeft, Sensor::FrontRight, SensorTrouble::OffGround, now, -room);
    const auto other = ground_.highestAt(contact.mirrored.x);
    if (!other) return;
    const double better = std::clamp(*other - contact.mirrored.z - room, -kCutOrder, kCutOrder);
    wrongOrder_ = std::clamp(wrongOrder_ + kPerMetre * better, 0.0, 2.0 * kOrderLimit);
    if (wrongOrder_ > kOrderLimit)
        suspect(Sensor::Force1, Sensor::Force6, SensorTrouble::WrongOrder, now, better);
}

std::optional<double> GroundWatch::rearGap(const DrivenGround& ground) const
{
    const TaperedHull flipper = shapeAt(robot_, ground.pose()).rear;
    // A torque needs a lever: the load lies at least this far behind the flippers' pivot.
    const double torque = 2.0 * robot_.torquePerAmpere * rear_.current();
    const double lever =
        rear_.isLoaded()
            ? std::min(kMaxLever, torque / (kWeightShare * robot_.totalMass() * kEarthGravity))
            : 0.0;
    const double until = ground.pose().base.x + robot_.rear.pivot.x - lever;
    std::size_t cells = 0;
    double gap = 0.0;
    const double from = std::max(flipper.b.x - flipper.rb, ground.passedFrom());
    for (int cell = 0; from + cell * DrivenGround::kCell < until; ++cell) {
        const double x = from + cell * DrivenGround::kCell;
        const double edge = lowerBoundary(flipper, x);
        const auto highest = ground.highestAt(x);
        if (!highest || !std::isfinite(edge)) continue;
        gap = cells == 0 ? edge - *highest : std::min(gap, edge - *highest);
        ++cells;
    }
    return cells > kRearCells ? std::optional(gap) : std::nullopt;
}

void GroundWatch::judgeRear(double now)
{
    if (ground_.way() - judgedAt_ < kRearStep) return;
    judgedAt_ = ground_.way();
    if (std::abs(ground_.pose().rear) < kMinRear) return;
    const auto asRead = rearGap(ground_), asFlipped = rearGap(flipped_);
    if (!asRead || !asFlipped) return;
    const auto misfit = [this](double gap) {
        return gap < 0.0 || rear_.isLoaded() ? std::abs(gap) : 0.0;
    };
    const double better = std::clamp(misfit(*asRead) - misfit(*asFlipped), -kCutRear, kCutRear);
    wrongRear_ = std::clamp(wrongRear_ + better - kDrain, 0.0, 2.0 * kRearLimit);
    if (wrongRear_ > kRearLimit)
        suspect(Sensor::RearLeft, Sensor::RearRight, SensorTrouble::OffGround, now, *asRead);
}

}  // namespace terratact
