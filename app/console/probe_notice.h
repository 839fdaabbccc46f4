#pragma once

#include <QCoreApplication>
#include <optional>

#include "core/atem/phase_time.h"
#include "widgets/control/probe_card.h"

class QLabel;

namespace terratact {

class NavigationRail;

/// Informs an operator on another page. The rail shows the progress of an exploration. A banner shows a proposed probe,
/// its approval expiry and the key that shows it. An expired proposal is reported as refused. GUI thread only.
class ProbeNotice {
    Q_DECLARE_TR_FUNCTIONS(ProbeNotice)
public:
    /// Both arguments must outlive the object.
    ProbeNotice(NavigationRail& rail, QLabel& banner);

    /// Visibility of the terrain page, which shows all of this itself.
    enum class Terrain {
        Seen,       ///< the operator sees the page
        Covered,    ///< the page is visible, but another window covers the probe card
        Elsewhere,  ///< the operator sees another page
    };
    /// Call for every frame of the window. proposal: the current one, proposed or not. isVoid: it cannot be approved.
    void show(const AtemState& state, const std::optional<PhaseTime>& time,
              const std::optional<ProbeProposal>& proposal, bool isVoid, Terrain terrain);

private:
    NavigationRail& rail_;
    QLabel& banner_;
    bool sawExpiry_ = false;  ///< the operator has seen the page since the proposal expired
};

}  // namespace terratact
