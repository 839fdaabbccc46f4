#include "core/mapping/recorded_transforms.h"

#include <fmt/format.h>

#include "core/base/text.h"
#include "core/mapping/topic_decoding.h"

namespace terratact {

Status readTransforms(Recording& recording, TransformTree& transforms)
{
    recording.select({kFixedTransforms, kTransforms});
    TopicDecoding decoding;
    for (RecordedMessage message;;) {
        const auto more = recording.read(message);
        if (!more) return more.error();
        if (!*more) break;
        const std::string& topic = recording.topics().at(message.topic).name;
        if (topic != kFixedTransforms && topic != kTransforms) continue;
        const auto value = recording.decode(message);
        if (!value) {
            decoding.broken(topic, value.error());
            continue;
        }
        decoding.decoded(topic);
        transforms.add(topic, *value, message.time);
    }
    std::vector<std::string> ignored;
    return decoding.check(recording.path(), ignored);
}

Result<SentPoses> sentPoses(const TransformTree& transforms, const OdometrySource& source,
                            bool byHeader)
{
    const std::string frames =
        fmt::format("from {} to {}", shown(source.frame), shown(source.baseFrame));
    if (transforms.isFull())
        return Error{fmt::format("/tf holds more than {} transforms {}; cut the recording into "
                                 "shorter files",
                                 TransformTree::kMaxTransforms, frames),
                     0};
    if (!transforms.joins(source.frame, source.baseFrame))
        return Error{
            fmt::format("/tf_static and /tf hold no transforms {}; there are: {}; correct frame "
                        "and base_frame of [odometry]",
                        frames, transforms.links()),
            0};
    SentPoses sent;
    for (const TransformTree::Stamp& time : transforms.stamps(source.frame, source.baseFrame)) {
        const auto pose = transforms.at(source.frame, source.baseFrame, time.stamp);
        if (pose)
            sent.poses.push_back({byHeader ? time.stamp : time.recorded, *pose});
        else
            ++sent.without;
    }
    if (sent.poses.empty())
        return Error{fmt::format("the transforms {} have no time in common; look at the clocks of "
                                 "the nodes that send them, or raise max_gap_s",
                                 frames),
                     0};
    return sent;
}

}  // namespace terratact
