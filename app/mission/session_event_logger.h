#pragma once

#include <QObject>
#include <QString>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "app/link/panel_reader.h"
#include "app/mission/console_alarms.h"
#include "app/mission/exploration.h"
#include "app/recording/session_recorder.h"
#include "widgets/signals/event_list.h"

namespace terratact {

/// Tells the recorder what happens at the console: scenes, estimates and proposals as they come, what the operator
/// does with the numbers that were on the screen, and every change of link, arming, exploration, alarms and panel.
/// What rows say of themselves is in English; words that were on the screen are as they stood there, in its language.
/// GUI thread only.
class SessionEventLogger final : public QObject {
    Q_OBJECT
public:
    SessionEventLogger(std::shared_ptr<SessionRecorder> recorder, Exploration& exploration,
                       EstimatorWorker& worker, EventList& events, QObject* parent = nullptr);

    /// What else there is to see; to be called several times a second.
    void poll(const LinkAccount& link, const std::optional<CanView>& bus, const AlarmList& alarms,
              const std::optional<PanelState>& panel);

    /// A marker of the operator's.
    void mark(const QString& note);

    RecordingState state() const { return recorder_->state(); }
    void decision(const char* what, const QString& text);  ///< by the operator

private:
    void connectTo(Exploration& exploration);
    void takeModel(const QString& name, const QString& details, const QString& hash);
    void takeEstimate(bool second);
    void takeProposal();
    void tell(EventKind kind, const std::string& subject, const std::string& text = {},
              std::optional<double> number = std::nullopt);
    std::string shown() const;
    void lookAtLink(const LinkAccount& link, const std::optional<CanView>& bus);
    void lookAtAlarms(const AlarmList& alarms);
    void lookAtPanel(const PanelState& panel);

    std::shared_ptr<SessionRecorder> recorder_;
    Exploration& exploration_;
    std::int64_t model_ = 0, scene_ = 0, estimate_ = 0, proposal_ = 0;  ///< ids; 0: none stands
    std::optional<AtemPhase> phase_;
    LinkAccount link_;
    std::string linkTold_;  ///< subject of the last event; empty: there was none
    std::optional<ArmingPhase> arming_;
    std::string overridden_;
    std::map<std::string, AlarmState> alarms_;
    std::optional<PerContact<bool>> contacts_;
};

}  // namespace terratact
