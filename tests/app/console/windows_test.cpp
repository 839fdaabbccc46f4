// Tests every secondary window: it is not modal, and STOP works while it has the focus.
#include <gtest/gtest.h>
#include <unistd.h>

#include <QApplication>
#include <QClipboard>
#include <QFileDialog>
#include <QMenu>
#include <QPointer>
#include <QPushButton>
#include <filesystem>
#include <functional>
#include <memory>
#include <set>
#include <string>

#include "app/console/main_window.h"
#include "app/display/format.h"
#include "app/review/export/review_export_dialog.h"
#include "app/review/review_window.h"
#include "app/review/scenes_window.h"
#include "app/runtime/steady_now.h"
#include "app/sessions/session_browser.h"
#include "app/shell/about.h"
#include "app/shell/open_file.h"
#include "app/shell/text_sheet.h"
#include "core/atem/panel.h"
#include "drivers/memory_bus.h"
#include "tests/support/gui.h"
#include "tests/support/scripted_source.h"
#include "tests/support/sessions/robot_session.h"
#include "tests/support/temporary_directory.h"
#include "widgets/base/held_button.h"
#include "widgets/base/navigation_rail.h"
#include "widgets/base/theme.h"
#include "widgets/base/tips.h"
#include "widgets/control/status_header.h"
#include "widgets/signals/event_list.h"

namespace terratact {
namespace {

using namespace gui;

/// The receiving end of the STOP line of an opening console.
struct OpeningConsole {
    OpeningConsole()
    {
        static int lines = 0;
        const std::string name =
            "terratact-windows-test-" + std::to_string(::getpid()) + "-" + std::to_string(++lines);
        qputenv(kStopLineVariable, QByteArray::fromStdString(name));
        auto listens = StopLine::listen(name);
        if (listens) line.emplace(std::move(*listens));
    }
    ~OpeningConsole() { qunsetenv(kStopLineVariable); }
    bool wasStopped() { return line && line->consume(); }

    std::optional<StopLine> line;
};

struct Windows : testing::Test {
    static void SetUpTestSuite()
    {
        QApplication::setApplicationVersion("9.8.7");
        applyLook(*qApp);
    }
    std::unique_ptr<MainWindow> console(std::unique_ptr<MeasurementSource> source,
                                        CanSource* link = nullptr)
    {
        MainWindow::Options options;
        options.robot = absolem();
        options.source = std::move(source);
        options.link = link;
        options.model = []() -> Result<LoadedModel> { return Error{"no model", 2}; };
        options.exploration.linkLostAfter = options.exploration.staleAfter = 3.0;
        SessionRecorder::Options recording;
        recording.folder = directory.file("sessions");
        recording.patience = kBusyDisk;
        options.recorder = std::make_shared<SessionRecorder>(std::move(recording));
        auto window = std::make_unique<MainWindow>(std::move(options));
        QObject::connect(&window->exploration(), &Exploration::decided, window.get(),
                         [this](const char* what) { stops += std::string_view(what) == "stop"; });
        showActive(*window);
        return window;
    }
    std::unique_ptr<MainWindow> scripted() { return console(std::make_unique<ScriptedSource>()); }
    std::unique_ptr<ReviewWindow> review()
    {
        const std::string path = directory.file("review.tts");
        if (auto writer = robotSession(path, 1.0); !writer || !writer->seal()) return nullptr;
        auto session = SessionReader::open(path);
        if (!session) return nullptr;
        auto window = std::make_unique<ReviewWindow>(
            ReviewWindow::Options{.session = std::move(*session), .robot = absolem()});
        showActive(*window);
        return window;
    }
    std::unique_ptr<ScenesWindow> scenes()
    {
        auto window = std::make_unique<ScenesWindow>(
            ScenesWindow::Options{.path = "/some/scenes.csv",
                                  .scenes = std::vector<TwoTrackScene>(1),
                                  .robot = absolem(),
                                  .model = []() -> Result<LoadedModel> {
                                      return Error{"no model", 2};
                                  }});
        showActive(*window);
        return window;
    }
    /// Presses STOP with the mouse through the desktop's window.
    static void pressStop(ConsoleWindow& window)
    {
        const QPushButton& stop = *window.header()->stopButton();
        QTest::mousePress(window.windowHandle(), Qt::LeftButton, {},
                          stop.mapTo(&window, stop.rect().center()));
    }
    static void letGo(ConsoleWindow& window)
    {
        const QPushButton& stop = *window.header()->stopButton();
        QTest::mouseRelease(window.windowHandle(), Qt::LeftButton, {},
                            stop.mapTo(&window, stop.rect().center()));
    }

