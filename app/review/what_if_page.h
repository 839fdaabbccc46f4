#pragma once

#include <QStringList>
#include <memory>
#include <optional>

#include "app/mission/estimator_worker.h"
#include "app/shell/page.h"
#include "core/log/session_rows.h"
#include "core/robot/robot_model.h"

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;
class QTableWidget;

namespace terratact {

struct Differences;
enum class Tone;

/// Estimates a recorded scene again, as it was or with another method, quality, threshold, seed or model, beside
/// what was shown then.
class WhatIfPage final : public Page {
    Q_OBJECT
public:
    /// models: files to choose from, and to look for the recorded model among.
    WhatIfPage(RobotModel robot, QStringList models, QWidget* parent = nullptr);
    ~WhatIfPage() override;

    /// What stands at the time under review; null: nothing.  What was asked of another is dropped.
    void setRecorded(const std::shared_ptr<const EstimateRow>& estimate, const SceneRow* scene,
                     const ModelRow* model);
    void refresh(double now) override;

    void asRecorded();  ///< sets the form to what was recorded
    void estimate();    ///< with what the form says

    /// The last answer to what is under review.
    const std::optional<TerrainEstimate>& answer() const { return answer_; }

    QComboBox* method() const { return method_; }
    QComboBox* quality() const { return quality_; }
    QComboBox* model() const { return model_; }
    QDoubleSpinBox* threshold() const { return threshold_; }
    QLineEdit* seed() const { return seed_; }
    QPushButton* estimateButton() const { return estimate_; }
    QPushButton* cancelButton() const { return cancel_; }
    QLabel* result() const { return result_; }
    QTableWidget* table() const { return table_; }

signals:
    void answered();  ///< answer() is another

protected:
    void changeEvent(QEvent* event) override;

private:
    QWidget* form();
    void resizeToFont();
    Settings settings() const;
    bool isRecordedModel() const;
    void useModel(const QString& path);
    void take(int job, const TerrainEstimate& estimate);
    void showAnswer();
    void showBins(const Differences* found);  ///< null: of what was recorded alone
    void drop();
    void say(const QString& text, Tone tone);

    RobotModel robot_;
    QStringList models_;
    std::unique_ptr<EstimatorWorker> worker_;  ///< null until it is first needed
    QString modelPath_;                        ///< that the worker has, or loads
    int job_ = 0;
    std::shared_ptr<const EstimateRow> recorded_;
    std::optional<SceneRow> scene_;
    QString recordedModel_, recordedHash_;
    std::string modelHash_;  ///< of modelPath_
    std::optional<Settings> asked_;
    std::optional<TerrainEstimate> answer_;

    QWidget* form_ = nullptr;
    QComboBox* method_ = nullptr;
    QComboBox* quality_ = nullptr;
    QComboBox* model_ = nullptr;
    QDoubleSpinBox* threshold_ = nullptr;
    QLineEdit* seed_ = nullptr;
    QPushButton* asRecorded_ = nullptr;
    QPushButton* estimate_ = nullptr;
    QProgressBar* progress_ = nullptr;
    QPushButton* cancel_ = nullptr;
    QLabel* what_ = nullptr;
    QLabel* result_ = nullptr;
    QTableWidget* table_ = nullptr;
};

}  // namespace terratact
