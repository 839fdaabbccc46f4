#pragma once

#include <QObject>
#include <cstdint>

#include "app/mission/estimation.h"
#include "core/atem/following.h"
#include "core/base/message.h"

namespace terratact {

/// Follows another console's exploration over a receive-only link. It captures and estimates every press, and scores
/// every arm reading and estimates again with it. GUI thread only.
class PassiveExploration final : public QObject {
    Q_OBJECT
public:
    /// why: reason that no command is sent. The other arguments must outlive the object.
    PassiveExploration(Message why, Estimation& estimation, const AtemLimits& limits);

    const Message& why() const { return why_; }
    /// Advances `state` by one tick. in: what this console can determine itself (now, linkLost, aborted, estimateReady,
    /// estimateFailed). Everything else comes from telemetry.
    void tick(AtemState& state, FollowInput in, const Received& latest);

signals:
    void happened(const terratact::Message& text, terratact::EventSeverity severity);
    /// Emitted instead of happened() for an event that the state shows, too.
    void stateChanged(const terratact::Message& text, terratact::EventSeverity severity);

private:
    void poll(FollowInput& in, const Received& latest) const;
    void enter(const AtemState& state, const Received& latest);
    void fail(AtemFailure failure);
    static Message whyMoved();

    Message why_;
    Estimation& estimation_;
    const AtemLimits& limits_;
    std::uint64_t captured_ = 0;  ///< Press::count; 0: none
    std::uint64_t lostAt_ = 0;    ///< count of the newest sample when the link was last lost
};

}  // namespace terratact
