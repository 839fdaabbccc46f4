// Tests that nothing an operator opens blocks the console.
#include <gtest/gtest.h>

#include <QAction>
#include <QApplication>
#include <QFileDialog>
#include <QLineEdit>
#include <QMenu>
#include <QPointer>
#include <QPushButton>
#include <QTimer>
#include <set>
#include <string>

#include "tests/support/benches/robot_on_bench.h"
#include "tests/support/estimates.h"
#include "tests/support/gui.h"
#include "tests/support/temporary_directory.h"
#include "widgets/base/navigation_rail.h"
#include "widgets/base/theme.h"
#include "widgets/control/status_header.h"

namespace terratact {
namespace {

/// Finds modal windows from inside any event loop and closes them, so that their loop ends.
class ModalWatch final : public QObject {
public:
    ModalWatch()
    {
        connect(&timer_, &QTimer::timeout, this, &ModalWatch::poll);
        timer_.start(5);
    }
    void poll()
    {
        if (QWidget* menu = QApplication::activePopupWidget())
            menu->close();  // a menu would block, too
        QWidget* const modal = QApplication::activeModalWidget();
        if (!modal) return;
        seen.insert(modal->metaObject()->className()
                    + (" “" + modal->windowTitle().toStdString() + "” after ") + after);
        modal->close();
    }
    std::set<std::string> seen;
    std::string after;  ///< name of the last action

private:
    QTimer timer_;
};

struct Modeless : testing::Test, RobotOnBench {
    Modeless()
    {
        applyLook(*qApp);
        startRobot();
        recorder = std::make_shared<SessionRecorder>(SessionRecorder::Options{
            .folder = directory.file("sessions"), .start = {}, .patience = kBusyDisk});
        MainWindow::Options options =
            linked({.mode = CanSource::Mode::Transmit,
                    .received = [to = recorder](auto frames) { to->add(frames); }});
        options.model = [] {
            const auto estimate = [](const EstimateRequest&, const Watch&) {
                return equalSides(stepEstimate());
            };
            return Result<LoadedModel>({.estimate = estimate, .name = "fake.ttm", .details = {}});
        };
        options.recorder = recorder;
        window = std::make_unique<MainWindow>(std::move(options));
        window->resize(1440, 900);
        gui::showActive(*window);
    }
    ~Modeless() override
    {
        window.reset();
        applyLook(*qApp);
    }

    /// Returns guarded pointers, because an action may delete some of the objects.
    template <class Object>
    static QList<QPointer<Object>> guarded(const QList<Object*>& objects)
    {
        return {objects.begin(), objects.end()};
    }
    void trigger(const QList<QAction*>& actions, const std::string& where)
    {
        for (const QPointer<QAction>& action : guarded(actions)) {
            if (!action || !action->isEnabled()) continue;
            const std::string name = where + action->text().toStdString();
            action->trigger();
            settle(name);
        }
    }
    /// After an action: checks, cancels file dialogs with an invalid file, and closes opened windows.
    void settle(const std::string& what)
    {
        watch.after = what;
        watch.poll();
        QApplication::processEvents();
        for (const QPointer<QWidget>& opened : guarded(QApplication::topLevelWidgets())) {
            if (!opened || opened == window.get() || !opened->isVisible()) continue;
            ++opens;
            // "Open" would start this program again with the chosen file.
            auto* const name = opened->findChild<QLineEdit*>("fileNameEdit");
            if (name && opened->windowTitle() != "Open") {
                ++files;
                name->setText(QString::fromStdString(garbage));
                QTest::keyClick(name, Qt::Key_Return);
                QApplication::processEvents();
            }
            watch.poll();
            if (opened) opened->close();
        }
        watch.poll();
    }
    void press(QAbstractButton& button)
    {
        const std::string name = "a click on “" + button.text().toStdString() + "” ("
                               + button.accessibleName().toStdString() + ")";
        auto* const pushes = qobject_cast<QPushButton*>(&button);
        if (pushes && pushes->menu()) {
            emit pushes->menu()->aboutToShow();
            trigger(pushes->menu()->actions(), name + ": ");
            return;
        }
        button.click();
        settle(name);
    }
    /// Presses every enabled button of a page that was not pressed yet.
    void pressAllOf(int page)
    {
        for (const auto& button : guarded(window->findChildren<QAbstractButton*>())) {
            window->rail()->choose(page);  // another button may have changed the page
            if (button && button->isVisible() && button->isEnabled()
                && pressed.insert(button).second)
                press(*button);
        }
    }

