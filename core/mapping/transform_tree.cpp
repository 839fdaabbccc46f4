#include "core/mapping/transform_tree.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/base/text.h"

namespace terratact {
namespace {

constexpr std::size_t kPruneStep = 500'000;     // transforms
constexpr std::int64_t kSameStamp = 1'000'000;  // [ns]

/// ROS 1 before tf2 wrote a slash before frames.
std::string frameName(std::string_view name)
{
    return std::string(name.starts_with('/') ? name.substr(1) : name);
}

/// Returns the pose of a geometry_msgs/Transform; empty if a number is missing, or it has no direction.
std::optional<FramePose> transformOf(const FieldValue& item)
{
    constexpr std::array kPaths{"transform.rotation.w", "transform.rotation.x",
                                "transform.rotation.y", "transform.rotation.z"};
    std::array<double, 4> q{};
    for (std::size_t i = 0; i < q.size(); ++i) {
        const auto value = numberAt(item, kPaths.at(i));
        if (!value) return std::nullopt;
        q.at(i) = *value;
    }
    FramePose pose{Eigen::Vector3d::Zero(), Eigen::Quaterniond(q[0], q[1], q[2], q[3])};
    const double length = pose.turn.squaredNorm();
    if (!(length > 1e-6 && length < 1e6)) return std::nullopt;
    pose.turn.normalize();
    constexpr std::array kAxes{"transform.translation.x", "transform.translation.y",
                               "transform.translation.z"};
    for (std::size_t i = 0; i < kAxes.size(); ++i) {
        const auto value = numberAt(item, kAxes.at(i));
        if (value && !std::isfinite(*value)) return std::nullopt;
        pose.place(static_cast<Eigen::Index>(i)) = value.value_or(0.0);
    }
    return pose;
}

bool isSame(const FramePose& a, const FramePose& b)
{
    return a.place == b.place && a.turn.coeffs() == b.turn.coeffs();
}

}  // namespace

TransformTree::TransformTree(double maxGap) : maxGap_(maxGap), pruneAt_(kPruneStep) {}

void TransformTree::want(std::string_view frame)
{
    wanted_.insert(frameName(frame));
}

void TransformTree::add(std::string_view topic, const FieldValue& message, std::int64_t recorded)
{
    const bool isFixed = topic == kFixedTransforms;
    if (!isFixed && topic != kTransforms) return;
    const FieldValue* const transforms = message.member("transforms");
    if (!transforms) return;
    for (const FieldValue& item : transforms->parts) addOne(isFixed, item, recorded);
    if (moments_ < pruneAt_) return;
    forgetOthers();
    pruneAt_ = moments_ + kPruneStep;
}

void TransformTree::addOne(bool isFixed, const FieldValue& item, std::int64_t recorded)
{
    const auto parent = textAt(item, "header.frame_id"), child = textAt(item, "child_frame_id");
    const auto pose = transformOf(item);
    if (!parent || !child || !pose) return;
    const std::string name = frameName(*child);
    if (links_.size() >= kMaxFrames && !links_.contains(name)) return;
    Link& link = links_.try_emplace(name, Link{.parent = frameName(*parent)}).first->second;
    if (link.parent != frameName(*parent) || (link.isFixed && !isFixed)) return;
    if (isFixed) {
        if (link.isFixed) return;
        moments_ -= link.moments.size();
        link.moments.clear();
        link.isFixed = true;
    }
    store(link, {.time = {.stamp = stampOf(item).value_or(recorded), .recorded = recorded},
                 .pose = *pose});
}

void TransformTree::store(Link& link, const Moment& moment)
{
    std::vector<Moment>& moments = link.moments;
    const std::size_t size = moments.size();
    if (size > 0 && moment.time.stamp < moments.back().time.stamp) isSorted_ = false;
    // Of poses that stay the same the first and the last are kept.
    if (size > 1 && moment.time.stamp >= moments.back().time.stamp
        && isSame(moments[size - 1].pose, moment.pose)
        && isSame(moments[size - 2].pose, moment.pose)) {
        moments.back().time = moment.time;
        return;
    }
    if (moments_ >= kMaxTransforms) {
        isFull_ = true;
        return;
    }
    moments.push_back(moment);
    ++moments_;
}

void TransformTree::forgetOthers()
{
    if (wanted_.empty()) return;
    std::set<const Link*> kept;
    for (const std::string& frame : wanted_) {
        std::string root;
        for (const Link* const link : chain(frame, root)) kept.insert(link);
    }
    for (auto& [child, link] : links_)
        if (!kept.contains(&link)) {
            moments_ -= link.moments.size();
            link.moments = {};
        }
}

void TransformTree::sort() const
{
    if (isSorted_) return;
    const auto stamp = [](const Moment& moment) { return moment.time.stamp; };
    for (auto& [child, link] : links_) std::ranges::stable_sort(link.moments, {}, stamp);
    isSorted_ = true;
}

std::optional<FramePose> TransformTree::linkAt(const Link& link, std::int64_t time) const
{
    const std::vector<Moment>& moments = link.moments;
    if (moments.empty()) return std::nullopt;
    const auto differs = [&](const Moment& m) { return !isSame(m.pose, moments.front().pose); };
    if (link.isFixed || (moments.size() <= 2 && !differs(moments.back())))
        return moments.front().pose;
    const auto stamp = [](const Moment& moment) { return moment.time.stamp; };
    const auto after = std::ranges::lower_bound(moments, time, {}, stamp);
    if (after != moments.end() && after->time.stamp - time <= kSameStamp) return after->pose;
    if (after == moments.begin()) return std::nullopt;
    const Moment& before = *(after - 1);
    if (time - before.time.stamp <= kSameStamp) return before.pose;
    if (after == moments.end()) return std::nullopt;
    if (isSame(before.pose, after->pose)) return before.pose;
    const double gap = 1e-9 * static_cast<double>(after->time.stamp - before.time.stamp);
    if (gap > maxGap_) return std::nullopt;
    return between(before.pose, after->pose,
                   1e-9 * static_cast<double>(time - before.time.stamp) / gap);
}

std::vector<const TransformTree::Link*> TransformTree::chain(std::string frame,
                                                             std::string& root) const
{
    std::vector<const Link*> chain;
    for (int i = 0; i < kMaxChain; ++i) {
        const auto link = links_.find(frame);
        if (link == links_.end()) break;
        chain.push_back(&link->second);
        frame = link->second.parent;
    }
    root = std::move(frame);
    return chain;
}

std::optional<TransformTree::Chains> TransformTree::chains(std::string_view outer,
                                                           std::string_view inner) const
{
    std::string rootOfOuter, rootOfInner;
    Chains both{.outer = chain(frameName(outer), rootOfOuter),
                .inner = chain(frameName(inner), rootOfInner)};
    if (rootOfOuter != rootOfInner) return std::nullopt;
    while (!both.outer.empty() && !both.inner.empty() && both.outer.back() == both.inner.back()) {
        both.outer.pop_back();
        both.inner.pop_back();
    }
    return both;
}

bool TransformTree::joins(std::string_view outer, std::string_view inner) const
{
    return chains(outer, inner).has_value();
}

std::optional<FramePose> TransformTree::at(std::string_view outer, std::string_view inner,
                                           std::int64_t time) const
{
    const auto both = chains(outer, inner);
    if (!both) return std::nullopt;
    sort();
    const auto inCommon = [&](const std::vector<const Link*>& links) -> std::optional<FramePose> {
        FramePose pose;
        for (const Link* const link : links) {
            const auto step = linkAt(*link, time);
            if (!step) return std::nullopt;
            pose = step->with(pose);
        }
        return pose;
    };
    const auto a = inCommon(both->outer), b = inCommon(both->inner);
    if (!a || !b) return std::nullopt;
    return a->inverse().with(*b);
}

std::vector<TransformTree::Stamp> TransformTree::stamps(std::string_view outer,
                                                        std::string_view inner) const
{
    const auto both = chains(outer, inner);
    if (!both) return {};
    sort();
    const Link* most = nullptr;
    for (const auto* const links : {&both->inner, &both->outer})
        for (const Link* const link : *links)
            if (!most || link->moments.size() > most->moments.size()) most = link;
    std::vector<Stamp> stamps;
    if (!most) return stamps;
    stamps.reserve(most->moments.size());
    for (const Moment& moment : most->moments)
        if (stamps.empty() || stamps.back().stamp < moment.time.stamp)
            stamps.push_back(moment.time);
    return stamps;
}

std::string TransformTree::links() const
{
    constexpr std::size_t kMaxListed = 12;
    std::string list;
    std::size_t listed = 0;
    for (const auto& [child, link] : links_) {
        if (++listed > kMaxListed) return list + ", …";
        list += fmt::format("{}{} → {}", list.empty() ? "" : ", ", printable(link.parent),
                            printable(child));
    }
    return list.empty() ? "none" : list;
}

}  // namespace terratact
