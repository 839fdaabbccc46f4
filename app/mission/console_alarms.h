#pragma once

#include <QObject>
#include <QString>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/link/can_source.h"
#include "app/runtime/growing_count.h"
#include "app/shell/alarm_sound.h"
#include "core/atem/alarms.h"
#include "core/atem/link_watch.h"
#include "core/robot/attitude.h"
#include "core/robot/watch/sensor_suspicion.h"

namespace terratact {

/// What can be wrong, as it stands now.  An empty text: it is not.
struct AlarmViewState {
    LinkAccount link{};
    QString sourceTrouble{};       ///< why there is no telemetry
    std::optional<CanView> bus{};  ///< empty: the source is none
    std::string busName{};
    std::uint64_t wrongChecksums = 0;  ///< since the bus was opened
    QString noModel{}, panelTrouble{}, failedExploration{}, notRecorded{};
    bool isStopped = false;                     ///< the robot says so
    std::vector<SensorSuspicion> suspicions{};  ///< of sensors, now
    bool isSceneSuspected = false;              ///< a verdict is withheld for one
    std::optional<Measurement> measurement{};   ///< the newest, while it is heard
    Attitude attitude{};                        ///< of it
};

/// "pitch angle: not changed for 12 s …; force 1, force 2: loaded while …", in the operator's language.
QString suspicionWords(const std::vector<SensorSuspicion>& suspicions);

/// Finds the alarms in what is seen and lets them sound.  A cause must be away for a while before its alarm
/// returns, and what comes now and then on a sound bus must stay for a while before it is one.  GUI thread only.
class ConsoleAlarms final : public QObject {
    Q_OBJECT
public:
    static constexpr double kFirstTelemetry = 3.0;  ///< [s] may pass before there is any
    static constexpr double kGoneFor = 1.0;  ///< [s] a cause is away before its alarm returns

    explicit ConsoleAlarms(std::unique_ptr<AlarmSound> alarmSound, QObject* parent = nullptr);

    /// now: [s] on the steady clock.  To be called several times a second.
    void poll(double now, const AlarmViewState& viewState);

    const AlarmList& list() const { return list_; }
    void acknowledge(const std::string& id) { list_.acknowledge(id); }
    void acknowledgeAll() { list_.acknowledgeAll(); }
    void silence(double until) { list_.silence(until); }
    void setSoundOn(bool on) { soundOn_ = on; }
    bool soundOn() const { return soundOn_; }
    void trySound();  ///< sounds, wanted or not
    QString soundTrouble() const { return alarmSound_->trouble(); }

signals:
    /// It stands now, or is graver now, and no other part of the window tells of it.
    void raised(const QString& text, Severity severity);
    void sounded();  ///< just now: sound is wanted, or was tried

private:
    struct Cause {
        std::optional<double> stands{}, gone{};  ///< [s] since
        std::optional<Severity> told{};          ///< the gravest that was raised
    };
    /// after: [s] it has to stand before it is an alarm.
    void judge(const std::string& id, bool stands, const QString& text, Severity severity,
               double after = 0.0);
    void lookAtLink(const AlarmViewState& viewState);
    void lookAtBus(const CanView& bus, const AlarmViewState& viewState);
    void lookAtArming(const ArmingState& arming);
    void lookAtSensors(const ElementForces& forces);
    void lookAtSuspicions(const AlarmViewState& viewState);
    void lookAtAttitude(const AlarmViewState& viewState);
    void lookAtHalt(const AlarmViewState& viewState);

    std::unique_ptr<AlarmSound> alarmSound_;
    AlarmList list_;
    std::map<std::string, Cause> causes_;
    std::map<std::string, GrowingCount> counted_;
    std::optional<double> began_;
    QString suspected_{};  ///< the last suspicions, in words
    QString halted_{};     ///< why the robot has ended its last drive by itself; empty: it has not
    RobotActivity activity_ = RobotActivity::Halted;
    bool wasArmed_ = false;
    std::optional<DisarmCause> disarmedBy_{};  ///< not the operator, who has not armed anew since
    double now_ = 0.0;
    bool soundOn_ = true;
};

}  // namespace terratact
