#pragma once

#include <QObject>
#include <QString>
#include <cstdint>

#include "app/mission/estimation.h"
#include "core/atem/following.h"

namespace terratact {

/// What an exploration is over a link that takes no commands: the robot does it for somebody else.  Every press is
/// captured and estimated, every reading of the arm estimated again and scored.  GUI thread only.
class PassiveExploration final : public QObject {
    Q_OBJECT
public:
    /// why: no command leaves, in words.  The others must outlive it.
    PassiveExploration(QString why, Estimation& estimation, const AtemLimits& limits);

    const QString& why() const { return why_; }
    /// Takes `state` one tick on.  in: what the console knows by itself (now, linkLost, aborted, estimateReady,
    /// estimateFailed); the rest is seen in the telemetry.
    void tick(AtemState& state, FollowInput in, const Received& latest);

signals:
    void happened(const QString& text, terratact::Weight weight);

private:
    void poll(FollowInput& in, const Received& latest) const;
    void enter(const AtemState& state, const Received& latest);
    void fail(AtemFailure failure);
    static QString whyMoved();

    QString why_;
    Estimation& estimation_;
    const AtemLimits& limits_;
    std::uint64_t captured_ = 0;  ///< Press::count; 0: none
    std::uint64_t lostAt_ = 0;    ///< count of the newest telemetry while the link was lost
};

}  // namespace terratact
