#pragma once

#include <gtest/gtest.h>

#include <QImage>
#include <QStringList>
#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "app/console/main_window.h"
#include "app/review/review_window.h"
#include "app/review/scenes_window.h"
#include "drivers/memory_bus.h"
#include "tests/support/absolem.h"
#include "tests/support/benches/staged_robot.h"
#include "tests/support/devices/fake_gamepad.h"
#include "tests/support/devices/panel_board.h"
#include "tests/support/patient_clock.h"
#include "tests/support/temporary_directory.h"

namespace terratact {

class HoldToConfirmButton;

/// The pictures of one test; the chapter has the test's name.
struct Chapter {
    std::string_view name;
    std::vector<std::string_view> pictures;
};

/// Returns every state of the console, in the order of a mission.
const std::vector<Chapter>& chapters();

/// Returns "04-03_hold_to_approve_at_half": chapter, number, name. Empty if no chapter has the picture.
QString pictureFile(std::string_view name);

/// Real windows with a simulated robot on a bus. A test puts them into one state after another and takes a picture of
/// each in every language. English is first; none of its texts may occur in the others.
struct Screens : testing::Test {
    Screens();
    ~Screens() override;

    /// Runs `tour` in each language, or only in $TERRATACT_LANGUAGE. The tour must take every picture of the chapter.
    void inEveryLanguage(const std::function<void()>& tour);

    /// Takes a picture once the window shows each text of `says`, in which %1 matches anything. No text may be cut, no
    /// widgets may overlap, and STOP must be visible.
    void picture(std::string_view name, const QStringList& says);
    /// Takes the picture with another window on top, which may show some of `says`.
    void pictureWith(QWidget& above, std::string_view name, const QStringList& says);
    /// Takes the picture with the button's open menu, which shows each text of `says`.
    void pictureOfMenu(QPushButton& button, std::string_view name, const QStringList& says);
    bool reads(const QString& text) const;  ///< true if the text is somewhere in the window

    /// Options of a console under test.
    struct Setting {
        /// Empty: the shipped model, whose estimates the test may alter.
        ModelLoader model{};
        double before = 0.6;     ///< [m] distance of the robot before the step
        bool isPressed = false;  ///< the flippers are pressed from the start
        CanSource::Mode mode = CanSource::Mode::Transmit;
        std::string busName = "can0";
        double linkLostAfter = 3.0;  ///< [s] long, because the machine may be busy
        AtemLimits limits = kPatient;
        bool hasPanel = false;
        bool hasGamepad = false;
        bool safeMode = false;
        std::string sessions{};  ///< folder of recordings; empty: a temporary one
        Staging staging{};
    };
    static constexpr AtemLimits kPatient{
        .halt = 600.0, .press = 600.0, .estimate = 600.0, .approval = 600.0, .probe = 600.0};
    void open(const Setting& setting);
    Result<LoadedModel> shipped() const;

    // Actions of the console.
    void arm();
    /// Explores until a probe is proposed.
    void explore();
    void exploreWithoutProbe();  ///< explores up to an estimate that offers no probe
    /// Approves the proposal without the hold.
    void approve();
    bool reaches(AtemPhase phase);
    void press(int key, Qt::KeyboardModifiers with = {});
    /// Holds the button with its key, takes the picture at half of the hold, and keeps holding.
    void holdAtHalf(HoldToConfirmButton& button, Qt::Key key, std::string_view name,
                    const QStringList& says);
    ConsoleWindow& window() const;
    /// Opens windows without a robot.
    void openReview();
    void openScenes();
    /// Ignores a recorded text, which keeps the language of its recording.
    void unsay(const QString& recorded);

    std::set<std::string> said;  ///< all texts in the pictures of this language
    RobotModel model = absolem();
    PatientClock clock;
    MemoryBus bus{[this] { return clock.now(); }};
    std::unique_ptr<PanelBoard> board;  ///< set if there is a panel
    GamepadDesk desk;                   ///< controls of the gamepad
    std::unique_ptr<StagedRobot> robot;
    std::unique_ptr<MainWindow> console;
    std::unique_ptr<ReviewWindow> review;      ///< pictured if there is no console
    std::unique_ptr<ScenesWindow> scenes;      ///< pictured if there is neither console nor review
    std::string modelFile = "default.ttm";     ///< the shipped model that open() loads
    std::atomic<bool> holdsEstimates = false;  ///< following estimates stop half-way
    /// Alters following estimates; empty: no change.
    void alterEstimates(std::function<void(TerrainEstimate&)> how);

private:
    ModelLoader altered();
    void close();
    void poll(std::string_view name, const QStringList& says, QWidget* above = nullptr);
    void show(ConsoleWindow& opened);
    QImage paintedWindow() const;
    void save(const QImage& image, std::string_view name);
    void compareWithEnglish();

    const Chapter& chapter_;
    std::string language_;
    std::set<std::string> english_;
    std::multiset<std::string_view> taken_;  ///< pictures taken in this language
    std::unique_ptr<TemporaryDirectory> sessions_;
    std::mutex mutex_;  ///< guards alters_
    std::function<void(TerrainEstimate&)> alters_;
};

}  // namespace terratact
