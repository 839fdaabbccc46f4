#include "app/probe_notice.h"

#include <QLabel>

#include "widgets/navigation_rail.h"
#include "widgets/words.h"

namespace terratact {

ProbeNotice::ProbeNotice(NavigationRail& rail, QLabel& banner) : rail_(rail), banner_(banner)
{
    banner_.setObjectName(QStringLiteral("question"));
    banner_.hide();
}

void ProbeNotice::show(const AtemState& state, const std::optional<PhaseTime>& time,
                       const std::optional<ProbeProposal>& proposal, Terrain terrain)
{
    const bool seen = terrain == Terrain::Seen, covered = terrain == Terrain::Covered;
    const bool asks = proposal && state.phase == AtemPhase::ProposingProbe;
    const bool expired = state.phase == AtemPhase::Presenting && state.approvalExpired;
    toldExpiry_ = expired && (toldExpiry_ || seen);
    const QString left = words::countdown(time ? time->seconds : 0.0);
    rail_.setAsking(rail_.pageOf(Qt::Key_F2), asks ? tr("arm? %1").arg(left) : QString());
    QString text;
    if (asks)
        text = (covered ? tr("PROBE at %1? %2 left, then no: close the window that covers it")
                        : tr("PROBE at %1? %2 left, then no: F2 shows the question"))
                   .arg(words::binName(proposal->bin), left);
    else if (expired && !toldExpiry_)
        text = covered ? tr("The probe was not answered in time, which means no: close the window "
                            "that covers the result")
                       : tr("The probe was not answered in time, which means no: F2 shows the "
                            "result");
    if (banner_.text() != text) banner_.setText(text);
    banner_.setVisible(!text.isEmpty() && !seen);
}

}  // namespace terratact
