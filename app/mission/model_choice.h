#pragma once

#include <QObject>
#include <QString>

#include "app/mission/estimator_worker.h"
#include "app/shell/preferences/preference_store.h"
#include "core/robot/robot_model.h"

namespace terratact {

/// Selects the estimator's model file. A model becomes the preferred one after it has loaded. A preferred model that
/// cannot be loaded loses its preference if another is in use.
class ModelChoice final : public QObject {
    Q_OBJECT
public:
    /// inUse: file that the worker loads at its start. The other arguments must outlive the object.
    ModelChoice(EstimatorWorker& worker, PreferenceStore& preferences, const RobotModel& robot,
                QString inUse);

    const QString& inUse() const { return inUse_; }
    /// Loads a model; ends in loaded(), or in the worker's modelKept or modelFailed. A call during loading waits; of
    /// several waiting calls only the last is loaded.
    void load(const QString& path);
    void loadPreferred();  ///< if it differs from inUse()

signals:
    void loaded();  ///< inUse() has changed

private:
    void begin(const QString& path);
    void end();
    void preferInUse();

    EstimatorWorker& worker_;
    PreferenceStore& preferences_;
    const RobotModel& robot_;
    QString inUse_;
    QString wanted_;  ///< file being loaded; empty: none
    QString next_;    ///< next file; empty: none
};

}  // namespace terratact
