#include "app/panel_control.h"

#include <utility>

namespace terratact {

PanelControl::PanelControl(std::unique_ptr<OperatorPanel> panel, MeasurementSource& source,
                           Exploration& exploration)
    : exploration_(exploration), reader_(std::move(panel), source)
{
}

void PanelControl::tick(double now, bool mayExplore)
{
    report_ = reader_.latest();
    const bool stopped = report_.state.stop;
    if (stopped && !wasStopped_) {
        exploration_.stop();  // again, after the reader's own: the window has to know, too
        emit happened(report_.state.present ? tr("STOP pressed on the panel")
                                            : tr("the panel is lost, which means STOP"),
                      Weight::Bad);
    }
    wasStopped_ = stopped;
    press(mayExplore && answers(now));
    light();
    const QString trouble = QString::fromStdString(report_.trouble);
    if (trouble != trouble_ && !trouble.isEmpty()) emit happened(trouble, Weight::Bad);
    trouble_ = trouble;
}

void PanelControl::press(bool mayExplore)
{
    const PerContact<int> presses = reader_.takePresses();
    if (presses[PanelContact::Atem] > 0 && mayExplore) exploration_.request();
    const auto& proposal = exploration_.proposal();
    if (!proposal) return;
    if (presses[PanelContact::Refuse] > 0)
        exploration_.refuse(proposal->id);
    else if (presses[PanelContact::Approve] > 0)
        exploration_.approve(proposal->id);
}

void PanelControl::light()
{
    const AtemPhase phase = exploration_.state().phase;
    const bool asks = phase == AtemPhase::ProposingProbe;
    reader_.setLamps({.link = exploration_.linkAlive(),
                      .armed = exploration_.armed(),
                      .probing = exploring(phase),
                      .buzzer = asks || !exploration_.linkAlive()});
}

bool PanelControl::answers(double now) const
{
    return report_.state.present && reader_.age(now) <= kAnswersWithin;
}

Precondition PanelControl::precondition(double now) const
{
    using Level = Precondition::Level;
    if (!answers(now)) return {Level::Missing, tr("the operator's panel does not answer")};
    if (stopPressed()) return {Level::Missing, tr("STOP is pressed on the panel")};
    return {Level::Met, tr("the operator's panel answers")};
}

}  // namespace terratact
