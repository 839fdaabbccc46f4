// Tests that profiles and imported settings change nothing before they are applied, and nothing of an armed robot.
#include "app/console/settings_files_window.h"

#include <gtest/gtest.h>

#include <QFileDialog>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QTableWidget>

#include "core/store/file_read.h"
#include "tests/support/benches/arming.h"
#include "tests/support/benches/robot_on_bench.h"
#include "tests/support/gui.h"
#include "tests/support/own_documents.h"
#include "tests/support/temporary_directory.h"
#include "widgets/base/theme.h"
#include "widgets/control/drive_pad.h"

namespace terratact {
namespace {

using gui::eventually;

struct SettingsFilesBench : testing::Test {
    SettingsFilesBench()
        : store({{}, {}, QString::fromStdString(directory.file("console.ini"))}, {}),
          window(store, {.folder = QString::fromStdString(directory.file("profiles")),
                         .whyNot = [this] { return whyNot; }})
    {
        applyLook(*qApp);
        gui::showActive(window);
    }
    void setLimit(double metres)
    {
        store.change([metres](Preferences& p) { p.obstacleLimit = metres; });
    }
    double limit() const { return store.current().obstacleLimit; }
    void save(const QString& name)
    {
        window.nameField()->setText(name);
        window.saveButton()->click();
    }
    /// Chooses a profile with the keyboard.
    void choose(int row)
    {
        window.list()->setFocus();
        window.list()->setCurrentRow(row);
    }
    /// Presses again until it acts: an early second press is a double click and counts for nothing.
    template <class Condition>
    static bool pressesUntil(QPushButton* button, Condition done)
    {
        return eventually([&] {
            button->click();
            return done();
        });
    }

