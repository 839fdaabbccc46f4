#pragma once

#include <QString>
#include <optional>

#include "app/mission/model_trainer.h"
#include "app/shell/page.h"
#include "core/base/message.h"

class QBoxLayout;
class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;
class QSpinBox;
class QTableWidget;

namespace terratact {

class Exploration;
class HoldToConfirmButton;

/// Returns terratact/models in the user's data folder (XDG base directory specification).
QString modelsDirectory();

/// Trains a model from a scene file and compares it with the one in use. If the operator adopts it, it replaces that
/// one. The live console continues meanwhile. Cancel and the end of the page stop the training; driving does not.
/// Adoption needs a comparison since the training, and no exploration.
class TrainingPage final : public Page {
    Q_OBJECT
public:
    struct Options {
        RobotModel robot;
        QString model;                          ///< file in use
        QString directory = modelsDirectory();  ///< folder of new models
        TrainingLoad load = politeLoad();
    };
    TrainingPage(const Exploration& exploration, Options options, QWidget* parent = nullptr);
    ~TrainingPage() override;

    void refresh(double now) override;
    void changeEvent(QEvent* event) override;

    QLineEdit* scenesField() const { return scenes_; }
    QLineEdit* testField() const { return test_; }
    QLineEdit* nameField() const { return name_; }
    QPushButton* scenesButton() const { return chooseScenes_; }
    QPushButton* startButton() const { return start_; }
    QPushButton* cancelButton() const { return cancel_; }
    QPushButton* compareButton() const { return compare_; }
    HoldToConfirmButton* adoptButton() const { return adopt_; }
    HoldToConfirmButton* discardButton() const { return discard_; }
    QProgressBar* bar() const { return bar_; }
    QLabel* status() const { return status_; }
    QLabel* verdict() const { return verdict_; }
    QLabel* caution() const { return caution_; }
    QLabel* reason() const { return reason_; }
    QTableWidget* bins() const { return bins_; }
    QTableWidget* comparison() const { return comparison_; }
    const QString& modelInUse() const { return options_.model; }
    void setModelInUse(const QString& path) { options_.model = path; }

public slots:
    void adoptionDone();  ///< call when the console has loaded the adopted model
    void adoptionFailed(const Message& why);  ///< call when loading failed

signals:
    void adopted(const QString& path);  ///< the operator adopts this model

private:
    enum class Phase { Idle, Training, Trained, Comparing, Compared, Adopting };
    static constexpr int kColumnBefore = 1, kColumnAfter = 2, kColumnDifference = 3;
    static constexpr int kPerMille = 1000;  ///< range of the progress bar

    QWidget* trainCard();
    QWidget* compareCard();
    QPushButton* addFile(QBoxLayout* column, const QString& what, const QString& title,
                         QLineEdit*& field);
    void choose(QLineEdit* field, const QString& title);
    void connectTrainer();
    void start();
    void compare();
    void adopt();
    void discard();
    void enter(Phase phase);
    void showStatus(const QString& text, bool bad = false);
    void ended(const QString& what, bool bad);
    void showButtons();
    void showProgress();
    void keepRoomForStatus();
    void showBins(const TrainingProgress& progress);
    void showComparison(const ModelComparison& comparison);
    void clearComparison();
    QString pathOfName() const;
    // Each returns a reason; empty: allowed.
    std::optional<QString> whyBusy() const;
    std::optional<QString> whyNotStart() const;
    std::optional<QString> whyNotCompare() const;
    std::optional<QString> whyNotDiscard() const;
    std::optional<QString> whyNotAdopt() const;

    const Exploration& exploration_;
    Options options_;
    ModelTrainer trainer_;
    Phase phase_ = Phase::Idle;
    QString trained_;  ///< file of the new model; empty: none

    QLineEdit *scenes_ = nullptr, *name_ = nullptr, *test_ = nullptr;
    QSpinBox* seed_ = nullptr;
    QPushButton *chooseScenes_ = nullptr, *chooseTest_ = nullptr, *start_ = nullptr,
                *cancel_ = nullptr, *compare_ = nullptr;
    HoldToConfirmButton *adopt_ = nullptr, *discard_ = nullptr;
    QProgressBar* bar_ = nullptr;
    QLabel *status_ = nullptr, *newModel_ = nullptr, *verdict_ = nullptr, *caution_ = nullptr,
           *reason_ = nullptr;
    QTableWidget *bins_ = nullptr, *comparison_ = nullptr;
};

}  // namespace terratact
