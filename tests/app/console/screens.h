#pragma once

#include <gtest/gtest.h>

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
#include "app/runtime/steady_now.h"
#include "drivers/memory_bus.h"
#include "tests/support/absolem.h"
#include "tests/support/panel_board.h"
#include "tests/support/staged_robot.h"
#include "tests/support/temporary_directory.h"

namespace terratact {

class HoldToConfirmButton;

/// The pictures of one test, which has the chapter's name.
struct Chapter {
    std::string_view name;
    std::vector<std::string_view> pictures;
};

/// Every state of the console, in the order in which a mission meets them.
const std::vector<Chapter>& chapters();

/// "04-03_hold_to_approve_at_half": chapter, place in it, name.  Empty where no chapter has the picture.
QString pictureFile(std::string_view name);

/// The real windows, with a simulated robot on a bus, that a test puts into one state after the other and takes a
/// picture of each.  In every language; in English first, of which no text may be found in the others.
struct Screens : testing::Test {
    Screens();
    ~Screens() override;

    /// Runs `tour` in each language (TERRATACT_LANGUAGE: in that alone), which has to take every picture of the test's
    /// chapter.
    void inEveryLanguage(const std::function<void()>& tour);

    /// Takes the picture once it can be read in the window what it is to show: each of `says`, in which %1 stands for
    /// anything.  No text may be cut, no widget lie upon another, and STOP must be there.
    void picture(std::string_view name, const QStringList& says);
    /// The same with another window, which may say some of it, or what hides others on purpose, upon it.
    void pictureWith(QWidget& above, std::string_view name, const QStringList& says);
    /// The same with the button's menu, which says each of `says`.
    void pictureOfMenu(QPushButton& button, std::string_view name, const QStringList& says);
    bool reads(const QString& text) const;  ///< somewhere in the window

    /// How a console is opened.
    struct Setting {
        ModelLoader model{};  ///< empty: the shipped one, of which the test may alter the estimates
        double before = 0.6;  ///< [m] the robot stands before the step
        bool isPressed = false;  ///< its flippers are, from the start
        CanSource::Mode mode = CanSource::Mode::Transmit;
        std::string busName = "can0";
        double linkLostAfter = 3.0;  ///< [s]; this machine may be busy
        AtemLimits limits = kPatient;
        bool hasPanel = false;
        bool safeMode = false;
        std::string sessions{};  ///< folder of recordings; empty: one of the test's own
        Staging staging{};
    };
    static constexpr AtemLimits kPatient{
        .halt = 600.0, .press = 600.0, .estimate = 600.0, .approval = 600.0, .probe = 600.0};
    void open(const Setting& setting);
    Result<LoadedModel> shipped() const;

    // Of the console.
    void arm();
    /// Until a probe is proposed, once more where a busy machine has let a link become bad.
    void explore();
    /// Approves what is proposed, without the hold.
    void approve();
    bool reaches(AtemPhase phase);
    void press(int key, Qt::KeyboardModifiers with = {});
    /// Holds the button by its key until half of the hold has passed, and takes the picture; it is still held then.
    void holdAtHalf(HoldToConfirmButton& button, Qt::Key key, std::string_view name,
                    const QStringList& says);
    ConsoleWindow& window() const;
    /// Opens the windows that have no robot.
    void openReview();
    void openScenes();
    /// What was recorded is in the language of then.
    void unsay(const QString& recorded);

    std::set<std::string> said;  ///< in all pictures of the language so far
    RobotModel model = absolem();
    MemoryBus bus{steadyNow};
    std::unique_ptr<PanelBoard> board;  ///< where there is a panel
    std::unique_ptr<StagedRobot> robot;
    std::unique_ptr<MainWindow> console;
    std::unique_ptr<ReviewWindow> review;      ///< seen where there is no console
    std::unique_ptr<ScenesWindow> scenes;      ///< seen where there is neither
    std::atomic<bool> holdsEstimates = false;  ///< the next ones stop in their middle
    void alterEstimates(std::function<void(TerrainEstimate&)> how);  ///< from now on; empty: not

private:
    ModelLoader altered();
    void close();
    void poll(std::string_view name, const QStringList& says, QWidget* above = nullptr);
    void show(ConsoleWindow& opened);
    void save(const QImage& image, std::string_view name);
    void compareWithEnglish();

    const Chapter& chapter_;
    std::string language_;
    std::set<std::string> english_;
    std::multiset<std::string_view> taken_;  ///< in this language
    std::unique_ptr<TemporaryDirectory> sessions_;
    std::mutex mutex_;  ///< guards alters_
    std::function<void(TerrainEstimate&)> alters_;
};

}  // namespace terratact
