#include "core/infer/estimate/two_track_estimate.h"

#include <algorithm>

namespace terratact {

std::vector<Message> ofBothSides(const std::vector<Message>& left,
                                 const std::vector<Message>& right)
{
    const auto has = [](const std::vector<Message>& all, const Message& sentence) {
        return std::ranges::find(all, sentence) != all.end();
    };
    std::vector<Message> sentences;
    sentences.reserve(left.size() + right.size());
    for (const Message& sentence : left)
        sentences.push_back(has(right, sentence) ? sentence
                                                 : Message(TR_NOOP("core", "left: %1"), sentence));
    for (const Message& sentence : right)
        if (!has(left, sentence)) sentences.emplace_back(TR_NOOP("core", "right: %1"), sentence);
    return sentences;
}

}  // namespace terratact