    /// Presses every button on every page and every entry of the help menu. STOP keys must work in each opened window.
    /// Returns the names of those windows.
    static std::set<std::string> stopsInEveryWindow(ConsoleWindow& window,
                                                    const std::function<bool()>& wasStopped)
    {
        std::set<std::string> names;
        const auto opened = [&window]() -> QWidget* {
            for (QWidget* other : QApplication::topLevelWidgets())
                if (other->isVisible() && other != &window) return other;
            return nullptr;
        };
        const auto poll = [&](const std::string& by) {
            while (const QPointer<QWidget> other = opened()) {
                const std::string name = other->windowTitle().toStdString();
                names.insert(name);
                EXPECT_TRUE(QTest::qWaitForWindowExposed(other)) << by;
                EXPECT_EQ(QApplication::activeModalWidget(), nullptr) << by;
                (void)wasStopped();
                const QPointer<QWidget> focus =
                    other->focusWidget() ? other->focusWidget() : other.data();
                for (const Qt::Key key : gui::kStopKeys) {
                    QTest::keyClick(focus, key);
                    EXPECT_TRUE(wasStopped()) << name << ", by " << by << ", " << key;
                }
                if (focus) QTest::keyClick(focus, Qt::Key_Escape);
                EXPECT_TRUE(eventually([&] { return !other || !other->isVisible(); }))
                    << name << ", by " << by << ": Esc closes it";
                if (other) other->hide();
            }
        };
        for (int page = 0; page < window.rail()->pages(); ++page) {
            QList<QPointer<QPushButton>> buttons;  // some pages rebuild their buttons
            for (QPushButton* button : window.findChildren<QPushButton*>())
                if (button->window() == &window && !qobject_cast<HeldButton*>(button)
                    && !button->menu() && button != window.header()->stopButton()
                    && button->property("role") != QLatin1String("page"))
                    buttons << button;
            for (const QPointer<QPushButton>& button : std::as_const(buttons)) {
                window.rail()->choose(page);  // another button may have changed the page
                if (!button || !button->isVisible() || !button->isEnabled()) continue;
                const std::string name = button->text().toStdString();
                QTest::mouseClick(button, Qt::LeftButton);
                poll(name);
            }
        }
        QPushButton* const help = window.findChild<QPushButton*>(QStringLiteral("help"));
        EXPECT_TRUE(help && help->menu());
        for (QAction* action : help->menu()->actions()) {
            help->menu()->popup({});
            for (const Qt::Key key : gui::kStopKeys) {
                QTest::keyClick(help->menu(), key);
                EXPECT_TRUE(wasStopped()) << "over a menu, " << key;
            }
            help->menu()->close();
            action->trigger();
            poll(action->text().toStdString());
        }
        return names;
    }

