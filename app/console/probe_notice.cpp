#include "app/console/probe_notice.h"

#include <QLabel>

#include "app/display/format.h"
#include "widgets/base/navigation_rail.h"

namespace terratact {
namespace {

/// Returns the phase in one word, no wider with a time than the longest name in the rail.
QString phaseWord(AtemPhase phase)
{
    switch (phase) {
    case AtemPhase::Idle:
    case AtemPhase::ProposingProbe:
    case AtemPhase::Stopped: return {};  // shown elsewhere on every page
    case AtemPhase::Halting: return ProbeNotice::tr("halting");
    case AtemPhase::Pressing: return ProbeNotice::tr("pressing");
    case AtemPhase::Estimating:
    case AtemPhase::EstimatingAgain: return ProbeNotice::tr("estimating");
    case AtemPhase::Probing: return ProbeNotice::tr("probe");
    case AtemPhase::Presenting: return ProbeNotice::tr("result");
    case AtemPhase::Failed: return ProbeNotice::tr("failed");
    case AtemPhase::Advancing: return ProbeNotice::tr("advancing");
    }
    return {};
}

/// Returns "probe 0:31": the remaining time, if it is known and long.
QString progressText(AtemPhase phase, const std::optional<PhaseTime>& time)
{
    const QString word = phaseWord(phase);
    const bool isKnown =
        phase == AtemPhase::Probing && time && time->kind == PhaseTime::Kind::Expected;
    return isKnown ? word + QLatin1Char(' ') + format::countdown(time->seconds) : word;
}

}  // namespace

ProbeNotice::ProbeNotice(NavigationRail& rail, QLabel& banner) : rail_(rail), banner_(banner)
{
    banner_.setObjectName(QStringLiteral("question"));
    banner_.hide();
}

void ProbeNotice::show(const AtemState& state, const std::optional<PhaseTime>& time,
                       const std::optional<ProbeProposal>& proposal, bool isVoid, Terrain terrain)
{
    const bool seen = terrain == Terrain::Seen, covered = terrain == Terrain::Covered;
    const bool asks = proposal && state.phase == AtemPhase::ProposingProbe;
    const bool expired = state.phase == AtemPhase::Presenting && state.approvalExpired;
    sawExpiry_ = expired && (sawExpiry_ || seen);
    const QString left = format::countdown(time ? time->seconds : 0.0);
    const bool looksAway = terrain == Terrain::Elsewhere;
    rail_.setNote(rail_.pageOf(Qt::Key_F2),
                  asks        ? (isVoid ? tr("arm: void") : tr("arm? %1").arg(left))
                  : looksAway ? progressText(state.phase, time)
                              : QString(),
                  asks && !isVoid);
    QString text;
    if (asks && isVoid)
        text = tr("The proposed probe is void: F2 shows the reason");
    else if (asks)
        text =
            (covered
                 ? tr("PROBE at %1? Refused in %2 unless approved: close the window that covers it")
                 : tr("PROBE at %1? Refused in %2 unless approved: F2 shows the question"))
                .arg(format::binName(proposal->bin), left);
    else if (expired && !sawExpiry_)
        text = covered ? tr("The probe was not answered in time and counts as refused: close the "
                            "window that covers the result")
                       : tr("The probe was not answered in time and counts as refused: F2 shows "
                            "the result");
    if (banner_.text() != text) banner_.setText(text);
    banner_.setVisible(!text.isEmpty() && !seen);
}

}  // namespace terratact
