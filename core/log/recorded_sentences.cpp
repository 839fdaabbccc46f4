#include "core/log/recorded_sentences.h"

#include <optional>
#include <string_view>
#include <utility>

namespace terratact {
namespace {

constexpr SourceText kSentences[] = {
    TR_NOOP("core", "a step ahead of more than %1 mm: probability %2 ± %3, likeliest between %4 "
                    "and %5 m (%6)"),
    TR_NOOP("core",
            "a step ahead of more than %1 mm: probability %2 ± %3, most likely at %4 m … %5 "
            "m (%6)"),
    TR_NOOP("terratact::Exploration", "no answer in time: no probe"),
    TR_NOOP("terratact::Exploration", "the robot says that it is stopped"),
    TR_NOOP("core", "link is up"),
    TR_NOOP("core", "link lost"),
    TR_NOOP("core", "closed with the console"),
    TR_NOOP("LinkStatus", "the robot is armed"),
    TR_NOOP("terratact::Estimation", "model %1 loaded"),
    TR_NOOP("terratact::Estimation", "model %1 stays in use: %2"),
    TR_NOOP("terratact::Estimation", "estimate in %1"),
    TR_NOOP("terratact::Estimation", "estimate failed: %1"),
    TR_NOOP("terratact::Estimation", "arm %1: %2 m, %3 the band shown before"),
    TR_NOOP("terratact::Estimation", "inside"),
    TR_NOOP("terratact::Estimation", "outside"),
    TR_NOOP("terratact::Exploration", "exploration requested"),
    TR_NOOP("terratact::Exploration", "exploration failed: %1"),
    TR_NOOP("terratact::Exploration", "exploration ended by the operator"),
    TR_NOOP("terratact::Exploration", "probe proposed %1"),
    TR_NOOP("terratact::Exploration", "probe %1 approved"),
    TR_NOOP("terratact::Exploration", "probe refused"),
    TR_NOOP("terratact::Exploration", "STOP"),
    TR_NOOP("terratact::Exploration", "STOP not sent: %1"),
    TR_NOOP("terratact::Exploration", "STOP released by the operator"),
    TR_NOOP("terratact::Exploration", "overridden by the operator: %1"),
    TR_NOOP("terratact::Exploration", "the override has ended: %1"),
    TR_NOOP("terratact::Exploration", "The robot has moved: explore again (A)"),
    TR_NOOP("terratact::MainWindow", "marked in the recording"),
    TR_NOOP("terratact::Place", "at %1"),
};

constexpr int kDeepestSentence = 2;  // a place in an argument of a sentence

Message recovered(std::string_view text, int depth);

/// Returns the message if `text` is this sentence with arguments in its places, which are sentences
/// themselves.
std::optional<Message> matched(SourceText sentence, std::string_view text, int depth)
{
    Message message(sentence);
    std::string_view pattern = sentence.english;
    for (;;) {
        const std::size_t place = pattern.find('%');
        const std::string_view fixedPart = pattern.substr(0, place);
        if (!text.starts_with(fixedPart)) return std::nullopt;
        text.remove_prefix(fixedPart.size());
        if (place == std::string_view::npos) break;
        pattern.remove_prefix(place + 2);
        const std::size_t end =
            pattern.empty() ? text.size() : text.find(pattern.substr(0, pattern.find('%')));
        if (end == 0 || end == std::string_view::npos) return std::nullopt;
        message.arguments.push_back(recovered(text.substr(0, end), depth + 1));
        text.remove_prefix(end);
    }
    return text.empty() ? std::optional(std::move(message)) : std::nullopt;
}

Message recovered(std::string_view text, int depth)
{
    if (depth <= kDeepestSentence)
        for (const SourceText sentence : kSentences)
            if (auto message = matched(sentence, text, depth)) return std::move(*message);
    return Message::verbatim(std::string(text));
}

}  // namespace

Message recordedSentence(const std::string& english)
{
    return recovered(english, 0);
}

}  // namespace terratact
