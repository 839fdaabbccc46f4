#include "core/mapping/recording_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <set>

#include "core/base/text.h"
#include "core/mapping/recording_survey.h"

namespace terratact {
namespace {

constexpr double kMaxClockOffset = 1.0, kMaxOffsetBetween = 0.1;  // [s]
constexpr std::size_t kMinSaturated = 20, kMinStuck = 50;         // values
constexpr double kSaturatedShare = 0.02;

using Findings = std::vector<std::string>;

/// Range of a series' measured values.
struct SeriesRange {
    std::size_t count = 0, atMost = 0;  ///< measured values; those that equal the largest
    double least = 0.0, most = 0.0;
};

SeriesRange rangeOf(const Series& series)
{
    SeriesRange range;
    for (const SeriesSample& sample : series) {
        if (!sample.isMeasured) continue;
        if (range.count++ == 0) range.least = range.most = sample.value;
        if (sample.value > range.most) range.atMost = 0;
        range.least = std::min(range.least, sample.value);
        range.most = std::max(range.most, sample.value);
        range.atMost += sample.value == range.most ? 1 : 0;
    }
    return range;
}

double secondsOfSeries(const Series& series)
{
    return series.empty() ? 0.0
                          : static_cast<double>(series.back().time - series.front().time) * 1e-9;
}

void addGaps(const TopicSurvey& survey, const Mapping& mapping, Findings& findings)
{
    const double longest = static_cast<double>(survey.longestGap) * 1e-9;
    if (longest <= mapping.maxGap) return;
    findings.push_back(fmt::format("topic {}: a gap of {:.3f} s at {:.3f} s is longer than "
                                   "max_gap_s, {} s; {} gaps are longer "
                                   "than {} s",
                                   printable(survey.topic.name), longest,
                                   static_cast<double>(survey.gapAt - survey.first) * 1e-9,
                                   mapping.maxGap, survey.gaps, kSurveyGap));
}

void addClock(const std::string& topic, double offset, Findings& findings)
{
    if (std::abs(offset) <= kMaxClockOffset) return;
    findings.push_back(fmt::format("topic {}: header.stamp lies {:.3f} s {} the recorder's time: "
                                   "the clocks differ; use [time] source = \"recorder\"",
                                   printable(topic), std::abs(offset),
                                   offset > 0.0 ? "before" : "after"));
}

void addClocks(const std::vector<TopicSurvey>& surveys, Findings& findings)
{
    const TopicSurvey* other = nullptr;
    for (const TopicSurvey& survey : surveys) {
        if (!survey.stampOffset) continue;
        const double offset = *survey.stampOffset;
        addClock(survey.topic.name, offset, findings);
        if (other && std::abs(offset - *other->stampOffset) > kMaxOffsetBetween)
            findings.push_back(fmt::format("topics {} and {}: their clocks, or the ways to the "
                                           "recorder, differ by {:.3f} s; give "
                                           "one of them a delay_s, or use the recorder's time",
                                           printable(other->topic.name),
                                           printable(survey.topic.name),
                                           std::abs(offset - *other->stampOffset)));
        if (!other) other = &survey;
    }
}

/// Largest angle that a robot can have; empty for a quantity that is no such angle.
std::optional<double> mostAngle(Quantity quantity)
{
    constexpr double kTurn = 2.0 * std::numbers::pi;
    switch (quantity) {
    case Quantity::Pitch: return 0.25 * kTurn;
    case Quantity::Roll: return 0.5 * kTurn;
    case Quantity::FrontLeft:
    case Quantity::FrontRight:
    case Quantity::RearLeft:
    case Quantity::RearRight:
    case Quantity::Differential: return kTurn;
    default: return std::nullopt;
    }
}

bool isInDegrees(const FieldSource& source)
{
    return std::abs(source.factor) > 0.0 && std::abs(source.factor) < 0.05;
}

/// Returns how many measured values are larger than `most`, in size.
std::size_t countBeyond(const Series& series, double most)
{
    return static_cast<std::size_t>(std::ranges::count_if(series, [most](const SeriesSample& s) {
        return s.isMeasured && std::abs(s.value) > most;
    }));
}

/// Names angles that a robot cannot have: all in another unit, or a few that are no measurements.
std::string angleDoubt(Quantity quantity, const Series& series, std::size_t count, double largest,
                       double most)
{
    constexpr std::size_t kFew = 100;  // one of so many is a spike
    const std::size_t beyond = countBeyond(series, most);
    if (beyond * kFew <= count)
        return fmt::format("[{}]: {} of {} values lie beyond {:.3f} rad, up to {}: the sensor or "
                           "its line has spikes; leave these messages out",
                           name(quantity), beyond, count, most, numberText(largest));
    return fmt::format("[{}]: reaches {:.3f} rad, more than {:.3f}: degrees may be taken for "
                       "radians; add unit = \"deg\", or correct the field",
                       name(quantity), largest, most);
}

void addUnits(Quantity quantity, const Mapping& mapping, const Series& series, Findings& findings)
{
    constexpr double kRounding = 1e-6, kRadians = 3.2;
    const auto most = mostAngle(quantity);
    const SeriesRange range = rangeOf(series);
    if (!most || range.count == 0) return;
    const double largest = std::max(std::abs(range.least), std::abs(range.most));
    if (largest > *most + kRounding)
        findings.push_back(angleDoubt(quantity, series, range.count, largest, *most + kRounding));
    const auto& source = mapping.of(quantity);
    if (source && isInDegrees(*source) && largest > 0.0
        && largest / std::abs(source->factor) <= kRadians && range.count >= kMinStuck)
        findings.push_back(fmt::format(
            "[{}]: stays within {:.2f} degrees: radians may be taken for degrees; see unit",
            name(quantity), largest / std::abs(source->factor)));
}

void addSaturation(const std::string& what, const SeriesRange& range, Findings& findings)
{
    const auto share = static_cast<double>(range.atMost)
                     / static_cast<double>(std::max<std::size_t>(range.count, 1));
    if (range.atMost < kMinSaturated || share < kSaturatedShare || range.least == range.most)
        return;
    findings.push_back(
        fmt::format("{}: {} of {} values equal the largest, {}: the sensor saturates", what,
                    range.atMost, range.count, numberText(range.most)));
}

bool isCurrent(Quantity quantity)
{
    return quantity >= Quantity::FrontLeftCurrent && quantity <= Quantity::RearRightCurrent;
}

class SeriesCheck {
public:
    SeriesCheck(const RecordedSeries& series, const Mapping& mapping, Findings& findings)
        : series_(series), mapping_(mapping), findings_(findings)
    {
    }

