#include "core/mapping/recorded_series.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <system_error>
#include <utility>

#include "core/bags/csv_recording.h"
#include "core/base/text.h"
#include "core/mapping/enumerators.h"
#include "core/mapping/pose_samples.h"
#include "core/mapping/recorded_transforms.h"
#include "core/mapping/rotation.h"
#include "core/mapping/topic_decoding.h"
#include "core/mapping/transform_tree.h"
#include "core/mapping/way_series.h"
#include "core/store/file_read.h"

namespace terratact {
namespace {

/// One field that is read into one series.
struct FieldReader {
    const FieldSource* source = nullptr;
    std::string field;
    Series* into = nullptr;
    std::optional<Quantity> word{};  ///< the field may be a text
    std::uint64_t found = 0, notFinite = 0, texts = 0;
};

class SeriesReader {
public:
    SeriesReader(Recording& recording, const Mapping& mapping, const RobotModel& robot)
        : recording_(recording), mapping_(mapping), robot_(robot), transforms_(mapping.maxGap)
    {
        std::error_code none;
        const std::uintmax_t bytes = std::filesystem::file_size(recording.path(), none);
        most_ = mostSamples(none ? 0 : bytes);
        for (std::size_t q = 0; q < kQuantities; ++q)
            if (mapping.fields[q]) addField(q);
        for (std::size_t side = 0; side < mapping.forces.size(); ++side)
            for (std::size_t e = 0; mapping.forces[side] && e < kForceElements; ++e)
                fields_.push_back({.source = &*mapping.forces[side],
                                   .field = mapping.elements[side][e],
                                   .into = &series_.forces[side][e]});
        for (const FieldReader& reader : fields_) topics_.insert(reader.source->topic);
        if (mapping.attitude) topics_.insert(mapping.attitude->source.topic);
        if (mapping.odometry) topics_.insert(mapping.odometry->source.topic);
        if (mapping.attitude && !mapping.attitude->baseFrame.empty())
            wantTransforms({mapping.attitude->baseFrame});
        if (mapping.odometry && mapping.odometry->isTransform())
            wantTransforms({mapping.odometry->frame, mapping.odometry->baseFrame});
    }

    Result<RecordedSeries> read()
    {
        recording_.select(topics_);
        for (RecordedMessage message;;) {
            const Result<bool> more = recording_.read(message);
            if (!more) return more.error();
            if (!*more) break;
            if (Status added = add(message); !added) return added.error();
        }
        if (Status checked = decoding_.check(recording_.path(), series_.remarks); !checked)
            return checked.error();
        if (Status checked = checkTopics(); !checked) return checked.error();
        if (Status finished = finish(); !finished) return finished.error();
        return std::move(series_);
    }

private:
    void wantTransforms(const std::vector<std::string>& frames)
    {
        topics_.insert({kFixedTransforms, kTransforms});
        for (const std::string& frame : frames) transforms_.want(frame);
    }

    void addField(std::size_t quantity)
    {
        FieldReader reader{.source = &*mapping_.fields[quantity],
                           .field = mapping_.fields[quantity]->field,
                           .into = &series_.of[quantity]};
        const auto q = static_cast<Quantity>(quantity);
        if (q == Quantity::Activity || q == Quantity::Refusal) reader.word = q;
        fields_.push_back(std::move(reader));
    }

    /// Damage of the file is the likelier cause where nothing of the topic was read.
    Error fault(const FieldSource& source, std::string_view cause) const
    {
        const std::string& damage = recording_.damage();
        const bool isDamaged = !damage.empty();
        const std::string found = fmt::format("topic {}: {}", printable(source.topic), cause);
        if (recording_.topics().empty())
            return fileError(recording_.path(),
                             (isDamaged ? damage + ": no topic lies before that"
                                        : "holds no topic and no message: it is cut, or nothing "
                                          "was recorded")
                                 + "; copy or record it again");
        if (isDamaged && decoding_.messages(source.topic) == 0)
            return fileError(recording_.path(), fmt::format("{}; {}", damage, found));
        return fileError(recording_.path(),
                         fmt::format("{}; correct [{}] of the mapping{}{}", found, source.table,
                                     isDamaged ? "; the file is damaged, too: " : "", damage));
    }

