#include "app/recording/recording_import.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <utility>

#include "app/recording/unfinished_session.h"
#include "core/base/text.h"
#include "core/log/event_text.h"
#include "core/log/session_writer.h"
#include "core/mapping/recorded_frames.h"
#include "core/mapping/recorded_series.h"
#include "core/mapping/recording_check.h"
#include "core/mapping/telemetry_lines.h"
#include "core/store/file_read.h"
#include "core/store/sha256.h"
#include "core/wire/telemetry.h"
#include "core/wire/telemetry_listener.h"

namespace terratact {
namespace {

constexpr std::size_t kMaxRobotFile = std::size_t{64} * 1024;
constexpr std::int64_t kFramesOfBatch = 250;
constexpr const char* kImportBus = "import";

class RecordingImporter {
public:
    RecordingImporter(const RecordingImport& options, Mapping mapping, RobotModel robot,
                      std::string robotText)
        : options_(options), mapping_(std::move(mapping)), robot_(std::move(robot)),
          robotText_(std::move(robotText)), listener_(robot_)
    {
    }

    Result<ImportedSession> run()
    {
        auto recording = openRecording(options_.file, mapping_.csv);
        if (!recording) return recording.error();
        (*recording)->follow(options_.watch);
        report_.format = (*recording)->format();
        Status done = mapping_.frames ? importFrames(**recording) : importLines(**recording);
        for (std::string& text : (*recording)->consumeRemarks())
            report_.remarks.push_back(std::move(text));
        if (!done) return done.error();
        if (Status ended = add(event(EventKind::Session, "ended")); !ended) return ended.error();
        if (Status sealed = writer_->seal(); !sealed) return sealed.error();
        report_.frames = writer_->frames();
        report_.chain = writer_->chain();
        report_.seconds = secondsOf(last_);
        return std::move(report_);
    }

    bool began() const { return writer_.has_value(); }

private:
    /// Frames, and a mapping with the activity, hold what the robot itself says.
    PressRule pressRule() const
    {
        PressRule rule = mapping_.scenes;
        rule.byActivity = mapping_.frames || mapping_.of(Quantity::Activity);
        return rule;
    }

    template <class Row>
    Status add(const Row& row)
    {
        return writer_->add(row);
    }

    EventRow event(EventKind kind, std::string subject, Message text = {})
    {
        return withText(
            {.id = ++events_, .time = last_, .kind = kind, .subject = std::move(subject)},
            std::move(text));
    }

    /// Begins the session at the wall time of its first row [ns].
    Status begin(std::int64_t time)
    {
        constexpr std::int64_t kLatest = 9'000'000'000'000'000'000;
        if (time < 0 || time > kLatest)
            return fileError(
                options_.file,
                fmt::format("begins at {:.3f} s since 1970, which no session can have; "
                            "correct the times, or the unit of the time column",
                            static_cast<double>(time) * 1e-9));
        begin_ = time;
        inProgress_.emplace(options_.out);
        auto writer = SessionWriter::create(
            options_.out, {.wallTime = time,
                           .program = "terratact import",
                           .source = std::filesystem::path(options_.file).filename().string(),
                           .bus = kImportBus,
                           .transmits = false,
                           .robot = robotText_,
                           .robotHash = sha256Hex(robotText_)});
        if (!writer) return writer.error();
        writer_ = std::move(*writer);
        return add(
            event(EventKind::Session, "begun",
                  Message(TR_NOOP("core", "from a recording by the mapping %1"), mapping_.name)));
    }

    Status addFrame(const CanFrame& frame, bool sent)
    {
        if (Status added = add(FrameRow{.time = last_, .frame = frame, .sent = sent}); !added)
            return added;
        return ++frames_ % kFramesOfBatch == 0 ? writer_->commit() : Status(Done{});
    }

    Status addScene(const Measurement& measurement)
    {
        return add(SceneRow{.id = ++report_.scenes, .time = last_, .measurement = measurement});
    }

    // Lines of telemetry.

