#pragma once

#include <QCoreApplication>
#include <optional>
#include <string>
#include <vector>

#include "app/console/connection/link_status.h"
#include "app/console/pages/diagnostics_page.h"
#include "app/link/robot_moment.h"
#include "app/mission/console_alarms.h"
#include "app/mission/exploration.h"
#include "app/mission/panel_control.h"
#include "app/pages/force_arrays.h"
#include "app/pages/terrain_page.h"
#include "app/recording/session_recorder.h"
#include "app/shell/preferences/preference_store.h"

namespace terratact {

/// Computes the values that the console's pages show from its running parts. GUI thread only.
class LiveViewState {
    Q_DECLARE_TR_FUNCTIONS(LiveViewState)
public:
    /// The running parts; null: absent.
    struct Parts {
        const Acquisition& acquisition;
        const Exploration& exploration;
        const EstimatorWorker& worker;
        CanSource* link = nullptr;
        const PanelControl* panel = nullptr;
        const SessionRecorder* recorder = nullptr;
        const PreferenceStore* preferences = nullptr;  ///< null: the defaults
    };
    /// All parts must outlive the object.
    LiveViewState(const Parts& parts, const RobotModel& robot)
        : parts_(parts), model_(robot), robot_(robot.name), forceArrays_(robot)
    {
    }

    // moment: that of the exploration's last tick. It must outlive the LinkViewState and the TerrainViewState.
    LinkViewState link(const RobotMoment& moment);
    /// link: at the same time.
    AlarmViewState alarms(const RobotMoment& moment, const LinkAccount& link) const;
    TerrainViewState terrain(const RobotMoment& moment);
    ConsoleFacts facts(const RobotMoment& moment, const QString& source,
                       const QString& robotDetails) const;
    /// Returns the panel's precondition for motion; empty: no panel.
    std::optional<Precondition> panel(double now) const;

private:
    const std::vector<ForceArray>& forcesOf(const Received& newest);
    Attitude attitudeOf(const Measurement& line) const;

    Parts parts_;
    RobotModel model_;
    std::string robot_;  ///< name of the robot
    LinkWatch link_;
    ForceArrays forceArrays_;
    std::vector<ForceArray> forces_;
    std::uint64_t forcesCount_ = 0;  ///< count of the sample that the forces belong to
};

}  // namespace terratact