    TemporaryDirectory directory;
    int stops = 0;
};

TEST_F(Windows, aboutNamesTheProgramAndItsAuthors)
{
    const auto window = scripted();
    QTest::keyClick(window.get(), Qt::Key_F1, Qt::ControlModifier);
    auto* about = window->findChild<TextSheet*>();
    ASSERT_TRUE(about && QTest::qWaitForWindowExposed(about));
    EXPECT_FALSE(about->isModal());
    for (const char* words : {"Terratact 9.8.7", "rescue robot", "MIT", kQwtCredit,
                              "http://qwt.sf.net", qVersion(), "LGPL", "Eigen", "SQLite"})
        EXPECT_TRUE(about->plainText().contains(words)) << words;
    EXPECT_EQ(cramped(*about), std::vector<std::string>());
    EXPECT_FALSE(about->frameGeometry().intersects(
        {window->header()->mapToGlobal(QPoint(0, 0)), window->header()->size()}));
    QApplication::clipboard()->clear();
    while (!about->copyButton()->hasFocus()) QTest::keyClick(about->focusWidget(), Qt::Key_Tab);
    QTest::keyClick(about->focusWidget(), Qt::Key_Space);
    EXPECT_EQ(QApplication::clipboard()->text(), about->plainText());
    QTest::keyClick(about->focusWidget(), Qt::Key_Escape);
    EXPECT_FALSE(about->isVisible());

    QTest::keyClick(window.get(), Qt::Key_F1);
    const auto sheets = window->findChildren<TextSheet*>();
    ASSERT_EQ(sheets.size(), 2);
    EXPECT_TRUE(sheets.last()->plainText().contains(aboutLine())) << "below the keys, too";
}

TEST_F(Windows, showTextsOfFilesAsTheyAre)
{
    const auto window = scripted();
    QTest::keyClick(window.get(), Qt::Key_F1);
    for (const QLabel* label : window->findChildren<QLabel*>())
        EXPECT_TRUE(label->textFormat() == Qt::PlainText || label->window() != window.get())
            << label->metaObject()->className() << ": " << label->text().toStdString();
    for (const QWidget* widget : window->findChildren<QWidget*>())
        EXPECT_TRUE(!Qt::mightBeRichText(widget->toolTip())
                    || widget->toolTip() == plainTip(tipOf(*widget)))
            << widget->toolTip().toStdString();
}

/// A window with only the help button.
struct HelpingWindow : ConsoleWindow {
    explicit HelpingWindow(const QStringList& sessions)
    {
        addHelpTool(sessions, [this](const QString& path) { opened = path; });
    }
    QString opened;
};

QAction* demonstrationIn(const ConsoleWindow& window,
                         const QString& title = "Recorded demonstration")
{
    const auto* help = window.findChild<QPushButton*>(QStringLiteral("help"));
    for (QAction* action : help->menu()->actions())
        if (action->text() == title) return action;
    return nullptr;
}

TEST_F(Windows, ofTheConsoleOfferTheRecordedDemonstrationWhereItIs)
{
    const QStringList titles{"Recorded demonstration", "Recorded demonstration, two tracks"};
    ASSERT_EQ(demonstrations().size(), 2);
    for (int k = 0; k < 2; ++k) {
        EXPECT_EQ(kindOfFile(demonstrations()[k]), FileKind::Session);
        EXPECT_TRUE(demonstrationIn(*scripted(), titles[k]));
        HelpingWindow window(demonstrations());
        ASSERT_TRUE(demonstrationIn(window, titles[k]));
        demonstrationIn(window, titles[k])->trigger();
        EXPECT_EQ(window.opened, demonstrations()[k]);
    }
    const HelpingWindow without({"/nowhere/demo.tts", "/nowhere/two_tracks.tts"});
    for (const QString& title : titles) EXPECT_FALSE(demonstrationIn(without, title));
}

TEST_F(Windows, ofAConsoleLetStopThrough)
{
    const auto window = scripted();
    ASSERT_TRUE(eventually([&] { return window->exploration().linkAlive(); }));
    const auto names = stopsInEveryWindow(*window, [this] { return std::exchange(stops, 0) > 0; });
    for (const char* name : {"Keys", "About Terratact", "Recordings", "Model", "Robot"})
        EXPECT_EQ(names.count(name), 1U) << name;
    EXPECT_GE(names.size(), 7U) << "with those of the pages Signals and Training";
}

TEST_F(Windows, ofAReviewLetStopThroughToTheConsoleThatOpenedIt)
{
    OpeningConsole opening;
    const auto window = review();
    ASSERT_TRUE(window);
    const auto names = stopsInEveryWindow(*window, [&] { return opening.wasStopped(); });
    for (const char* name : {"Keys", "About Terratact", "Recordings", "Export — review.tts"})
        EXPECT_EQ(names.count(name), 1U) << name;
}

TEST_F(Windows, ofScenesLetStopThroughToTheConsoleThatOpenedThem)
{
    OpeningConsole opening;
    const auto window = scenes();
    const auto names = stopsInEveryWindow(*window, [&] { return opening.wasStopped(); });
    EXPECT_EQ(names, (std::set<std::string>{"Keys", "About Terratact"}));
}

TEST_F(Windows, thatAConsoleHasOpenedStopItsRobotByTheMouse)
{
    OpeningConsole opening;
    const auto reviewed = review();
    ASSERT_TRUE(reviewed);
    const auto seen = scenes();
    for (ConsoleWindow* window :
         std::initializer_list<ConsoleWindow*>{reviewed.get(), seen.get()}) {
        const std::string title = window->windowTitle().toStdString();
        ASSERT_TRUE(window->header()->stopButton()->isVisible()) << title;
        EXPECT_EQ(window->header()->stopButton()->text(), "STOP (F12)");
        for (const char* time : {"once", "again, beside what is said of the first"}) {
            pressStop(*window);
            EXPECT_TRUE(opening.wasStopped()) << title << " before it is let go, " << time;
            letGo(*window);
            EXPECT_FALSE(opening.wasStopped()) << title << ": one press, one STOP";
        }
        QPushButton* const help = window->findChild<QPushButton*>(QStringLiteral("help"));
        help->menu()->popup(window->mapToGlobal(QPoint(20, 300)));
        const QPushButton& stop = *window->header()->stopButton();
        QTest::mousePress(help->menu(), Qt::LeftButton, {},
                          help->menu()->mapFromGlobal(stop.mapToGlobal(stop.rect().center())));
        EXPECT_TRUE(opening.wasStopped()) << title << ", beside a menu that is open";
        EXPECT_FALSE(help->menu()->isVisible());
    }
}

TEST_F(Windows, withoutAnOpeningConsoleHaveNoStopButton)
{
    EXPECT_FALSE(review()->header()->stopButton()->isVisible());
    EXPECT_FALSE(scenes()->header()->stopButton()->isVisible());
}

TEST_F(Windows, ofAListeningConsoleStopTheOpenersRobot)
{
    MemoryBus bus{steadyNow};
    const auto listening = [&] {
        auto source = std::make_unique<CanSource>(
            bus.join("can0"), absolem(), CanSource::Options{.mode = CanSource::Mode::Listen});
        CanSource* const link = source.get();
        return console(std::move(source), link);
    };
    {
        const auto alone = listening();
        EXPECT_EQ(alone->header()->stopButton()->text(), "STOP: no commands");
    }
    OpeningConsole opening;
    const auto window = listening();
    EXPECT_EQ(window->header()->stopButton()->text(), "STOP (F12)");
    pressStop(*window);
    EXPECT_TRUE(opening.wasStopped());
    letGo(*window);
    const auto isKept = [&](const QString& words) {
        return !window->events()->findItems(words, Qt::MatchContains).empty();
    };
    EXPECT_TRUE(isKept("STOP SENT to the console that opened this window"));
    EXPECT_TRUE(eventually([&] { return isKept("has received it"); }));
}

TEST_F(Windows, browserAndFileDialogStartInTheSessionFolder)
{
    const auto window = scripted();
    const std::string sessions = directory.file("sessions");
    ASSERT_TRUE(eventually([&] { return std::filesystem::is_directory(sessions); }));
    QTest::keyClick(window.get(), Qt::Key_O, Qt::ControlModifier);
    auto* const browser = window->findChild<SessionBrowser*>();
    ASSERT_TRUE(browser && QTest::qWaitForWindowExposed(browser));
    EXPECT_EQ(browser->folder().toStdString(), sessions);
    QTest::mouseClick(browser->otherButton(), Qt::LeftButton);
    auto* const dialog = window->findChild<QFileDialog*>();
    ASSERT_TRUE(dialog && QTest::qWaitForWindowExposed(dialog));
    EXPECT_EQ(dialog->directory().absolutePath().toStdString(), sessions);
    dialog->reject();  // the chosen file would start this program again
}

}  // namespace
}  // namespace terratact