    Status importLines(Recording& recording)
    {
        auto series = readSeries(recording, mapping_, robot_);
        if (!series) return series.error();
        report_.remarks = series->remarks;
        for (std::string& doubt : importWarnings(*series, mapping_))
            report_.remarks.push_back(std::move(doubt));
        const std::vector<TelemetryLine> lines = telemetryLines(*series, mapping_);
        countLeftOut(series->series(Quantity::Pitch), lines.size());
        remarkOnWay(*series);
        if (lines.empty())
            return fileError(
                options_.file,
                fmt::format("has no time at which pitch and all four flipper angles are "
                            "known; their messages are more than {} s apart: raise "
                            "max_gap_s under [time] of the mapping",
                            mapping_.maxGap));
        if (Status begun = begin(lines.front().time); !begun) return begun;
        if (!mapping_.of(Quantity::Activity))
            if (Status added = add(event(
                    EventKind::Marker, "",
                    TR_NOOP("core", "the recording does not say what the robot did: pressing, "
                                    "driving and halting follow from its movement and currents")));
                !added)
                return added;
        const std::vector<std::size_t> presses = standingPresses(lines, pressRule());
        auto press = presses.begin();
        auto step = series->clockSteps.begin();
        for (std::size_t i = 0; i < lines.size(); ++i) {
            for (; step != series->clockSteps.end() && step->time <= lines[i].time; ++step)
                if (Status added = addClockStep(*step, lines[i].time - begin_); !added)
                    return added;
            const bool isScene = press != presses.end() && *press == i;
            press += isScene ? 1 : 0;
            if (options_.watch) options_.watch(i, false);
            if (Status written = writeLine(lines[i], isScene); !written) return written;
        }
        report_.lines = lines.size();
        return Done{};
    }

    /// Adds remarks about values of the pitch that became no line.
    void countLeftOut(const Series& pitch, std::size_t lines)
    {
        if (mapping_.rate > 0.0) return;
        std::size_t measured = 0, repeated = 0;
        std::optional<std::int64_t> before;
        for (const SeriesSample& sample : pitch) {
            if (!sample.isMeasured) continue;
            ++measured;
            repeated += before == sample.time ? 1 : 0;
            before = sample.time;
        }
        if (repeated > 0)
            report_.remarks.push_back(
                fmt::format("{} of {} values of the pitch have the time of another one and are "
                            "left out: are the times rounded, or is their unit another one?",
                            repeated, measured));
        if (const std::size_t unknown = measured - repeated - lines; unknown > 0)
            report_.remarks.push_back(
                fmt::format("{} of {} values of the pitch are left out, because a flipper angle is "
                            "not known within {} s (max_gap_s)",
                            unknown, measured, mapping_.maxGap));
    }

    /// Adds a remark about a way without a heading: a frame holds both.
    void remarkOnWay(const RecordedSeries& series)
    {
        if (series.series(Quantity::Travelled).empty() || !series.series(Quantity::Turned).empty())
            return;
        report_.remarks.emplace_back("the way is left out, because the recording's heading is not "
                                     "mapped: add [turned] to the mapping, or [odometry]");
    }

    Status addClockStep(const ClockStep& step, SessionTime time)
    {
        last_ = time;
        return add(event(
            EventKind::Gap, "clock",
            {step.back < 0.0
                 ? TR_NOOP("core", "the recording's clock was set forward by %1 s; the session "
                                   "continues evenly")
                 : TR_NOOP("core", "the recording's clock was set back by %1 s; the session "
                                   "continues evenly"),
             fixed(std::abs(step.back), 3)}));
    }

    /// Writes the frames that a robot sends for a line, and the scene as a console would capture it.
    Status writeLine(const TelemetryLine& line, bool isScene)
    {
        last_ = line.time - begin_;
        const RobotStatus status{.activity = line.measurement.activity,
                                 .refusal = line.measurement.refusal};
        std::vector<CanFrame> frames =
            framesOf(sensorLineOf(line.measurement, robot_), counter_, lineExtent(robot_));
        frames.insert(frames.begin(), frameOf(status, counter_));
        ++counter_;
        std::optional<Measurement> received;
        for (const CanFrame& frame : frames) {
            if (Status added = addFrame(frame, false); !added) return added;
            if (auto measured = listener_.receive(frame, secondsOf(last_))) received = measured;
        }
        return isScene && received ? addScene(*received) : Status(Done{});
    }

