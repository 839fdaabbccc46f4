#pragma once

#include "app/page.h"
#include "app/preference_store.h"
#include "core/eval/tradeoff.h"

class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QCheckBox;
class QPushButton;
class QSpinBox;

namespace terratact {

/// What the operator may set: how is estimated, what counts as an obstacle, how the console looks, and which model
/// and robot it works with.  Every change is a change of the preferences, at once.
class SettingsPage final : public Page {
    Q_OBJECT
public:
    explicit SettingsPage(PreferenceStore& store, std::vector<PresetCost> presets,
                          QWidget* parent = nullptr);

    // What is in use, in a few lines.
    void setModelCard(const QString& card);
    void setRobotCard(const QString& card);
    /// Why the window cannot be built anew now, as another robot needs it; empty: it can.
    void setReopenBlocked(const QString& why);
    void refresh(double now) override;

    QComboBox* methodBox() const { return method_; }
    QComboBox* qualityBox() const { return quality_; }
    QComboBox* themeBox() const { return theme_; }
    QDoubleSpinBox* thresholdBox() const { return threshold_; }
    QDoubleSpinBox* obstacleBox() const { return obstacle_; }
    QLabel* lettersNote() const { return lettersNote_; }
    QCheckBox* recordBox() const { return record_; }
    QPushButton* modelButton() const { return chooseModel_; }
    QPushButton* robotButton() const { return chooseRobot_; }
    QPushButton* defaultsButton() const { return defaults_; }
    QString modelCard() const;

private:
    void buildEstimate(QFormLayout* form);
    void buildLook(QFormLayout* form);
    void buildRecording(QFormLayout* form);
    QSpinBox* limit(QFormLayout* form, const QString& label, int most, const QString& unit,
                    const QString& tip);
    QWidget* buildFiles();
    QComboBox* choice(QFormLayout* form, const QString& label, const QStringList& names,
                      const QString& tip);
    QDoubleSpinBox* number(QFormLayout* form, const QString& label, double least, double most,
                           int decimals, const QString& unit, const QString& tip);
    void show();  ///< the preferences in the controls
    void take();  ///< from the controls
    void chooseFile(QString Preferences::*file, const QString& title, const QString& filter);
    void showCosts();

    PreferenceStore& store_;
    std::vector<PresetCost> presets_;
    bool showing_ = false;  // the controls are being set, not the operator's doing
    QComboBox* method_ = nullptr;
    QComboBox* quality_ = nullptr;
    QDoubleSpinBox* threshold_ = nullptr;
    QDoubleSpinBox* obstacle_ = nullptr;
    QDoubleSpinBox* probeAbove_ = nullptr;
    QDoubleSpinBox* roll_ = nullptr;
    QDoubleSpinBox* asymmetry_ = nullptr;
    QComboBox* theme_ = nullptr;
    QSpinBox* fontScale_ = nullptr;
    QLabel* lettersNote_ = nullptr;
    QComboBox* language_ = nullptr;
    QComboBox* layout_ = nullptr;
    QCheckBox* sound_ = nullptr;
    QCheckBox* record_ = nullptr;
    QSpinBox* keepDays_ = nullptr;
    QSpinBox* keepGigabytes_ = nullptr;
    QLabel* model_ = nullptr;
    QLabel* robot_ = nullptr;
    QPushButton* chooseModel_ = nullptr;
    QPushButton* chooseRobot_ = nullptr;
    QPushButton* shippedModel_ = nullptr;
    QPushButton* shippedRobot_ = nullptr;
    QPushButton* defaults_ = nullptr;
};

}  // namespace terratact