    Status add(const RecordedMessage& message)
    {
        const std::string& topic = recording_.topics()[message.topic].name;
        const auto value = recording_.decode(message);
        if (!value) {
            decoding_.broken(topic, value.error());
            return Done{};
        }
        decoding_.decoded(topic);
        std::int64_t time = message.time;
        const auto stamp = stampOf(*value);
        if (stamp)
            series_.stampOffsets.try_emplace(topic, static_cast<double>(time - *stamp) * 1e-9);
        if (mapping_.byHeader && !stamp) unstamped_.insert(topic);
        if (mapping_.byHeader && stamp) time = *stamp;
        if (recording_.topics()[message.topic].encoding == kCsvEncoding)
            clock_.addRow(time, [this](auto visit) { eachList(visit); });
        for (FieldReader& reader : fields_)
            if (reader.source->topic == topic) addValue(reader, *value, time);
        recorded_ = message.time;
        addPoses(topic, *value, time);
        if (samples_ > most_)
            return fileError(
                recording_.path(),
                fmt::format("has more than {} mapped values; cut it into shorter files", most_));
        return Done{};
    }

    void addValue(FieldReader& reader, const FieldValue& message, std::int64_t time)
    {
        const FieldSource& source = *reader.source;
        auto number = numberAt(message, reader.field);
        if (!number && reader.word)
            if (const auto text = textAt(message, reader.field))
                number = enumeratorOf(*reader.word, *text);
        if (!number) {
            reader.texts += textAt(message, reader.field) ? 1 : 0;
            return;
        }
        ++reader.found;
        const bool isMeasured = source.unless.empty() || !hasField(message, source.unless);
        double value = source.factor * *number;
        if (source.isTorque) value /= robot_.torquePerAmpere;
        value += source.offset;
        if (!std::isfinite(value)) ++reader.notFinite;
        store(*reader.into, earlier(time, source.delay), value, isMeasured && std::isfinite(value));
    }

    void store(Series& into, std::int64_t time, double value, bool isMeasured)
    {
        ++samples_;
        into.push_back({time, isMeasured ? value : 0.0, isMeasured});
    }

    static std::int64_t earlier(std::int64_t time, double delay)
    {
        return time - static_cast<std::int64_t>(std::llround(delay * 1e9));
    }

    void addPoses(const std::string& topic, const FieldValue& message, std::int64_t time)
    {
        transforms_.add(topic, message, recorded_);
        if (mapping_.attitude && topic == mapping_.attitude->source.topic) {
            if (attitude_.empty() && attitudeFrame_.empty()) {
                attitudeFrame_ = textAt(message, "header.frame_id").value_or("");
                transforms_.want(attitudeFrame_);
            }
            addPose(attitude_, mapping_.attitude->source, mapping_.attitude->source.field, message,
                    time);
        }
        if (mapping_.odometry && !mapping_.odometry->isTransform()
            && topic == mapping_.odometry->source.topic)
            addPose(odometry_, mapping_.odometry->source, mapping_.odometry->orientation, message,
                    time);
    }

    void addPose(std::vector<PoseSample>& into, const FieldSource& source, const std::string& path,
                 const FieldValue& message, std::int64_t time)
    {
        const auto rotation = quaternionAt(message, path);
        if (!rotation) return;
        ++samples_;
        PoseSample pose{.time = earlier(time, source.delay),
                        .stamp = earlier(stampOf(message).value_or(time), source.delay),
                        .position = {},
                        .rotation = *rotation};
        if (&into == &odometry_) {
            const auto position = positionAt(message, source.field);
            if (!position) return;
            pose.position = *position;
        }
        into.push_back(pose);
    }

    std::string topicList() const
    {
        constexpr std::size_t kMaxListed = 15;
        std::string list;
        const auto& topics = recording_.topics();
        for (std::size_t i = 0; i < std::min(kMaxListed, topics.size()); ++i)
            list += fmt::format("{}{}", i > 0 ? ", " : "", printable(topics[i].name));
        return topics.size() > kMaxListed ? list + ", …" : list;
    }

    bool hasTopic(const std::string& name) const
    {
        return std::ranges::any_of(recording_.topics(),
                                   [&](const RecordedTopic& topic) { return topic.name == name; });
    }

    std::string missing(const FieldSource& source, const std::string& field) const
    {
        const std::uint64_t messages = decoding_.messages(source.topic);
        if (!hasTopic(source.topic))
            return fmt::format("the file has no such topic; its topics are {}", topicList());
        if (messages == 0) return "the topic has no message";
        return fmt::format(
            "none of its {} messages has the field {}; `terratact import --probe` lists "
            "the fields",
            messages, shown(field));
    }

