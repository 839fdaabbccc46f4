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
#include "core/base/message.h"
#include "core/robot/attitude.h"
#include "core/robot/watch/sensor_suspicion.h"

namespace terratact {

/// Current inputs of the alarms. An empty text means no trouble.
struct AlarmViewState {
    LinkAccount link{};
    Message sourceTrouble{};           ///< reason that there is no telemetry
    std::optional<CanView> bus{};      ///< empty: the source has no bus
    std::uint64_t wrongChecksums = 0;  ///< since the bus was opened
    Message noModel{}, panelTrouble{}, failedExploration{}, notRecorded{};
    bool isStopped = false;                     ///< the robot reports that it is stopped
    std::vector<SensorSuspicion> suspicions{};  ///< current suspicions of sensors
    bool isSceneSuspected = false;              ///< a verdict is withheld because of a suspicion
    std::optional<Measurement> measurement{};   ///< newest measurement while telemetry is fresh
    Attitude attitude{};                        ///< tip-over assessment of the measurement
};

/// Returns suspicions as one message: "pitch angle: not changed for 12 s …; force 1, force 2: loaded while
/// …".
Message suspicionMessage(const std::vector<SensorSuspicion>& suspicions);

/// Derives alarms from the console's state and plays their sound. A cause must be absent for a while before its alarm
/// can return. A cause that occurs occasionally on a working bus must persist before it becomes an alarm. GUI thread
/// only.
class ConsoleAlarms final : public QObject {
    Q_OBJECT
public:
    static constexpr double kFirstTelemetry = 3.0;  ///< [s] grace period for the first telemetry
    static constexpr double kGoneFor = 1.0;  ///< [s] absence of a cause before its alarm can return

    explicit ConsoleAlarms(std::unique_ptr<AlarmSound> alarmSound, QObject* parent = nullptr);

    /// Updates the alarms; call several times a second. now: steady clock [s].
    void poll(double now, const AlarmViewState& viewState);

    const AlarmList& list() const { return list_; }
    void acknowledge(const std::string& id) { list_.acknowledge(id); }
    void acknowledgeAll() { list_.acknowledgeAll(); }
    void silence(double until) { list_.silence(until); }
    void setSoundOn(bool on) { soundOn_ = on; }
    bool soundOn() const { return soundOn_; }
    /// Plays a tick of a contact (AlarmSound::tick()); silencing the alarms does not silence it.
    void contactTick(double pitch, double level) { alarmSound_->tick(pitch, level); }
    void trySound();  ///< plays the sound even if muted
    QString soundTrouble() const { return alarmSound_->trouble(); }

signals:
    /// Emitted for a new or more severe alarm that no other part of the window shows.
    void raised(const terratact::Message& text, Severity severity);
    void sounded();  ///< emitted when a sound is due or was tried

private:
    struct Cause {
        std::optional<double> stands{}, gone{};  ///< [s] start of the cause, of its absence
        std::optional<Severity> raised{};        ///< highest severity raised so far
    };
    /// after: time [s] a cause must persist before it becomes an alarm.
    void judge(const std::string& id, bool stands, const Message& text, Severity severity,
               double after = 0.0);
    void checkLink(const AlarmViewState& viewState);
    void checkBus(const CanView& bus, const AlarmViewState& viewState);
    void checkArming(const ArmingState& arming);
    void checkSensors(const ElementForces& forces);
    void checkSuspicions(const AlarmViewState& viewState);
    void checkAttitude(const AlarmViewState& viewState);
    void checkHalt(const AlarmViewState& viewState);

    std::unique_ptr<AlarmSound> alarmSound_;
    AlarmList list_;
    std::map<std::string, Cause> causes_;
    std::map<std::string, GrowingCount> counted_;
    std::optional<double> began_;
    Message suspected_{};  ///< last suspicions
    Message halted_{};     ///< reason that the robot ended its last drive itself; empty: it did not
    RobotActivity activity_ = RobotActivity::Halted;
    bool wasArmed_ = false;
    /// Cause of an unwanted disarming; empty after the operator has armed again.
    std::optional<DisarmCause> disarmedBy_{};
    double now_ = 0.0;
    bool soundOn_ = true;
};

}  // namespace terratact
