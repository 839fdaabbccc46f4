#pragma once

#include <functional>
#include <vector>

#include "app/shell/page.h"
#include "app/shell/preferences/preference_store.h"
#include "core/eval/tradeoff.h"

class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QCheckBox;
class QPushButton;
class QSpinBox;

namespace terratact {

/// The operator's settings: estimation, obstacle height, appearance, model and robot. Every change changes the
/// preferences at once.
class SettingsPage final : public Page {
    Q_OBJECT
public:
    explicit SettingsPage(PreferenceStore& store, QWidget* parent = nullptr);

    /// Sets the costs of the presets; those not measured with the present model are left out.
    void setPresets(std::vector<PresetCost> presets);
    // Descriptions of the model and robot in use.
    void setModelCard(const QString& card);
    void setRobotCard(const QString& card);
    /// Sets why the window cannot be rebuilt now, which another robot or language needs; empty: it can.
    void setReopenBlocked(const QString& why);
    void refresh(double now) override;

    QComboBox* methodBox() const { return method_; }
    QComboBox* qualityBox() const { return quality_; }
    QComboBox* themeBox() const { return theme_; }
    QComboBox* probesBox() const { return probes_; }
    QDoubleSpinBox* thresholdBox() const { return threshold_; }
    QDoubleSpinBox* obstacleBox() const { return obstacle_; }
    QLabel* fontNote() const { return fontNote_; }
    QPushButton* modelButton() const { return chooseModel_; }
    QPushButton* robotButton() const { return chooseRobot_; }
    QSpinBox* secondsBox() const { return seconds_; }
    QComboBox* languageBox() const { return language_; }
    QPushButton* defaultsButton() const { return defaults_; }
    QString modelCard() const;

signals:
    void robotChosen(const QString& path);  ///< a robot file that needs a rebuilt window
    void filesWanted();                     ///< profiles, export and import
    void connectWanted();                   ///< to another robot, log or session

private:
    void buildEstimate(QFormLayout* form);
    void buildLook(QFormLayout* form);
    void buildRecording(QFormLayout* form);
    QWidget* buildFiles();

    // Each creates the control of one preference. A control writes only its own preference, because others may be finer
    // than their controls.
    QComboBox* choice(QFormLayout* form, const QString& label, const QStringList& names,
                      const QString& tip, std::function<int(const Preferences&)> get,
                      std::function<void(Preferences&, std::size_t)> set);
    /// unit: one unit of the box in SI.
    QDoubleSpinBox* number(QFormLayout* form, const QString& label, PreferenceRange range,
                           int decimals, const QString& suffix, const QString& tip,
                           double Preferences::*value, double unit = 1.0);
    enum class ShownIn { Length, Angle };  ///< units()
    QDoubleSpinBox* number(QFormLayout* form, const QString& label, PreferenceRange range,
                           ShownIn quantity, const QString& tip, double Preferences::*value);
    QSpinBox* whole(QFormLayout* form, const QString& label, int least, int most,
                    const QString& suffix, const QString& tip, int Preferences::*value);
    QCheckBox* flag(QFormLayout* form, const QString& text, const QString& tip,
                    bool Preferences::*value);

    void show();  ///< shows the preferences in the controls
    void change(const std::function<void(Preferences&)>& edit);
    void showCosts();

    PreferenceStore& store_;
    std::vector<PresetCost> presets_;
    std::vector<std::function<void(const Preferences&)>> shows_;  // one function per control
    bool showing_ = false;  // the controls are being set by the program, not the operator
    QComboBox* method_ = nullptr;
    QComboBox* quality_ = nullptr;
    QSpinBox* seconds_ = nullptr;
    QComboBox* probes_ = nullptr;
    QDoubleSpinBox* threshold_ = nullptr;
    QDoubleSpinBox* obstacle_ = nullptr;
    QComboBox* theme_ = nullptr;
    QLabel* fontNote_ = nullptr;
    QComboBox* language_ = nullptr;
    QComboBox* lengths_ = nullptr;
    QComboBox* angles_ = nullptr;
    QCheckBox* record_ = nullptr;
    QLabel* model_ = nullptr;
    QLabel* robot_ = nullptr;
    QPushButton* chooseModel_ = nullptr;
    QPushButton* chooseRobot_ = nullptr;
    QPushButton* shippedModel_ = nullptr;
    QPushButton* shippedRobot_ = nullptr;
    QPushButton* defaults_ = nullptr;
    QPushButton* files_ = nullptr;
};

}  // namespace terratact
