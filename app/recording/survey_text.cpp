#include "app/recording/survey_text.h"

#include <fmt/format.h>

#include <cstdint>

#include "core/base/text.h"

namespace terratact {
namespace {

std::string topicText(const TopicSurvey& survey)
{
    const RecordedTopic& topic = survey.topic;
    std::string text = fmt::format(
        "\n{}\n  {} of {}: {} messages", printable(topic.name), printable(topic.encoding),
        topic.type.empty() ? "an unnamed type" : printable(topic.type), survey.messages);
    if (survey.rate() > 0.0)
        text +=
            fmt::format(" in {:.3f} s, {:.2f} per second, longest gap {:.3f} s", survey.seconds(),
                        survey.rate(), static_cast<double>(survey.longestGap) * 1e-9);
    text += "\n";
    if (survey.stampOffset)
        text += fmt::format("  header.stamp lies {:.3f} s before the recorder's time\n",
                            *survey.stampOffset);
    if (!survey.why.empty()) text += fmt::format("  not decoded: {}\n", printable(survey.why));
    for (const FieldSurvey& field : survey.fields) {
        text += fmt::format("  {:<40} ", printable(field.path));
        text += field.count > 0 ? fmt::format("{:>12.6g} to {:<12.6g}", field.least, field.most)
                                : fmt::format("{:>28}", "no finite value");
        if (field.notFinite > 0) text += fmt::format(" {} null or not finite", field.notFinite);
        text += "\n";
    }
    return text;
}

}  // namespace

std::string surveyText(const Recording& recording, const std::vector<TopicSurvey>& surveys)
{
    std::uint64_t messages = 0;
    for (const TopicSurvey& survey : surveys) messages += survey.messages;
    std::string text = fmt::format(
        "{}: {}, {} topic{}, {} message{}\n", printable(recording.path()), recording.format(),
        surveys.size(), surveys.size() == 1 ? "" : "s", messages, messages == 1 ? "" : "s");
    for (const TopicSurvey& survey : surveys) text += topicText(survey);
    return text;
}

}  // namespace terratact
