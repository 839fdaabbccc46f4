#pragma once

#include <QObject>
#include <QString>

#include "app/mission/estimator_worker.h"
#include "app/shell/preference_store.h"
#include "core/robot/robot_model.h"

namespace terratact {

/// Which model file the estimator works with.  A model is preferred once it is in use; one that cannot be loaded while
/// another is in use is not preferred any more.
class ModelChoice final : public QObject {
    Q_OBJECT
public:
    /// inUse: what the worker loads at its start.  The others must outlive it.
    ModelChoice(EstimatorWorker& worker, PreferenceStore& preferences, const RobotModel& robot,
                QString inUse);

    const QString& inUse() const { return inUse_; }
    /// Ends in loaded(), or in the worker's modelKept or modelFailed.  While one is being loaded the next one waits, of
    /// which the last is loaded.
    void load(const QString& path);
    void loadPreferred();  ///< where that is another than inUse()

signals:
    void loaded();  ///< inUse()

private:
    void begin(const QString& path);
    void end();
    void preferInUse();

    EstimatorWorker& worker_;
    PreferenceStore& preferences_;
    const RobotModel& robot_;
    QString inUse_;
    QString wanted_;  ///< being loaded; empty: none
    QString next_;    ///< waits for that; empty: none
};

}  // namespace terratact