    Status checkTopics()
    {
        std::set<const FieldSource*> reported;  // six elements have one source
        for (const FieldReader& reader : fields_) {
            if (reader.notFinite > 0)
                remark(reader,
                       fmt::format(
                           "{} values of {} are null or not finite; they count as not measured",
                           reader.notFinite, shown(reader.field)));
            if (reader.texts > 0 && reader.found > 0)
                remark(reader, fmt::format("{} values of {} are texts, expected numbers; they are "
                                           "left out",
                                           reader.texts, shown(reader.field)));
            if (reader.found > 0 && reader.found == reader.notFinite && isNeeded(reader))
                return fault(*reader.source,
                             fmt::format("all {} values of {} are null or not finite", reader.found,
                                         shown(reader.field)));
            if (reader.found > 0) continue;
            const std::string cause =
                reader.texts > 0 ? fmt::format("all {} values of {} are texts, expected numbers",
                                               reader.texts, shown(reader.field))
                                 : missing(*reader.source, reader.field);
            if (isNeeded(reader)) return fault(*reader.source, cause);
            if (!reader.source->isOptional && reported.insert(reader.source).second)
                remark(reader, cause + "; it counts as not measured");
        }
        if (mapping_.attitude && attitude_.empty())
            return fault(mapping_.attitude->source,
                         missing(mapping_.attitude->source, mapping_.attitude->source.field));
        if (mapping_.odometry && mapping_.odometry->isTransform()) findOdometry();
        if (mapping_.odometry && !mapping_.odometry->isTransform() && odometry_.empty()
            && !mapping_.odometry->source.isOptional)
            remark(mapping_.odometry->source,
                   missing(mapping_.odometry->source, mapping_.odometry->source.field)
                       + "; the way counts as not measured");
        for (const std::string& topic : unstamped_)
            series_.remarks.push_back(
                fmt::format("topic {}: messages without header.stamp have the recorder's time",
                            printable(topic)));
        return Done{};
    }

    bool isNeeded(const FieldReader& reader) const
    {
        for (const Quantity q : {Quantity::Pitch, Quantity::FrontLeft, Quantity::FrontRight,
                                 Quantity::RearLeft, Quantity::RearRight})
            if (reader.into == &series_.of[static_cast<std::size_t>(q)]) return true;
        return false;
    }

    void remark(const FieldReader& reader, const std::string& cause)
    {
        remark(*reader.source, cause);
    }
    void remark(const FieldSource& source, const std::string& cause)
    {
        series_.remarks.push_back(
            fmt::format("topic {}, [{}]: {}", printable(source.topic), source.table, cause));
    }

    Status finish()
    {
        makeEven();
        if (Status status = addAttitude(); !status) return status;
        std::ranges::stable_sort(odometry_, {}, &PoseSample::time);
        addWay(odometry_, series_);
        series_.each([](Series& s) { std::ranges::stable_sort(s, {}, &SeriesSample::time); });
        integrateSpeed(series_, mapping_.maxGap);
        return checkOverlap();
    }

    /// Calls visit(samples) with each list of samples, which are in the file's order.
    template <class Visit>
    void eachList(Visit visit)
    {
        visit(attitude_);
        series_.each(visit);
        visit(odometry_);
    }

    /// Lets times continue where the clock was set.
    void makeEven()
    {
        eachList([this](auto& samples) { clock_.make(samples); });
        series_.clockSteps = clock_.steps();
        for (std::string& remark : clockRemarks(clock_.steps()))
            series_.remarks.push_back(std::move(remark));
        if (clock_.isDisordered())
            series_.remarks.emplace_back("the messages are not in the order of their times; they "
                                         "were sorted");
    }

    /// Takes the poses of the base from transforms.
    void findOdometry()
    {
        const OdometrySource& source = *mapping_.odometry;
        const auto sent = sentPoses(transforms_, source, mapping_.byHeader);
        if (!sent) {
            if (!source.source.isOptional)
                remark(source.source, sent.error().text + "; the way counts as not measured");
            return;
        }
        if (sent->without > 0)
            remark(source.source,
                   fmt::format("{} of {} poses are left out: another transform of the chain has "
                               "none around their time",
                               sent->without, sent->without + sent->poses.size()));
        odometry_ = samplesOf(*sent);
        for (PoseSample& pose : odometry_) pose.time = earlier(pose.time, source.source.delay);
        samples_ += odometry_.size();
    }