    TemporaryDirectory directory;
    std::optional<Message> whyNot;
    PreferenceStore store;
    SettingsFilesWindow window;
};

TEST_F(SettingsFilesBench, switchesBetweenProfilesAfterTheListOfChanges)
{
    save("robot A/night");
    setLimit(0.2);
    save("robot A/day");
    ASSERT_EQ(window.list()->count(), 2);
    choose(1);
    QTest::keyClick(window.list(), Qt::Key_Return);
    ASSERT_EQ(window.changes()->rowCount(), 1) << window.result().toStdString();
    EXPECT_EQ(limit(), 0.2) << "nothing changes before Apply";
    EXPECT_EQ(window.changes()->item(0, 0)->text(), "safety: step limit");
    EXPECT_EQ(window.changes()->item(0, 1)->text(), "0.2 m");
    EXPECT_EQ(window.changes()->item(0, 2)->text(), "0.1 m");
    EXPECT_TRUE(gui::textsOf(window).contains("Safety-relevant: step limit: #.# m → #.# m"));
    EXPECT_EQ(window.applyButton()->text(), "Apply, safety-relevant changes too");
    QTest::keyClick(window.applyButton(), Qt::Key_Space);
    EXPECT_EQ(limit(), 0.1);
    EXPECT_FALSE(window.applyButton()->isVisible());
}

TEST_F(SettingsFilesBench, leavesAllAsItIs)
{
    save("a");
    setLimit(0.2);
    choose(0);
    window.switchButton()->click();
    window.dropButton()->click();
    EXPECT_EQ(limit(), 0.2);
    EXPECT_FALSE(window.applyButton()->isVisible());
}

TEST_F(SettingsFilesBench, doesNothingWhileTheRobotIsArmed)
{
    save("a");
    setLimit(0.2);
    choose(0);
    window.switchButton()->click();
    whyNot = Message::verbatim("The robot is armed");  // armed since
    window.applyButton()->click();
    EXPECT_EQ(limit(), 0.2);
    EXPECT_EQ(window.result(), "Not applied: The robot is armed");
    EXPECT_FALSE(window.switchButton()->isEnabled());
    EXPECT_EQ(window.switchButton()->toolTip(), "The robot is armed");
    whyNot.reset();
    EXPECT_TRUE(eventually([&] { return window.applyButton()->isEnabled(); }));
}

TEST_F(SettingsFilesBench, replacesAndDeletesAfterASecondPress)
{
    save("a");
    const std::string file = directory.file("profiles/a.settings");
    const std::string before = *readFile(file, 1U << 20U);
    setLimit(0.2);
    window.nameField()->setText("a");
    EXPECT_FALSE(window.saveButton()->isVisible());
    window.replaceButton()->click();
    EXPECT_EQ(*readFile(file, 1U << 20U), before);
    EXPECT_TRUE(
        pressesUntil(window.replaceButton(), [&] { return *readFile(file, 1U << 20U) != before; }));
    choose(0);
    window.deleteButton()->click();
    EXPECT_EQ(window.list()->count(), 1);
    EXPECT_TRUE(pressesUntil(window.deleteButton(), [&] { return window.list()->count() == 0; }));
}

TEST_F(SettingsFilesBench, aSecondPressIsForTheSameProfile)
{
    save("a");
    save("b");
    const auto asks = [](const QPushButton* button) {
        return button->text().startsWith("Press again");
    };
    choose(0);
    window.deleteButton()->click();
    window.replaceButton()->click();
    ASSERT_TRUE(asks(window.deleteButton()));
    ASSERT_TRUE(asks(window.replaceButton()));
    choose(1);
    EXPECT_FALSE(asks(window.deleteButton()));
    EXPECT_FALSE(asks(window.replaceButton()));
    window.replaceButton()->click();
    window.nameField()->setText("a");
    EXPECT_FALSE(asks(window.replaceButton()));
}

TEST_F(SettingsFilesBench, exportsOnceAndImportsWhatChanges)
{
    const QString file = QString::fromStdString(directory.file("x.settings"));
    window.exportTo(file);
    EXPECT_EQ(window.result(), "Written: " + file);
    window.exportTo(file);
    EXPECT_TRUE(window.result().contains("was not replaced")) << window.result().toStdString();
    window.propose(file, "x.settings");
    EXPECT_TRUE(window.result().contains("changes nothing")) << window.result().toStdString();
    window.exportTo(QString::fromStdString(directory.file("y.settings")));
    setLimit(0.3);
    EXPECT_EQ(window.result(), "") << "the file does not hold these settings";
    window.propose(file, "x.settings");
    EXPECT_EQ(window.changes()->rowCount(), 1);
}

TEST_F(SettingsFilesBench, exportsAndImportsAreSoughtInTheDocuments)
{
    const OwnDocuments documents(directory.file("home"));
    for (const char* text : {"Export to a file …", "Import a file …"}) {
        for (QPushButton* const button : window.findChildren<QPushButton*>())
            if (button->text() == QString::fromUtf8(text)) button->click();
        auto* const dialog = window.findChild<QFileDialog*>();
        ASSERT_TRUE(dialog) << text;
        EXPECT_EQ(dialog->directory().absolutePath(), documents.folder()) << text;
        dialog->reject();
        ASSERT_TRUE(eventually([&] { return !window.findChild<QFileDialog*>(); }));
    }
}

TEST_F(SettingsFilesBench, refusesABrokenFileWithItsLine)
{
    const QString file = QString::fromStdString(
        directory.write("x.settings", "terratact-settings = 1\nobstacle-limit = much\n"));
    window.propose(file, "x.settings");
    EXPECT_TRUE(window.result().contains("line 2: “much” is no valid obstacle-limit"))
        << window.result().toStdString();
    EXPECT_FALSE(window.applyButton()->isVisible());
}

TEST_F(SettingsFilesBench, everyControlIsNamedAndReachedByTab)
{
    setLimit(0.2);
    save("a");
    setLimit(0.3);
    choose(0);
    window.switchButton()->click();
    std::set<QWidget*> reached;
    window.list()->setFocus();
    for (int i = 0; i < 30; ++i) {
        reached.insert(window.focusWidget());
        QTest::keyClick(window.focusWidget(), Qt::Key_Tab);
    }
    for (QWidget* const control : std::initializer_list<QWidget*>{
             window.list(), window.switchButton(), window.deleteButton(), window.nameField(),
             window.replaceButton(), window.changes(), window.applyButton(), window.dropButton()})
        EXPECT_TRUE(reached.contains(control)) << control->metaObject()->className();
    EXPECT_FALSE(window.list()->accessibleName().isEmpty());
    EXPECT_FALSE(window.nameField()->accessibleName().isEmpty());
}

struct SettingsFilesConsole : testing::Test, RobotOnBench {};

TEST_F(SettingsFilesConsole, opensByKeyAndIsRefusedForAnArmedRobot)
{
    applyLook(*qApp);
    startRobot();
    auto console = std::make_unique<MainWindow>(linked({.mode = CanSource::Mode::Transmit}));
    gui::showActive(*console);
    EXPECT_EQ(console->settingsFiles(), nullptr) << "made at its first use";
    QTest::keyClick(console.get(), Qt::Key_Comma, Qt::ControlModifier);
    ASSERT_NE(console->settingsFiles(), nullptr);
    const TemporaryDirectory directory;
    const QString file = QString::fromStdString(
        directory.write("x.settings", "terratact-settings = 1\nobstacle-limit = 0.3 m\n"));
    console->settingsFiles()->propose(file, "x");
    ASSERT_TRUE(arms(*console));
    console->settingsFiles()->applyButton()->setEnabled(true);
    console->settingsFiles()->applyButton()->click();
    EXPECT_NE(console->preferences().current().obstacleLimit, 0.3);
    EXPECT_TRUE(console->settingsFiles()->result().contains("The robot is armed"))
        << console->settingsFiles()->result().toStdString();
    console->link()->disarm();
    ASSERT_TRUE(eventually([&] { return console->settingsFiles()->applyButton()->isEnabled(); }));
    console->settingsFiles()->applyButton()->click();
    EXPECT_EQ(console->preferences().current().obstacleLimit, 0.3);
}

}  // namespace
}  // namespace terratact
