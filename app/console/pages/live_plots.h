#pragma once

#include <QObject>

#include "app/link/robot_moment.h"
#include "app/plotting/live_signals.h"

namespace terratact {

class DbcFiles;
class Exploration;
class PlotsPage;
class PreferenceStore;

/// The plots of the running console: it feeds the plotted signals and owns them. GUI thread only.
class LivePlots final : public QObject {
    Q_OBJECT
public:
    /// link: null if the source has no bus. All arguments must outlive the object.
    LivePlots(Acquisition& acquisition, CanSource* link, const Exploration& exploration,
              PreferenceStore& preferences, QWidget* parent);
    ~LivePlots() override;  ///< ends the feed

    PlotsPage* page() const { return page_; }
    void describeBy(DbcFiles& dbc);  ///< uses its descriptions from now on
    /// Adds a new estimate and the load of the bus; call for every frame of the window.
    void poll(const RobotMoment& moment);

private:
    Acquisition& acquisition_;
    CanSource* link_;
    const Exploration& exploration_;
    LiveSignals signals_;
    std::uint64_t estimate_ = 0;  // revision that was added
    double loadAt_ = 0.0;         // [s]
    PlotsPage* page_ = nullptr;   // owned by the window
};

}  // namespace terratact