    void run()
    {
        for (std::size_t q = 0; q < static_cast<std::size_t>(Quantity::Activity); ++q)
            check(static_cast<Quantity>(q));
        for (std::size_t side = 0; side < kForceTables.size(); ++side)
            for (std::size_t e = 0; e < kForceElements; ++e) checkForce(side, e);
        if (!moved_) return;  // nothing moved, so that nothing can be stuck
        for (std::string& text : stuck_) findings_.push_back(std::move(text));
    }

private:
    void check(Quantity quantity)
    {
        const Series& series = series_.series(quantity);
        const SeriesRange range = rangeOf(series);
        addUnits(quantity, mapping_, series, findings_);
        const std::string what = fmt::format("[{}]", name(quantity));
        if (isCurrent(quantity)) addSaturation(what, range, findings_);
        // A robot may drive straight on, or not at all.
        if (quantity < Quantity::Travelled) noteStuck(what, series, range);
    }

    void checkForce(std::size_t side, std::size_t element)
    {
        const Series& series = series_.forces[side][element];
        const SeriesRange range = rangeOf(series);
        const std::string what = fmt::format("[{}] element {}", kForceTables[side], element + 1);
        addSaturation(what, range, findings_);
        // An element that nothing touches reads 0 all the time.
        if (range.most > 0.0) noteStuck(what, series, range);
    }

    void noteStuck(const std::string& what, const Series& series, const SeriesRange& range)
    {
        if (range.count == 0) return;
        moved_ = moved_ || range.least != range.most;
        if (range.count < kMinStuck || range.least != range.most) return;
        stuck_.push_back(fmt::format("{}: is {} in all {} values of {:.1f} s, while other sensors "
                                     "change: it is stuck, or no "
                                     "sensor",
                                     what, numberText(range.most), range.count,
                                     secondsOfSeries(series)));
    }

