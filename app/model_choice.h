#pragma once

#include <QObject>
#include <QString>

#include "app/estimator_worker.h"
#include "app/preference_store.h"
#include "core/robot/robot_model.h"

namespace terratact {

/// Which model file the estimator works with.  A model is preferred once it is in use; one that cannot be loaded is
/// not preferred any more.
class ModelChoice final : public QObject {
    Q_OBJECT
public:
    /// inUse: what the worker loads at its start.  The others must outlive it.
    ModelChoice(EstimatorWorker& worker, PreferenceStore& preferences, const RobotModel& robot,
                QString inUse);

    const QString& inUse() const { return inUse_; }
    void
    load(const QString& path);  ///< ends in loaded(), or in the worker's modelKept or modelFailed
    void loadPreferred();       ///< where that is another than inUse()

signals:
    void loaded();  ///< inUse()

private:
    void preferInUse();

    EstimatorWorker& worker_;
    PreferenceStore& preferences_;
    const RobotModel& robot_;
    QString inUse_;
    QString wanted_;  ///< being loaded; empty: none
};

}  // namespace terratact
