#pragma once

#include <QCoreApplication>
#include <optional>

#include "core/atem/phase_time.h"
#include "widgets/probe_card.h"

class QLabel;

namespace terratact {

class NavigationRail;

/// Tells an operator who looks at another page than the terrain's that a probe is proposed there and how long it waits
/// for an answer; and, once nobody has given one, that this meant no.  GUI thread only.
class ProbeNotice {
    Q_DECLARE_TR_FUNCTIONS(ProbeNotice)
public:
    /// Both must outlive it.
    ProbeNotice(NavigationRail& rail, QLabel& banner);

    /// To be called whenever the window is drawn.  proposal: where there is one, asked or not.  seen: the operator has
    /// the page of the terrain before him, which says all that itself.
    void show(const AtemState& state, const std::optional<PhaseTime>& time,
              const std::optional<ProbeProposal>& proposal, bool seen);

private:
    NavigationRail& rail_;
    QLabel& banner_;
    bool toldExpiry_ = false;  ///< the operator has seen the page since the answer came too late
};

}  // namespace terratact