    const RecordedSeries& series_;
    const Mapping& mapping_;
    Findings& findings_;
    Findings stuck_;
    bool moved_ = false;
};

/// Adds the first step of the way that no robot makes.
void addJumps(const RecordedSeries& series, Findings& findings)
{
    constexpr double kMaxSpeed = 5.0, kNoise = 0.3;  // [m/s], [m]
    const SeriesSample* last = nullptr;
    for (const SeriesSample& sample : series.of.at(static_cast<std::size_t>(Quantity::Travelled))) {
        if (!sample.isMeasured) continue;
        const double way = last ? std::abs(sample.value - last->value) : 0.0;
        const double seconds = last ? static_cast<double>(sample.time - last->time) * 1e-9 : 0.0;
        if (way > kNoise && way > kMaxSpeed * seconds) {
            findings.push_back(
                fmt::format("the way jumps {:.2f} m in {:.3f} s, faster than {} m/s: "
                            "the poses jump, or millimetres are taken for metres; "
                            "see scale",
                            way, seconds, kMaxSpeed));
            return;
        }
        last = &sample;
    }
}

/// Adds the longest pause of the pitch, if the clock may have been set forward in it.
void addPause(const RecordedSeries& series, Findings& findings)
{
    constexpr double kLongPause = 600.0;  // [s]
    const Series& pitch = series.of.at(static_cast<std::size_t>(Quantity::Pitch));
    std::int64_t longest = 0, at = 0;
    for (std::size_t i = 1; i < pitch.size(); ++i)
        if (pitch[i].time - pitch[i - 1].time > longest) {
            longest = pitch[i].time - pitch[i - 1].time;
            at = pitch[i - 1].time - pitch.front().time;
        }
    if (static_cast<double>(longest) * 1e-9 > kLongPause)
        findings.push_back(fmt::format("has no pitch for {:.3f} s at {:.3f} s: the recording "
                                       "paused, or its clock was set forward",
                                       static_cast<double>(longest) * 1e-9,
                                       static_cast<double>(at) * 1e-9));
}

std::set<std::string> mappedTopics(const Mapping& mapping)
{
    std::set<std::string> topics;
    for (const auto& source : mapping.fields)
        if (source) topics.insert(source->topic);
    for (const auto& source : mapping.forces)
        if (source) topics.insert(source->topic);
    if (mapping.attitude) topics.insert(mapping.attitude->source.topic);
    if (mapping.odometry) topics.insert(mapping.odometry->source.topic);
    if (mapping.frames) topics = {mapping.frames->topic};
    return topics;
}

}  // namespace

Result<std::vector<std::string>> checkRecording(const std::string& path, const Mapping& mapping,
                                                const RobotModel& robot,
                                                const RecordingWatch& watch)
{
    auto recording = openRecording(path, mapping.csv);
    if (!recording) return recording.error();
    (*recording)->follow(watch);
    (*recording)->select(mappedTopics(mapping));
    const auto surveys = surveyRecording(**recording);
    if (!surveys) return surveys.error();
    Findings findings = (*recording)->consumeRemarks();
    for (const TopicSurvey& survey : *surveys)
        if (survey.messages > 0) addGaps(survey, mapping, findings);
    addClocks(*surveys, findings);
    if (mapping.frames) return findings;
    auto again = openRecording(path, mapping.csv);
    if (!again) return again.error();
    (*again)->follow(watch);
    auto series = readSeries(**again, mapping, robot);
    if (!series) return series.error();
    for (std::string& remark : series->remarks) findings.push_back(std::move(remark));
    SeriesCheck(*series, mapping, findings).run();
    addJumps(*series, findings);
    return findings;
}

std::vector<std::string> importWarnings(const RecordedSeries& series, const Mapping& mapping)
{
    Findings findings;
    for (std::size_t q = 0; q < static_cast<std::size_t>(Quantity::Activity); ++q)
        addUnits(static_cast<Quantity>(q), mapping, series.of.at(q), findings);
    addJumps(series, findings);
    addPause(series, findings);
    if (mapping.byHeader)
        for (const auto& [topic, offset] : series.stampOffsets) addClock(topic, offset, findings);
    return findings;
}

}  // namespace terratact
