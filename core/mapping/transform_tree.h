#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/bags/field_value.h"
#include "core/mapping/frame_pose.h"

namespace terratact {

/// Topics of transforms in ROS: fixed ones, and those that change.
inline constexpr const char* kFixedTransforms = "/tf_static";
inline constexpr const char* kTransforms = "/tf";

/// Poses of frames in each other over time, from tf2_msgs/TFMessage. A transform of /tf_static, and one that never
/// changes, holds at all times. Between two stamped transforms poses are interpolated. Of several parents of a
/// frame the first counts.
class TransformTree {
public:
    static constexpr std::size_t kMaxTransforms = 5'000'000;

    /// maxGap: longest time between two transforms in which one is interpolated [s].
    explicit TransformTree(double maxGap = 0.5);

    /// Keeps the frames between this one and its root, whatever else the recording moves. Where no frame was named,
    /// all are kept.
    void want(std::string_view frame);

    /// Adds the transforms of a message of kTransforms or kFixedTransforms; messages of other topics are ignored.
    /// recorded: when it was recorded [ns].
    void add(std::string_view topic, const FieldValue& message, std::int64_t recorded);

    /// Returns true if the wanted frames have more than kMaxTransforms transforms; further ones were ignored.
    bool isFull() const { return isFull_; }

    /// Returns true if transforms join both frames, at any time.
    bool joins(std::string_view outer, std::string_view inner) const;

    /// Returns the pose of the frame `inner` in `outer` at a time of header.stamp [ns]. Empty if no chain of transforms
    /// joins both, or one of the chain has no transforms around that time.
    std::optional<FramePose> at(std::string_view outer, std::string_view inner,
                                std::int64_t time) const;

    /// Time of a transform [ns]: that of header.stamp, and when it was recorded.
    struct Stamp {
        std::int64_t stamp = 0, recorded = 0;
    };
    /// Returns the times at which the pose between two frames was sent. They are those of the chain's transform that
    /// changed most often, in the order of stamps, each once. One time if all are fixed; empty if no chain joins both.
    std::vector<Stamp> stamps(std::string_view outer, std::string_view inner) const;

    /// Returns "a → b, b → c, …" for an error: parents and children.
    std::string links() const;

private:
    struct Moment {
        Stamp time{};
        FramePose pose{};
    };
    struct Link {
        std::string parent;
        bool isFixed = false;
        std::vector<Moment> moments{};  ///< in the order of stamps once sorted
    };
    static constexpr std::size_t kMaxFrames = 10'000;
    static constexpr int kMaxChain = 100;  ///< links of a chain

    void addOne(bool isFixed, const FieldValue& item, std::int64_t recorded);
    void store(Link& link, const Moment& moment);
    void forgetOthers();
    std::optional<FramePose> linkAt(const Link& link, std::int64_t time) const;
    /// Returns the links from a frame to its root.
    std::vector<const Link*> chain(std::string frame, std::string& root) const;
    /// Returns both chains without their common end. Empty if the roots differ.
    struct Chains {
        std::vector<const Link*> outer, inner;
    };
    std::optional<Chains> chains(std::string_view outer, std::string_view inner) const;
    void sort() const;

    double maxGap_;
    mutable bool isSorted_ = true;
    bool isFull_ = false;
    std::size_t moments_ = 0, pruneAt_;
    std::set<std::string> wanted_;
    mutable std::map<std::string, Link, std::less<>> links_;  ///< by child
};

}  // namespace terratact