    TemporaryDirectory directory;
    std::string garbage = directory.write("garbage", "this is no file of any kind\n");
    std::shared_ptr<SessionRecorder> recorder;
    std::unique_ptr<MainWindow> window;
    ModalWatch watch;
    std::set<const QAbstractButton*> pressed;
    int opens = 0, files = 0;
};

using Seen = std::set<std::string>;

TEST_F(Modeless, noButtonOpensAModalWindow)
{
    ASSERT_TRUE(gui::eventually([&] { return window->exploration().linkAlive(); }));
    for (int page = 0; page < window->rail()->pages(); ++page) {
        window->rail()->choose(page);
        QApplication::processEvents();
        pressAllOf(page);
    }
    trigger(window->findChildren<QAction*>(), "the action ");
    EXPECT_EQ(watch.seen, Seen());
    EXPECT_GT(pressed.size(), 30U);
    EXPECT_GE(files, 5) << "model, robot, DBC, scenes to learn from and to test on";
}

TEST_F(Modeless, noKeyOpensAModalWindow)
{
    ASSERT_TRUE(gui::eventually([&] { return window->exploration().linkAlive(); }));
    QList<QKeyCombination> keys;
    for (int key = Qt::Key_F1; key <= Qt::Key_F12; ++key) keys << QKeyCombination(Qt::Key(key));
    for (int key = Qt::Key_A; key <= Qt::Key_Z; ++key)
        for (const Qt::KeyboardModifier with : {Qt::NoModifier, Qt::ControlModifier})
            keys << QKeyCombination(with, Qt::Key(key));
    for (const Qt::Key key : {Qt::Key_1, Qt::Key_Space, Qt::Key_Return, Qt::Key_Escape,
                              Qt::Key_Question, Qt::Key_PageUp, Qt::Key_Delete, Qt::Key_Plus})
        keys << QKeyCombination(key);
    for (int page = 0; page < window->rail()->pages(); ++page)
        for (const QKeyCombination key : keys) {
            window->rail()->choose(page);
            QTest::keyClick(window.get(), key.key(), key.keyboardModifiers());
            settle("the key " + QKeySequence(key).toString().toStdString());
        }
    EXPECT_EQ(watch.seen, Seen());
    EXPECT_GE(opens, 2) << "the sheet of keys, what Ctrl+O asks";
}

TEST_F(Modeless, neitherTroubleNorTheEndAsksBeforeAllElse)
{
    ASSERT_TRUE(gui::eventually([&] { return window->exploration().linkAlive(); }));
    watch.after = "a bus that is down";
    bus.setState(BusState::Down, "can0");
    EXPECT_TRUE(gui::eventually([&] { return !window->exploration().linkAlive(); }));
    bus.setState(BusState::Up, "can0");
    EXPECT_TRUE(gui::eventually([&] { return window->exploration().linkAlive(); }));
    watch.after = "a robot that is gone";
    robot.reset();
    EXPECT_TRUE(gui::eventually([&] { return !window->exploration().linkAlive(); }));
    watch.after = "closing while it records";
    window->close();
    EXPECT_FALSE(window->isVisible());
    EXPECT_EQ(watch.seen, Seen());
}

}  // namespace
}  // namespace terratact
