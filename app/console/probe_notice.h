#pragma once

#include <QCoreApplication>
#include <optional>

#include "core/atem/phase_time.h"
#include "widgets/control/probe_card.h"

class QLabel;

namespace terratact {

class NavigationRail;

/// Tells an operator who does not see the terrain's page how far an exploration is, in the rail; that a probe is proposed there, how long it waits for an
/// answer and what brings it before him; and, once nobody has answered, that this meant no.  GUI thread only.
class ProbeNotice {
    Q_DECLARE_TR_FUNCTIONS(ProbeNotice)
public:
    /// Both must outlive it.
    ProbeNotice(NavigationRail& rail, QLabel& banner);

    /// Where the page of the terrain is, which says all that itself.
    enum class Terrain {
        Seen,       ///< before the operator
        Covered,    ///< likewise, but for another window that covers the card of the probe
        Elsewhere,  ///< he looks at another page
    };
    /// To be called whenever the window is drawn.  proposal: where there is one, asked or not.  isVoid: it cannot be
    /// approved as things are.
    void show(const AtemState& state, const std::optional<PhaseTime>& time,
              const std::optional<ProbeProposal>& proposal, bool isVoid, Terrain terrain);

private:
    NavigationRail& rail_;
    QLabel& banner_;
    bool toldExpiry_ = false;  ///< the operator has seen the page since the answer came too late
};

}  // namespace terratact
