#pragma once

#include <QObject>
#include <QString>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/display/event_severity.h"
#include "app/link/panel_reader.h"
#include "app/mission/console_alarms.h"
#include "app/mission/exploration.h"
#include "app/recording/session_recorder.h"
#include "core/base/message.h"

namespace terratact {

/// Records the console's events: scenes, estimates, proposals, the operator's decisions, and changes of link, arming,
/// exploration, alarms and panel. Texts of rows are English, with their message for translation. GUI thread only.
class SessionEventLogger final : public QObject {
    Q_OBJECT
public:
    SessionEventLogger(std::shared_ptr<SessionRecorder> recorder, Exploration& exploration,
                       EstimatorWorker& worker, QObject* parent = nullptr);

    /// Records state changes that have no signal; call several times a second.
    void poll(const LinkAccount& link, const std::optional<CanView>& bus, const AlarmList& alarms,
              const std::optional<PanelState>& panel);

    /// Records a marker of the operator.
    void mark(const QString& note);
    /// Records a snapshot by the name of its files, and a note on it.
    void snapshot(const QString& name);
    void noteSnapshot(const QString& name, const QString& note);

    /// A line of the list of events, as text.
    void word(const Message& text, EventSeverity severity);

    RecordingState state() const { return recorder_->state(); }
    void decision(const char* what, const Message& text);  ///< a decision of the operator

private:
    void connectTo(Exploration& exploration);
    void logModel(const QString& name, const QString& details, const QString& hash,
                  const QString& content, bool hasTwoTracks, const TrailInUse& trail);
    void logEstimate(bool second);
    void logProposal();
    void log(EventKind kind, const std::string& subject, const Message& text = {},
             std::optional<double> number = std::nullopt);
    void logLink(const LinkAccount& link, const std::optional<CanView>& bus);
    void logAlarms(const AlarmList& alarms);
    void logPanel(const PanelState& panel);

    std::shared_ptr<SessionRecorder> recorder_;
    Exploration& exploration_;
    std::int64_t model_ = 0, scene_ = 0, estimate_ = 0, proposal_ = 0;  ///< ids; 0: none
    /// Of the scene's first estimate: the arm measured them at an earlier press in place.
    std::vector<ArmReading> earlierReadings_;
    std::optional<AtemPhase> phase_;
    LinkAccount link_;
    std::string loggedLink_;  ///< subject of the last event; empty: none
    std::optional<ArmingPhase> arming_;
    Message overridden_;
    std::map<std::string, AlarmState> alarms_;
    std::optional<PerContact<bool>> contacts_;
};

}  // namespace terratact
