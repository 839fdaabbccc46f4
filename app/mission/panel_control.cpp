#include "app/mission/panel_control.h"

#include <utility>

namespace terratact {

PanelControl::PanelControl(std::unique_ptr<OperatorPanel> panel, MeasurementSource& source,
                           Exploration& exploration)
    : exploration_(exploration), reader_(std::move(panel), source)
{
}

void PanelControl::tick(double now, const ViewState& viewState)
{
    if (now_ == 0.0) answeredAt_ = now;  // grace period at the start
    now_ = now;
    if (std::exchange(shown_, viewState.shown) != viewState.shown) shownSince_ = now;
    report_ = reader_.latest();
    if (answers(now)) answeredAt_ = now;
    const bool stopped = report_.state.stop || isLost();
    if (stopped && !wasStopped_) {
        // The reader sends STOP itself; this second STOP also updates the window.
        exploration_.stop();
        emit happened(
            report_.state.present && !isLost()
                ? TR_NOOP("terratact::PanelControl", "STOP pressed on the panel")
            : exploration_.following()
                ? TR_NOOP("terratact::PanelControl", "the panel is lost")
                : TR_NOOP("terratact::PanelControl", "the panel is lost: STOP is asserted"),
            EventSeverity::Bad);
    }
    wasStopped_ = stopped;
    press(viewState);
    ask(viewState);
    light();
    const Message& trouble = report_.trouble;
    if (!trouble.empty() && trouble != trouble_) emit happened(trouble, EventSeverity::Bad);
    trouble_ = trouble;
}

void PanelControl::press(const ViewState& viewState)
{
    const PerContact<int> presses = reader_.consumePresses();
    if (presses[PanelContact::Atem] > 0 && viewState.mayExplore && answers(now_))
        exploration_.request();
    const auto& proposal = exploration_.proposal();
    if (!proposal) {
        approving_ = false;
        return;
    }
    if (presses[PanelContact::Refuse] > 0)
        exploration_.refuse(proposal->id);
    else
        approve(proposal->id, presses[PanelContact::Approve] > 0, viewState.covered);
}

void PanelControl::approve(quint64 asked, bool pressed, bool covered)
{
    if (pressed && shown_ != asked)
        emit happened(
            covered ? TR_NOOP("terratact::PanelControl",
                              "not approved: close the window that covers the question")
                    : TR_NOOP("terratact::PanelControl",
                              "not approved: the question is not on the screen (Terrain, F2)"),
            EventSeverity::Bad);
    const ContactState& contact = report_.state.contacts[PanelContact::Approve];
    const bool counts = shown_ == asked && report_.state.held(PanelContact::Approve)
                     && contact.since >= shownSince_;
    if (std::exchange(approving_, counts) && !counts)
        emit happened(TR_NOOP("terratact::PanelControl",
                              "not approved: the panel's button has to be held for 1.5 s"),
                      EventSeverity::Bad);
    if (!counts || report_.state.time - contact.since < kApproveHold) return;
    approving_ = false;
    exploration_.approve(asked);
}

void PanelControl::buzz()
{
    buzzUntil_ = now_ + kBuzz;
}

void PanelControl::ask(const ViewState& viewState)
{
    if (exploration_.state().phase != AtemPhase::ProposingProbe) return asked_.reset();
    if (!viewState.mayAsk || (asked_ && now_ - *asked_ < kAskAgain)) return;
    asked_ = now_;
    buzz();
}

void PanelControl::light()
{
    reader_.setLamps({.link = exploration_.linkAlive(),
                      .armed = exploration_.armed(),
                      .probing = exploring(exploration_.state().phase),
                      .buzzer = now_ < buzzUntil_});
}

bool PanelControl::answers(double now) const
{
    return report_.state.present && reader_.age(now) <= kAnswersWithin;
}

std::optional<Message> PanelControl::whyNotReleased() const
{
    if (!report_.state.present || isLost())
        return TR_NOOP("terratact::PanelControl",
                       "the panel is lost: connect it first, or start the console without --panel");
    if (!stopPressed()) return std::nullopt;
    return TR_NOOP("terratact::PanelControl",
                   "STOP is pressed on the panel: release it there first");
}

Precondition PanelControl::precondition(double now) const
{
    using Level = Precondition::Level;
    if (!answers(now))
        return {Level::Missing,
                TR_NOOP("terratact::PanelControl", "the operator's panel does not answer")};
    if (stopPressed())
        return {Level::Missing, TR_NOOP("terratact::PanelControl", "STOP is pressed on the panel")};
    return {Level::Met, TR_NOOP("terratact::PanelControl", "the operator's panel answers")};
}

}  // namespace terratact