    // Frames of a bus.

    Status importFrames(Recording& recording)
    {
        const auto presses = pressesOfFrames(recording);
        if (!presses) return presses.error();
        auto again = openRecording(options_.file, mapping_.csv);
        if (!again) return again.error();
        (*again)->follow(options_.watch);
        RecordedFrames frames(**again, *mapping_.frames);
        auto press = presses->begin();
        for (std::size_t steps = 0;;) {
            const auto next = frames.next();
            if (!next) return next.error();
            if (!*next) break;
            const RecordedFrame& frame = **next;
            if (!writer_)
                if (Status begun = begin(frame.time); !begun) return begun;
            last_ = std::max(last_, frame.time - begin_);
            for (; steps < frames.clockSteps().size(); ++steps)
                if (Status added = addClockStep(frames.clockSteps()[steps], last_); !added)
                    return added;
            if (Status added = addFrame(frame.frame, frame.sent); !added) return added;
            if (frame.sent) continue;
            const auto measured = listener_.receive(frame.frame, secondsOf(last_));
            if (!measured) continue;
            const bool isScene = press != presses->end() && *press == report_.lines;
            press += isScene ? 1 : 0;
            ++report_.lines;
            if (isScene)
                if (Status added = addScene(*measured); !added) return added;
        }
        if (!writer_) return fileError(options_.file, frames.emptiness());
        for (std::string& remark : clockRemarks(frames.clockSteps()))
            report_.remarks.push_back(std::move(remark));
        if (frames.falls() > 0)
            report_.remarks.push_back(fmt::format(
                "topic {}: {} frames come before the frame ahead of them; they have its time",
                printable(mapping_.frames->topic), frames.falls()));
        return Done{};
    }

    /// Reads all frames once. Returns the lines of telemetry that become scenes.
    Result<std::vector<std::size_t>> pressesOfFrames(Recording& recording) const
    {
        RecordedFrames frames(recording, *mapping_.frames);
        TelemetryListener listener(robot_);
        std::vector<TelemetryLine> lines;
        std::int64_t first = 0, last = 0;
        for (bool isFirst = true;; isFirst = false) {
            const auto next = frames.next();
            if (!next) return next.error();
            if (!*next) break;
            if (isFirst) first = (*next)->time;
            last = std::max(last, (*next)->time - first);
            if ((*next)->sent) continue;
            if (auto measured = listener.receive((*next)->frame, secondsOf(last)))
                lines.push_back({last, *measured});
            if (lines.size() > kMaxSamples / 10)
                return fileError(options_.file,
                                 fmt::format("has more than {} lines of telemetry; cut it into "
                                             "shorter files",
                                             kMaxSamples / 10));
        }
        return standingPresses(lines, pressRule());
    }

    const RecordingImport& options_;
    Mapping mapping_;
    RobotModel robot_;
    std::string robotText_;
    TelemetryListener listener_;
    ImportedSession report_;
    std::optional<SessionWriter> writer_;
    std::optional<SessionInProgress> inProgress_;
    std::int64_t begin_ = 0, frames_ = 0, events_ = 0;
    SessionTime last_ = 0;
    std::uint8_t counter_ = 0;
};

}  // namespace

Result<ImportedSession> importRecording(const RecordingImport& options)
{
    auto robotText = readFile(options.robot, kMaxRobotFile);
    if (!robotText) return robotText.error();
    auto robot = robotModelFrom(options.robot, *robotText);
    if (!robot) return robot.error();
    auto mapping = options.mappingText.empty() ? readMapping(options.mapping)
                                               : mappingFrom(options.mapping, options.mappingText);
    if (!mapping) return mapping.error();
    RecordingImporter importer(options, std::move(*mapping), std::move(*robot),
                               std::move(*robotText));
    try {
        auto done = importer.run();
        if (!done && importer.began()) removeUnfinishedSession(options.out);
        return done;
    } catch (...) {
        if (importer.began()) removeUnfinishedSession(options.out);
        throw;
    }
}

}  // namespace terratact