    /// Returns the rotation from the base to the sensor at a time; empty if transforms do not know it.
    std::optional<Rotation> toSensorAt(std::int64_t stamp) const
    {
        const AttitudeSource& source = *mapping_.attitude;
        if (source.baseFrame.empty())
            return transposed(rotationOfAngles(source.mount[0], source.mount[1], source.mount[2]));
        const auto mount = transforms_.at(source.baseFrame, attitudeFrame_, stamp);
        if (!mount) return std::nullopt;
        const Eigen::Quaterniond& q = mount->turn;
        return transposed(rotationOf(q.x(), q.y(), q.z(), q.w()));
    }

    Status addAttitude()
    {
        if (!mapping_.attitude) return Done{};
        const AttitudeSource& source = *mapping_.attitude;
        const std::string frames =
            fmt::format("from {} to {}", shown(source.baseFrame), shown(attitudeFrame_));
        if (!source.baseFrame.empty() && !transforms_.joins(source.baseFrame, attitudeFrame_))
            return fault(
                source.source,
                fmt::format("/tf_static and /tf hold no transforms {}; there are: {}; give "
                            "mount_rpy_deg instead of base_frame",
                            frames, transforms_.links()));
        std::uint64_t zeros = 0, unmounted = 0;
        for (const PoseSample& pose : attitude_) {
            const auto toSensor = toSensorAt(pose.stamp);
            const bool isMeasured = pose.isMeasured() && toSensor;
            zeros += pose.isMeasured() ? 0 : 1;
            unmounted += toSensor ? 0 : 1;
            const BaseAngles angles =
                isMeasured ? baseAngles(product(pose.rotation, *toSensor)) : BaseAngles{};
            store(series_.series(Quantity::Pitch), pose.time, angles.pitch, isMeasured);
            store(series_.series(Quantity::Roll), pose.time, angles.roll, isMeasured);
        }
        if (zeros == attitude_.size())
            return fault(source.source,
                         "all quaternions are 0 or not finite: the sensor gives no orientation");
        if (unmounted == attitude_.size())
            return fault(source.source,
                         fmt::format("no transforms {} are near the times of its messages; look at "
                                     "the clocks, or give mount_rpy_deg instead of base_frame",
                                     frames));
        if (zeros > 0)
            remark(source.source, fmt::format("{} quaternions have no direction; they count as not "
                                              "measured",
                                              zeros));
        if (unmounted > 0)
            remark(source.source,
                   fmt::format("{} messages have no transforms {} around their time; they count as "
                               "not measured",
                               unmounted, frames));
        return Done{};
    }

    /// Refuses topics whose clocks differ so much that their times do not overlap with those of pitch.
    Status checkOverlap()
    {
        const Series& pitch = series_.series(Quantity::Pitch);
        for (const FieldReader& reader : fields_) {
            if (reader.into->empty() || !isNeeded(reader)) continue;
            const std::int64_t later = reader.into->front().time - pitch.back().time;
            const std::int64_t sooner = pitch.front().time - reader.into->back().time;
            if (later <= 0 && sooner <= 0) continue;
            const double seconds = static_cast<double>(std::max(later, sooner)) * 1e-9;
            return fault(*reader.source,
                         fmt::format("its times {} those of the pitch by {:.1f} s: the clocks "
                                     "differ; use [time] source = \"recorder\", or delay_s",
                                     later > 0 ? "begin after" : "end before", seconds));
        }
        return Done{};
    }

    Recording& recording_;
    const Mapping& mapping_;
    const RobotModel& robot_;
    RecordedSeries series_;
    std::vector<FieldReader> fields_;
    std::set<std::string> topics_, unstamped_;
    TopicDecoding decoding_;
    EvenClock clock_;
    std::vector<PoseSample> attitude_, odometry_;
    std::string attitudeFrame_;
    std::int64_t recorded_ = 0;  ///< [ns] time of the message that is read
    TransformTree transforms_;
    std::uintmax_t samples_ = 0, most_ = 0;
};

}  // namespace

std::uintmax_t mostSamples(std::uintmax_t recordingBytes)
{
    constexpr std::uintmax_t kMax = kMaxSamples;
    return std::clamp(4 * std::min(recordingBytes, kMax), std::uintmax_t{1'000'000}, kMax);
}

Result<RecordedSeries> readSeries(Recording& recording, const Mapping& mapping,
                                  const RobotModel& robot)
{
    return SeriesReader(recording, mapping, robot).read();
}

}  // namespace terratact
