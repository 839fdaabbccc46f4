#include "core/mapping/recording_survey.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace terratact {
namespace {

constexpr std::size_t kMaxOffsets = 10'000;  ///< stamps whose median is taken

/// Counts the messages of one topic.
class TopicCounter {
public:
    void add(const RecordedMessage& message)
    {
        if (survey_.messages++ == 0) {
            survey_.first = survey_.last = message.time;
        } else {
            const std::int64_t gap = message.time - before_;
            if (gap > survey_.longestGap) {
                survey_.longestGap = gap;
                survey_.gapAt = before_;
            }
            survey_.gaps += static_cast<double>(gap) > kSurveyGap * 1e9 ? 1 : 0;
        }
        before_ = message.time;
        survey_.first = std::min(survey_.first, message.time);
        survey_.last = std::max(survey_.last, message.time);
        if (message.data.size() > kMaxSurveyBytes)
            survey_.why =
                fmt::format("messages of more than {} bytes are only counted", kMaxSurveyBytes);
    }

    bool isDecoded() const { return survey_.why.empty(); }
    void refuse(std::string why) { survey_.why = std::move(why); }

    void add(const RecordedMessage& message, const FieldValue& value)
    {
        if (const auto stamp = stampOf(value); stamp && offsets_.size() < kMaxOffsets)
            offsets_.push_back(static_cast<double>(message.time - *stamp) * 1e-9);
        eachNumber(value, kMaxSurveyElements, [this](const std::string& path, double number) {
            if (FieldSurvey* const field = fieldOf(path)) count(*field, number);
        });
    }

    TopicSurvey finish(const RecordedTopic& topic)
    {
        survey_.topic = topic;
        if (!offsets_.empty()) {
            const auto middle = offsets_.begin() + static_cast<std::ptrdiff_t>(offsets_.size() / 2);
            std::nth_element(offsets_.begin(), middle, offsets_.end());
            survey_.stampOffset = *middle;
        }
        return std::move(survey_);
    }

private:
    FieldSurvey* fieldOf(const std::string& path)
    {
        const auto known = indexes_.find(path);
        if (known != indexes_.end()) return &survey_.fields[known->second];
        if (survey_.fields.size() >= kMaxSurveyFields) return nullptr;
        indexes_[path] = survey_.fields.size();
        survey_.fields.push_back({.path = path});
        return &survey_.fields.back();
    }

    static void count(FieldSurvey& field, double number)
    {
        if (!std::isfinite(number)) {
            ++field.notFinite;
            return;
        }
        const bool isFirst = field.count++ == 0;
        field.least = isFirst ? number : std::min(field.least, number);
        field.most = isFirst ? number : std::max(field.most, number);
    }

    TopicSurvey survey_;
    std::int64_t before_ = 0;
    std::vector<double> offsets_;
    std::unordered_map<std::string, std::size_t> indexes_;
};

}  // namespace

double TopicSurvey::rate() const
{
    return messages > 1 && last > first ? static_cast<double>(messages - 1) / seconds() : 0.0;
}

Result<std::vector<TopicSurvey>> surveyRecording(Recording& recording)
{
    std::vector<TopicCounter> counters;
    for (RecordedMessage message;;) {
        const Result<bool> more = recording.read(message);
        if (!more) return more.error();
        if (!*more) break;
        counters.resize(std::max(counters.size(), recording.topics().size()));
        TopicCounter& counter = counters[message.topic];
        counter.add(message);
        if (!counter.isDecoded()) continue;
        if (const auto value = recording.decode(message))
            counter.add(message, *value);
        else
            counter.refuse(value.error().text);
    }
    counters.resize(recording.topics().size());
    std::vector<TopicSurvey> surveys;
    surveys.reserve(counters.size());
    for (std::size_t i = 0; i < counters.size(); ++i)
        surveys.push_back(counters[i].finish(recording.topics()[i]));
    return surveys;
}

}  // namespace terratact
