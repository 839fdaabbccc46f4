#include "core/mapping/transform_tree.h"

#include <utility>

namespace terratact {
namespace {

/// ROS 1 before tf2 wrote a slash before frames.
std::string frameName(std::string name)
{
    if (name.starts_with('/')) name.erase(0, 1);
    return name;
}

}  // namespace

void TransformTree::add(const FieldValue& message)
{
    const FieldValue* const transforms = message.member("transforms");
    if (!transforms) return;
    for (const FieldValue& item : transforms->parts) {
        const auto parent = textAt(item, "header.frame_id"), child = textAt(item, "child_frame_id");
        const auto x = numberAt(item, "transform.rotation.x"),
                   y = numberAt(item, "transform.rotation.y"),
                   z = numberAt(item, "transform.rotation.z"),
                   w = numberAt(item, "transform.rotation.w");
        if (!parent || !child || !x || !y || !z || !w || links_.size() >= kMaxFrames) continue;
        const double length = *x * *x + *y * *y + *z * *z + *w * *w;
        if (!(length > 1e-6 && length < 1e6)) continue;
        links_.try_emplace(frameName(*child), Link{.parent = frameName(*parent),
                                                   .rotation = rotationOf(*x, *y, *z, *w)});
    }
}

Rotation TransformTree::fromRoot(std::string frame, std::string& root) const
{
    Rotation rotation = rotationOfAngles(0.0, 0.0, 0.0);
    for (int i = 0; i < kLongest; ++i) {
        const auto link = links_.find(frame);
        if (link == links_.end()) break;
        rotation = product(link->second.rotation, rotation);
        frame = link->second.parent;
    }
    root = std::move(frame);
    return rotation;
}

std::optional<Rotation> TransformTree::rotation(const std::string& from,
                                                const std::string& to) const
{
    std::string rootOfFrom, rootOfTo;
    const Rotation a = fromRoot(frameName(from), rootOfFrom), b = fromRoot(frameName(to), rootOfTo);
    if (rootOfFrom != rootOfTo) return std::nullopt;
    return product(transposed(a), b);
}

}  // namespace terratact
