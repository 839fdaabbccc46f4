#include "core/sim/sensor_fault.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/base/degree.h"

namespace terratact {
namespace {

constexpr double kDelay = 0.5;        // [s]
constexpr double kMaxDelay = 10.0;    // [s]
constexpr double kMinute = 60.0;      // [s]
constexpr double kSpikeShare = 0.25;  // share of the lines

struct NamedKind {
    std::string_view name;
    FaultKind kind;
};
constexpr std::array kFaultNames{NamedKind{"stuck", FaultKind::Stuck},
                                 NamedKind{"stuck-at-scene", FaultKind::StuckAtScene},
                                 NamedKind{"zero", FaultKind::Zero},
                                 NamedKind{"offset", FaultKind::Offset},
                                 NamedKind{"drift", FaultKind::Drift},
                                 NamedKind{"spikes", FaultKind::Spikes},
                                 NamedKind{"scatter", FaultKind::Scatter},
                                 NamedKind{"flipped", FaultKind::Flipped},
                                 NamedKind{"swapped", FaultKind::Swapped},
                                 NamedKind{"swapped-axles", FaultKind::SwappedAxles},
                                 NamedKind{"late", FaultKind::Late},
                                 NamedKind{"out-of-range", FaultKind::OutOfRange},
                                 NamedKind{"full-scale", FaultKind::FullScale},
                                 NamedKind{"lost", FaultKind::Lost}};

struct NamedSensors {
    std::string_view name;
    Sensor first, last;
};
constexpr std::array kSensorNames{
    NamedSensors{"pitch", Sensor::Pitch, Sensor::Pitch},
    NamedSensors{"roll", Sensor::Roll, Sensor::Roll},
    NamedSensors{"attitude", Sensor::Pitch, Sensor::Roll},
    NamedSensors{"front", Sensor::FrontLeft, Sensor::FrontRight},
    NamedSensors{"rear", Sensor::RearLeft, Sensor::RearRight},
    NamedSensors{"angles", Sensor::FrontLeft, Sensor::RearRight},
    NamedSensors{"front-left", Sensor::FrontLeft, Sensor::FrontLeft},
    NamedSensors{"front-right", Sensor::FrontRight, Sensor::FrontRight},
    NamedSensors{"rear-left", Sensor::RearLeft, Sensor::RearLeft},
    NamedSensors{"rear-right", Sensor::RearRight, Sensor::RearRight},
    NamedSensors{"front-current", Sensor::FrontLeftCurrent, Sensor::FrontRightCurrent},
    NamedSensors{"rear-current", Sensor::RearLeftCurrent, Sensor::RearRightCurrent},
    NamedSensors{"currents", Sensor::FrontLeftCurrent, Sensor::RearRightCurrent},
    NamedSensors{"front-left-current", Sensor::FrontLeftCurrent, Sensor::FrontLeftCurrent},
    NamedSensors{"front-right-current", Sensor::FrontRightCurrent, Sensor::FrontRightCurrent},
    NamedSensors{"rear-left-current", Sensor::RearLeftCurrent, Sensor::RearLeftCurrent},
    NamedSensors{"rear-right-current", Sensor::RearRightCurrent, Sensor::RearRightCurrent},
    NamedSensors{"forces", Sensor::Force1, Sensor::Force6},
    NamedSensors{"force-1", Sensor::Force1, Sensor::Force1},
    NamedSensors{"force-2", Sensor::Force2, Sensor::Force2},
    NamedSensors{"force-3", Sensor::Force3, Sensor::Force3},
    NamedSensors{"force-4", Sensor::Force4, Sensor::Force4},
    NamedSensors{"force-5", Sensor::Force5, Sensor::Force5},
    NamedSensors{"force-6", Sensor::Force6, Sensor::Force6},
    NamedSensors{"odometry", Sensor::Travelled, Sensor::Travelled},
    NamedSensors{"all", Sensor::Pitch, Sensor::Travelled}};

constexpr std::array<std::string_view, 2> kSides{"left-", "right-"};
constexpr std::string_view kForceName = "force";

template <class Named, std::size_t n>
const Named* find(std::string_view text, const std::array<Named, n>& all)
{
    const auto found =
        std::find_if(all.begin(), all.end(), [text](const Named& one) { return one.name == text; });
    return found == all.end() ? nullptr : &*found;
}

/// Returns the text without a side before forces, and element 1 of that side or of the means.
std::pair<std::string_view, Sensor> withoutSide(std::string_view text)
{
    constexpr std::array kFirst{Sensor::LeftForce1, Sensor::RightForce1};
    for (std::size_t k = 0; k < kSides.size(); ++k)
        if (text.starts_with(kSides[k]) && text.substr(kSides[k].size()).starts_with(kForceName))
            return {text.substr(kSides[k].size()), kFirst[k]};
    return {text, Sensor::Force1};
}

/// Returns element e of the same side, or of the means.
Sensor likeForce(Sensor force, std::size_t e)
{
    return sensorAt(indexOf(force) - elementOf(force) + e);
}

double usualAmount(FaultKind kind, Sensor sensor)
{
    if (kind == FaultKind::Late) return kDelay;
    const double factor = kind == FaultKind::Drift ? 0.1 : 1.0;
    switch (kindOf(sensor)) {
    case SensorKind::Attitude:
    case SensorKind::Angle: return 10.0 * kDegree * factor;
    case SensorKind::Current: return 1.0 * factor;
    case SensorKind::Force: return 3.0 * factor;
    case SensorKind::Way: return 1.0 * factor;
    }
    return factor;
}

std::optional<double> numberIn(std::string_view text)
{
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool whole = error == std::errc() && end == text.data() + text.size();
    return whole && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

/// Returns the same sensor of the other side; for a force, the element counted from the other end.
Sensor opposite(Sensor sensor)
{
    const std::size_t i = indexOf(sensor);
    const std::size_t angle = indexOf(Sensor::FrontLeft);
    if (sensor >= Sensor::FrontLeft && sensor <= Sensor::RearRightCurrent)
        return sensorAt(angle + ((i - angle) ^ 1U));
    if (kindOf(sensor) == SensorKind::Force)
        return likeForce(sensor, kForceElements - 1 - elementOf(sensor));
    return sensor;
}

/// Returns the same sensor of the other axle.
Sensor ofOtherAxle(Sensor sensor)
{
    const std::size_t angle = indexOf(Sensor::FrontLeft);
    if (sensor < Sensor::FrontLeft || sensor > Sensor::RearRightCurrent) return sensor;
    return sensorAt(angle + ((indexOf(sensor) - angle) ^ 2U));
}

/// Returns the readings that a fault of the sensor changes. These are a mean force if no side is
/// known, else its sides.
std::vector<Sensor> readingsWith(Sensor sensor, const Measurement& line)
{
    if (kindOf(sensor) != SensorKind::Force) return {sensor};
    const std::size_t e = elementOf(sensor);
    if (!line.sides.knows(e)) return {meanForce(e)};
    return isMeanForce(sensor) ? std::vector{leftForce(e), rightForce(e)} : std::vector{sensor};
}

/// Returns the reading with the fault of `sensor`: a mean has half of a fault of one side.
double ofReading(Sensor sensor, Sensor reading, double truth, double wrong)
{
    return isSideForce(sensor) && isMeanForce(reading) ? (truth + wrong) / 2.0 : wrong;
}

/// Returns true for a sensor without which there is no line of telemetry.
bool isAlwaysMeasured(Sensor sensor)
{
    const SensorKind kind = kindOf(sensor);
    return kind == SensorKind::Attitude || kind == SensorKind::Angle;
}

void loseCurrent(Measurement& line, Sensor sensor)
{
    MotorCurrents currents = motorCurrents(line);
    currents[indexOf(sensor) - indexOf(Sensor::FrontLeftCurrent)].reset();
    setCurrents(line, currents);
}

/// Loses a mean of which no side is known, or one side; the mean follows it.
void loseForce(Measurement& line, Sensor force)
{
    const std::size_t e = elementOf(force);
    auto& [left, right] = line.sides;
    if (isSideForce(force)) (force < Sensor::RightForce1 ? left : right)[e].reset();
    line.force[e] = meanOfSides(left[e], right[e]).value_or(0.0);
    line.missing[kFirstForceFeature + e] = !line.sides.knows(e);
}

void lose(Measurement& line, Sensor sensor)
{
    if (sensor == Sensor::Travelled) {
        line.travelled.reset();
        line.turned.reset();  // a frame has both or neither
    } else if (kindOf(sensor) == SensorKind::Current) {
        loseCurrent(line, sensor);
    } else {
        for (const Sensor of : readingsWith(sensor, line))
            if (isMeanForce(sensor) || isSideForce(of)) loseForce(line, of);
    }
}

Measurement lineOf(const Proprioception& s, double time)
{
    Measurement m;
    m.time = time;
    m.pitch = s.pitch;
    m.frontLeft = m.frontRight = s.front;
    m.rearLeft = m.rearRight = s.rear;
    setCurrents(m, {s.frontCurrent, s.frontCurrent, s.rearCurrent, s.rearCurrent});
    for (std::size_t e = 0; e < m.force.size(); ++e) m.force[e] = s.force[e].value_or(0.0);
    m.missing = missingFeatures(s);
    m.activity = RobotActivity::Pressed;
    return m;
}

}  // namespace

std::optional<SensorFault> sensorFaultFrom(std::string_view text)
{
    const std::size_t first = text.find(':');
    if (first == std::string_view::npos) return std::nullopt;
    const std::size_t second = text.find(':', first + 1);
    const auto* kind = find(text.substr(0, first), kFaultNames);
    const auto [name, firstForce] = withoutSide(
        text.substr(first + 1, second == std::string_view::npos ? second : second - first - 1));
    const auto* sensors = find(name, kSensorNames);
    if (!kind || !sensors) return std::nullopt;
    SensorFault fault{.kind = kind->kind, .sensors = {}, .amount = 0.0};
    for (std::size_t i = indexOf(sensors->first); i <= indexOf(sensors->last); ++i) {
        const Sensor sensor = sensorAt(i);
        fault.sensors.push_back(isMeanForce(sensor) ? likeForce(firstForce, elementOf(sensor))
                                                    : sensor);
    }
    if (fault.kind == FaultKind::Lost) std::erase_if(fault.sensors, isAlwaysMeasured);
    if (fault.sensors.empty()) return std::nullopt;
    fault.amount = usualAmount(fault.kind, sensors->first);
    if (second == std::string_view::npos) return fault;
    const auto amount = numberIn(text.substr(second + 1));
    if (!amount || std::abs(*amount) > 1000.0) return std::nullopt;
    if (fault.kind == FaultKind::Late && !(*amount >= 0.0 && *amount <= kMaxDelay))
        return std::nullopt;
    fault.amount = *amount;
    return fault;
}

std::string sensorFaultSyntax()
{
    std::string text = "KIND:SENSORS or KIND:SENSORS:AMOUNT, KIND one of";
    for (const NamedKind& kind : kFaultNames) text += ' ' + std::string(kind.name);
    text += ", SENSORS one of";
    for (const NamedSensors& sensors : kSensorNames) text += ' ' + std::string(sensors.name);
    for (const std::string_view side : kSides)
        for (const NamedSensors& sensors : kSensorNames)
            if (sensors.name.starts_with(kForceName))
                text += ' ' + std::string(side) + std::string(sensors.name);
    return text + "; only currents, forces and odometry can be lost";
}

FaultySensors::FaultySensors(SensorFault fault, const RobotModel& robot, std::uint64_t seed)
    : fault_(std::move(fault)), forceSaturation_(robot.forceSaturation),
      currentLimit_(robot.maxFlipperTorque / robot.torquePerAmpere), rng_(seed)
{
}

double FaultySensors::limitOf(Sensor sensor) const
{
    switch (kindOf(sensor)) {
    case SensorKind::Attitude: return std::numbers::pi / 4.0;
    case SensorKind::Angle: return std::numbers::pi / 2.0;
    case SensorKind::Current: return currentLimit_;
    case SensorKind::Force: return forceSaturation_;
    case SensorKind::Way: return 500.0;
    }
    return 0.0;
}

void FaultySensors::keepScene(const Measurement& truth)
{
    const RobotActivity activity = truth.activity;
    const bool isPressed = activity == RobotActivity::Pressed || activity == RobotActivity::Probing;
    const bool wasPressed = before_ == RobotActivity::Pressed || before_ == RobotActivity::Probing;
    if (isPressed && !wasPressed) nextScene_ = truth;
    if (!isPressed && wasPressed) atScene_ = nextScene_;
    before_ = activity;
}

double FaultySensors::late(Sensor sensor, double value) const
{
    const double until = past_.back().time - fault_.amount + 1e-9;
    for (std::size_t k = past_.size(); k > 0; --k) {
        const Measurement& line = past_[k - 1];
        value = readingsOf(line)[indexOf(sensor)].value_or(value);
        if (line.time <= until) break;
    }
    return value;
}

/// Returns the amount that a spike adds to this line.
double FaultySensors::push()
{
    const bool isSpike = fault_.kind == FaultKind::Spikes;
    if (!isSpike && fault_.kind != FaultKind::Scatter) return 0.0;
    if (isSpike && std::uniform_real_distribution<double>(0.0, 1.0)(rng_) >= kSpikeShare)
        return 0.0;
    return std::uniform_int_distribution<int>(0, 1)(rng_) ? fault_.amount : -fault_.amount;
}

double FaultySensors::faulty(Sensor sensor, double value, const Measurement& truth,
                             double push) const
{
    const auto of = [sensor](const Measurement& line, double otherwise) {
        return readingsOf(line)[indexOf(sensor)].value_or(otherwise);
    };
    const double elapsed = truth.time - first_->time;
    switch (fault_.kind) {
    case FaultKind::Stuck: return of(*first_, value);
    case FaultKind::StuckAtScene: return atScene_ ? of(*atScene_, value) : value;
    case FaultKind::Zero: return 0.0;
    case FaultKind::Offset: return value + fault_.amount;
    case FaultKind::Drift: return value + fault_.amount * elapsed / kMinute;
    case FaultKind::Spikes:
    case FaultKind::Scatter: return value + push;
    case FaultKind::Flipped: return -value;
    case FaultKind::Swapped:
    case FaultKind::SwappedAxles: return of(truth, value);
    case FaultKind::Late: return late(sensor, value);
    case FaultKind::OutOfRange: return 2.0 * limitOf(sensor);
    case FaultKind::FullScale: return limitOf(sensor);
    case FaultKind::Lost: break;
    }
    return value;
}

void FaultySensors::swap(Measurement& line, const Measurement& truth) const
{
    const SensorReadings from = readingsOf(truth);
    const auto set = [&](Sensor to, Sensor with, Sensor as) {
        const auto &was = from[indexOf(to)], &becomes = from[indexOf(with)];
        if (was && becomes) setReading(line, to, ofReading(as, to, *was, *becomes));
    };
    for (const Sensor sensor : fault_.sensors)
        for (const Sensor of : readingsWith(sensor, truth)) {
            const Sensor other = fault_.kind == FaultKind::Swapped ? opposite(of) : ofOtherAxle(of);
            set(of, other, sensor);
            set(other, of, sensor);
        }
}

Measurement FaultySensors::apply(const Measurement& truth)
{
    if (!first_) first_ = truth;
    keepScene(truth);
    if (fault_.kind == FaultKind::Late) {
        past_.push_back(truth);
        const double oldest = truth.time - kMaxDelay;
        while (past_.front().time < oldest) past_.pop_front();
    }
    Measurement line = truth;
    if (fault_.kind == FaultKind::Swapped || fault_.kind == FaultKind::SwappedAxles) {
        swap(line, truth);
        return line;
    }
    if (fault_.kind == FaultKind::Lost) {
        for (const Sensor sensor : fault_.sensors) lose(line, sensor);
        return line;
    }
    const SensorReadings readings = readingsOf(truth);
    for (const Sensor sensor : fault_.sensors) {
        const double added = push();
        for (const Sensor of : readingsWith(sensor, truth)) {
            const auto value = readings[indexOf(of)];
            if (!value) continue;
            double wrong = faulty(of, *value, truth, added);
            if (kindOf(of) == SensorKind::Force) wrong = std::clamp(wrong, 0.0, forceSaturation_);
            setReading(line, of, ofReading(sensor, of, *value, wrong));
        }
    }
    return line;
}

FaultyScenes::FaultyScenes(SensorFault fault, const RobotModel& robot, std::uint64_t seed)
    : fault_(std::move(fault)), flipperSpeed_(robot.flipperSpeed), sensors_(fault_, robot, seed)
{
}

Proprioception FaultyScenes::apply(const Proprioception& scene, double time)
{
    if (fault_.kind == FaultKind::Late) {
        Proprioception s = scene;
        const auto& sensors = fault_.sensors;
        if (std::find(sensors.begin(), sensors.end(), Sensor::FrontLeft) != sensors.end())
            s.front += flipperSpeed_ * fault_.amount;
        return s;
    }
    Measurement line = lineOf(scene, time);
    if (fault_.kind == FaultKind::StuckAtScene) {
        Measurement between = line;  // the way there, so that the next press counts as one
        between.activity = RobotActivity::Driving;
        sensors_.apply(between);
    }
    return proprioception(sensors_.apply(line));
}

}  // namespace terratact
