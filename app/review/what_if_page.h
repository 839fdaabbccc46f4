#pragma once

#include <QStringList>
#include <memory>
#include <optional>

#include "app/mission/estimator_worker.h"
#include "app/runtime/revised.h"
#include "app/shell/page.h"
#include "core/log/rows/session_rows.h"
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

/// Recomputes a recorded estimate with the recorded or other settings: method, quality, threshold, seed or model. The
/// result is shown beside the recorded one.
class WhatIfPage final : public Page {
    Q_OBJECT
public:
    /// models: files to choose from, and to search for the recorded model.
    WhatIfPage(RobotModel robot, QStringList models, QWidget* parent = nullptr);
    ~WhatIfPage() override;

    /// Sets the estimate under review; null: none. An answer for another estimate is dropped.
    void setRecorded(const std::shared_ptr<const EstimateRow>& estimate, const SceneRow* scene,
                     const ModelRow* model);
    void refresh(double now) override;

    void asRecorded();  ///< sets the form to the recorded settings
    void estimate();    ///< estimates with the form's settings

    /// Returns the last answer for the estimate under review.
    const Revised<TwoTrackEstimate>& answer() const { return answer_; }

    QComboBox* method() const { return method_; }
    QComboBox* quality() const { return quality_; }
    QComboBox* model() const { return model_; }
    QDoubleSpinBox* threshold() const { return threshold_; }
    QLineEdit* seed() const { return seed_; }
    QPushButton* cancelButton() const { return cancel_; }
    QLabel* result() const { return result_; }
    QTableWidget* table() const { return table_; }

signals:
    void answered();  ///< answer() has changed

protected:
    void changeEvent(QEvent* event) override;

private:
    QWidget* form();
    void resizeToFont();
    void offerMemory();
    Settings settings() const;
    bool isRecordedModel() const;
    void useModel(const QString& path);
    void addEstimate(int job, const TwoTrackEstimate& estimate);
    void showAnswer();
    static QString placeName(const Differences& found);  ///< bin that moved most, with its side
    QString verdictText(const Differences& found) const;
    void showBins(const Differences* found);  ///< null: shows only the recorded bins
    /// Shows the bins of one side. name: empty for one plane.
    void showSide(const Differences* found, std::size_t side, const QString& name);
    void drop();
    void showStatus(const QString& text, Tone tone);

    RobotModel robot_;
    QStringList models_;
    std::unique_ptr<EstimatorWorker> worker_;  ///< null until first needed
    QString modelPath_;                        ///< model that the worker has or loads
    int job_ = 0;
    std::shared_ptr<const EstimateRow> recorded_;
    std::optional<SceneRow> scene_;
    QString recordedModel_, recordedHash_;
    std::string modelHash_;  ///< hash of the file modelPath_
    std::string recordedTrail_,
        trailHash_;  ///< hashes of the networks: recorded, and beside modelPath_
    std::optional<Settings> asked_;
    Revised<TwoTrackEstimate> answer_;

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
