// A session under review: moved in by keys, never a command, and whatever is damaged is seen to be.
#include <gtest/gtest.h>
#include <sqlite3.h>
#include <sys/resource.h>
#include <unistd.h>

#include <QComboBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QFileInfo>
#include <QLineEdit>
#include <QProgressBar>
#include <QRadioButton>
#include <QTableView>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <utility>

#include "app/estimator_worker.h"
#include "app/language.h"
#include "app/numbers_page.h"
#include "app/open_file.h"
#include "app/remote_stop.h"
#include "app/review_events_page.h"
#include "app/review_export.h"
#include "app/review_export_dialog.h"
#include "app/review_window.h"
#include "app/scenes_window.h"
#include "app/terrain_page.h"
#include "app/what_if_page.h"
#include "core/file_write.h"
#include "tests/support/gui.h"
#include "tests/support/robot_session.h"
#include "tests/support/temporary_directory.h"
#include "widgets/atem_panel.h"
#include "widgets/drive_pad.h"
#include "widgets/estimate_strip.h"
#include "widgets/force_bars.h"
#include "widgets/held_button.h"
#include "widgets/look.h"
#include "widgets/navigation_rail.h"
#include "widgets/numbers_table.h"
#include "widgets/probe_card.h"
#include "widgets/status_header.h"
#include "widgets/terrain_profile_view.h"

namespace terratact {
namespace {

using namespace gui;
using At = RobotSessionTimes;

TEST(ReviewPlayer, goesOnByDataTimeAndAPauseLeavesNothingToCatchUpWith)
{
    ReviewPlayer player;
    player.setRange(0.0, 100.0);
    player.play(false);
    player.advance(0.1);
    EXPECT_NEAR(player.position(), 0.1, 1e-12);
    player.setSpeed(50.0);
    player.advance(0.1);
    EXPECT_NEAR(player.position(), 5.1, 1e-12);
    player.advance(3600.0);  // the machine slept
    EXPECT_NEAR(player.position(), 5.1 + 50.0 * ReviewPlayer::kLongestStep, 1e-9);
    player.pause();
    const double stood = player.position();
    player.advance(1.0);
    EXPECT_EQ(player.position(), stood);
    player.setSpeed(1e9);
    EXPECT_EQ(player.speed(), ReviewPlayer::kFastest);
    player.setSpeed(0.0);
    EXPECT_EQ(player.speed(), ReviewPlayer::kSlowest);
}

TEST(ReviewPlayer, playsBackwardsLoopsAndStopsAtTheEnds)
{
    ReviewPlayer player;
    player.setRange(0.0, 1.0);
    player.seek(0.5);
    player.play(true);
    player.advance(0.2);
    EXPECT_NEAR(player.position(), 0.3, 1e-12);
    player.advance(0.2);
    player.advance(0.2);
    EXPECT_EQ(player.position(), 0.0);
    EXPECT_FALSE(player.playing());
    player.setA(0.8);
    player.setB(0.6);
    player.setLoop(true);
    player.seek(0.7);
    player.play(false);
    for (int n = 0; n < 20; ++n) {
        player.advance(0.05);
        EXPECT_GE(player.position(), 0.6);
        EXPECT_LE(player.position(), 0.8);
    }
    EXPECT_TRUE(player.playing());
    player.setLoop(false);
    player.setFollowing(true);
    for (int n = 0; n < 20; ++n) player.advance(0.1);
    EXPECT_EQ(player.position(), 1.0);
    EXPECT_TRUE(player.playing()) << "waits for more";
}

struct ReviewOf : testing::Test {
    void record(double seconds = 4.0)
    {
        auto writer = robotSession(path.toStdString(), seconds);
        ASSERT_TRUE(writer) << writer.error().text;
        ASSERT_TRUE(writer->seal());
    }
    void open(QStringList models = {})
    {
        auto session = SessionReader::open(path.toStdString());
        ASSERT_TRUE(session) << session.error().text;
        window = std::make_unique<ReviewWindow>(ReviewWindow::Options{
            .session = std::move(*session), .robot = absolem(), .models = std::move(models)});
        showActive(*window);
    }
    void press(int key, Qt::KeyboardModifiers with = {})
    {
        QTest::keyClick(window.get(), static_cast<Qt::Key>(key), with);
    }
    double now() const { return window->player().position(); }
    /// Texts without the room they need once the layout has come to rest.
    std::vector<std::string> cutWhenSettled() const
    {
        (void)eventually([this] { return cutText(*window).empty(); }, 1500);
        return cutText(*window);
    }

    TemporaryDirectory directory;
    QString path = QString::fromStdString(directory.file("review.tts"));
    std::unique_ptr<ReviewWindow> window;
};

bool saysThatStopIsDead(const QWidget& window)
{
    for (const QLabel* label : window.findChildren<QLabel*>())
        if (label->isVisible() && label->text().startsWith("STOP HAS NO EFFECT HERE")) return true;
    return false;
}

QList<QPushButton*> commandButtons(const TerrainPage& page)
{
    return {page.atemPanel()->requestButton(), page.atemPanel()->abortButton(),
            page.atemPanel()->releaseButton(), page.atemPanel()->overrideButton(),
            page.probeCard()->approveButton(), page.probeCard()->refuseButton(),
            page.drivePad()->forwardButton(),  page.drivePad()->backButton()};
}

TEST_F(ReviewOf, aSessionSaysThatItIsOneAndOffersNoCommand)
{
    record();
    open();
    EXPECT_TRUE(window->windowTitle().contains("REVIEW"));
    EXPECT_TRUE(window->windowTitle().contains("review.tts"));
    EXPECT_TRUE(window->header()->sourceName().contains("REVIEW"));
    EXPECT_TRUE(window->stateLabel()->text().contains("sealed"));
    EXPECT_FALSE(window->header()->stopButton()->isVisible());
    press(Qt::Key_F12);
    EXPECT_TRUE(saysThatStopIsDead(*window)) << "nobody may believe that it stops a robot";
    for (double t = 0.0; t <= 4.0; t += 0.25) {
        window->goTo(t);
        for (const QPushButton* button : commandButtons(*window->terrainPage()))
            EXPECT_FALSE(button->isVisible() && button->isEnabled())
                << t << " " << button->text().toStdString();
    }
}

bool saysUponTheHeader(const QWidget& window, const char* words)
{
    for (const QLabel* label : window.findChildren<QLabel*>())
        if (label->isVisible() && label->text().contains(words)) return true;
    return false;
}

TEST_F(ReviewOf, aSessionThatAConsoleHasOpenedStopsTheRobotOfThatConsole)
{
    record();
    const std::string name = "terratact-review-test-" + std::to_string(::getpid());
    qputenv(kStopLineVariable, QByteArray::fromStdString(name));
    open();
    qunsetenv(kStopLineVariable);
    auto listens = StopLine::listen(name);
    ASSERT_TRUE(listens) << listens.error().text;
    auto line = std::make_unique<StopLine>(std::move(*listens));
    press(Qt::Key_F12);
    EXPECT_TRUE(line->take());
    EXPECT_TRUE(saysUponTheHeader(*window, "STOP SENT to the console"));
    EXPECT_TRUE(eventually([&] { return saysUponTheHeader(*window, "has taken it"); }));
    press(Qt::Key_F12);  // and nobody looks
    EXPECT_TRUE(eventually([&] { return saysUponTheHeader(*window, "STOP NOT TAKEN"); }));
    line.reset();
    press(Qt::Key_F12);
    EXPECT_TRUE(saysUponTheHeader(*window, "STOP HAS NO EFFECT HERE: the console that opened"));
}

TEST_F(ReviewOf, aSessionShowsWhatTheOperatorSaw)
{
    record();
    open();
    window->goTo(At::kMarker);
    EXPECT_TRUE(window->terrainPage()->showsEstimate());
    EXPECT_TRUE(window->terrainPage()->probeCard()->asks());
    EXPECT_TRUE(window->terrainPage()->strip()->headline().contains("0.6"));
    window->goTo(At::kForgotten + 0.1);
    EXPECT_FALSE(window->terrainPage()->showsEstimate());
    window->goTo(At::kAlarm + 0.1);
    EXPECT_TRUE(window->header()->alarmsButton()->text().contains("1"));
}

TEST_F(ReviewOf, aSessionPlaysAndPausesByKeys)
{
    record();
    open();
    press(Qt::Key_Space);
    EXPECT_TRUE(window->player().playing());
    const double began = now();
    window->look(0.2);
    EXPECT_NEAR(now() - began, 0.2, 0.15);  // its own timer may have ticked
    press(Qt::Key_Space);
    EXPECT_FALSE(window->player().playing());
    const double stood = now();
    window->look(0.2);
    EXPECT_EQ(now(), stood);
    press(Qt::Key_F);
    press(Qt::Key_F);
    press(Qt::Key_H);
    EXPECT_EQ(window->player().speed(), 2.0);
    window->goTo(2.0);
    press(Qt::Key_J);
    EXPECT_TRUE(window->player().backwards());
    window->look(0.1);
    EXPECT_LT(now(), 2.0);
    press(Qt::Key_K);
    EXPECT_FALSE(window->player().playing());
}

TEST_F(ReviewOf, aSessionIsSteppedThroughByKeys)
{
    record();
    open();
    window->goTo(1.02);
    press(Qt::Key_Period);
    EXPECT_NEAR(now(), 1.05, 0.011);
    const double frame = now();
    press(Qt::Key_Period);
    press(Qt::Key_Comma);
    EXPECT_EQ(now(), frame);
    press(Qt::Key_PageDown);
    EXPECT_NEAR(now(), At::kScene, 1e-6);
    press(Qt::Key_Down);
    EXPECT_NEAR(now(), At::kProposing, 1e-6);
    press(Qt::Key_Down);
    EXPECT_NEAR(now(), At::kMarker, 1e-6);
    press(Qt::Key_Up);
    EXPECT_NEAR(now(), At::kProposing, 1e-6);
    press(Qt::Key_6);
    EXPECT_NEAR(now(), At::kApproved, 1e-6);
    press(Qt::Key_7, Qt::AltModifier);
    EXPECT_NEAR(now(), At::kAlarm, 1e-6);
    press(Qt::Key_End);
    EXPECT_EQ(now(), window->player().end());
    press(Qt::Key_Home);
    EXPECT_EQ(now(), window->player().begin());
}

TEST_F(ReviewOf, aSessionGoesToATimeThatIsTyped)
{
    record();
    open();
    press(Qt::Key_G);
    QTest::keyClicks(window->positionEdit(), "0:02.5");
    QTest::keyClick(window->positionEdit(), Qt::Key_Return);
    EXPECT_NEAR(now(), 2.5, 1e-6);
    press(Qt::Key_G);
    QTest::keyClicks(window->positionEdit(), "now");
    QTest::keyClick(window->positionEdit(), Qt::Key_Return);
    EXPECT_NEAR(now(), 2.5, 1e-6);
}

TEST_F(ReviewOf, twoCursorsLoopAndTellTheDifference)
{
    record();
    open();
    window->goTo(1.0);
    press(Qt::Key_A);
    window->goTo(1.5);
    press(Qt::Key_B);
    EXPECT_TRUE(window->differenceLabel()->text().contains("+0.500"));
    press(Qt::Key_P);
    EXPECT_TRUE(window->player().loops());
    press(Qt::Key_L);
    for (int n = 0; n < 10; ++n) {
        window->look(0.2);
        EXPECT_GE(now(), 1.0);
        EXPECT_LE(now(), 1.5);
    }
    press(Qt::Key_K);
    window->goTo(1.5);
    press(Qt::Key_B);
    EXPECT_FALSE(window->player().b());
}

TEST_F(ReviewOf, aSessionThatIsStillRecordedIsFollowed)
{
    auto writer = robotSession(path.toStdString(), 2.0);
    ASSERT_TRUE(writer) << writer.error().text;
    open();
    const double before = window->player().end();
    press(Qt::Key_T);
    EXPECT_TRUE(window->player().following());
    EXPECT_EQ(now(), before);
    ASSERT_TRUE(writer->add(EventRow{
        .id = 100, .time = sessionTimeOf(7.0), .kind = EventKind::Marker, .text = "later"}));
    ASSERT_TRUE(writer->commit());
    window->look(0.6);
    EXPECT_NEAR(window->player().end(), 7.0, 1e-6);
    EXPECT_NEAR(now(), 7.0, 1e-6);
    EXPECT_TRUE(window->stateLabel()->text().contains("BEING RECORDED"));
    EXPECT_EQ(window->events()->table()->model()->rowCount(),
              static_cast<int>(window->session().events().size()));
}

TEST_F(ReviewOf, theForcesPeaksAtATimeAreTheSameHoweverOneCameThere)
{
    path = TERRATACT_SOURCE_DIR "/resources/sessions/demo.tts";
    open();
    const auto peaks = [&] {
        const ForceBars& bars = *window->terrainPage()->forces();
        std::vector<std::optional<double>> all;
        for (int array = 0; array < bars.arrays(); ++array)
            for (int e = 0; e < kForceElements; ++e) all.push_back(bars.peak(e, array));
        return all;
    };
    const auto shown = [&](double time) {
        window->goTo(time);
        return peaks();
    };
    constexpr double kLetGo = 20.0;  // [s] from where on it is looked for
    double at = 0.0;                 // where an element feels less than it did
    std::vector<std::optional<double>> jumped;
    for (double t = kLetGo; at == 0.0 && t < window->player().end(); t += 0.5) {
        jumped = shown(t);
        const auto& measured = window->moment().measurement;
        for (std::size_t e = 0; measured && e < measured->force.size(); ++e)
            if (jumped[e] && *jumped[e] > measured->force[e] + 1.0) at = t;
    }
    ASSERT_GT(at, 0.0) << "the session has a peak that stands above its bar";
    for (double t = at - 1.0; t < at; t += 0.04) window->goTo(t);
    EXPECT_EQ(shown(at), jumped) << "played there";
    for (double t = at + 5.0; t > at; t -= 0.3) window->goTo(t);
    EXPECT_EQ(shown(at), jumped) << "played there backwards";
    window->goTo(1.0);
    EXPECT_EQ(shown(at), jumped) << "from far away";
    open();
    EXPECT_EQ(shown(at), jumped) << "in a window that was nowhere else";
}

TEST_F(ReviewOf, aDamagedSessionShowsItsGaps)
{
    record();
    sqlite3* file = nullptr;
    ASSERT_EQ(sqlite3_open(path.toUtf8().constData(), &file), SQLITE_OK);
    ASSERT_EQ(sqlite3_exec(file,
                           "UPDATE can_frame SET data = x'00' WHERE t > 1000000000 AND t < "
                           "3000000000",
                           nullptr, nullptr, nullptr),
              SQLITE_OK);
    sqlite3_close(file);
    open();
    ASSERT_TRUE(eventually([&] { return window->surveyed(); }));
    EXPECT_TRUE(window->stateLabel()->text().contains("DAMAGED"));
    window->goTo(2.9);
    EXPECT_TRUE(window->damageLabel()->isVisible());
    EXPECT_FALSE(window->moment().measurement);
    window->goTo(3.9);
    EXPECT_FALSE(window->damageLabel()->isVisible());
    EXPECT_TRUE(window->moment().measurement);
}

TEST_F(ReviewOf, aNoteIsKeptBesideTheSessionAndNotInIt)
{
    record();
    open();
    const auto content = [&] { return *readFile(path.toStdString(), 1U << 26U); };
    const std::string before = content();
    window->goTo(1.25);
    press(Qt::Key_M);
    QTest::keyClicks(window->noteEdit(), "a, \"step\"");
    QTest::keyClick(window->noteEdit(), Qt::Key_Return);
    ASSERT_EQ(window->notes().size(), 1U);
    const auto notes = readNotes(path.toStdString());
    ASSERT_TRUE(notes) << notes.error().text;
    ASSERT_EQ(notes->size(), 1U);
    EXPECT_EQ((*notes)[0], (ReviewNote{1.25, "a, \"step\""}));
    EXPECT_EQ(content(), before);
    window->goTo(0.0);
    press(Qt::Key_8);
    EXPECT_NEAR(now(), 1.25, 1e-6);
    ASSERT_TRUE(writeFileAtomically(notesPath(path.toStdString()), "t_s,note\nsoon,x\n"));
    EXPECT_FALSE(readNotes(path.toStdString()));
}

TEST_F(ReviewOf, whatIsShownIsExported)
{
    record();
    open();
    window->goTo(At::kMarker);
    TerrainProfileView& terrain = *window->terrainPage()->terrain();
    for (const char* suffix : {"png", "svg", "pdf"}) {
        const QString to = QString::fromStdString(directory.file("picture.")) + suffix;
        EXPECT_TRUE(savePicture(terrain, to).isEmpty()) << suffix;
        EXPECT_GT(QFileInfo(to).size(), 2000) << suffix;
    }
    EXPECT_FALSE(savePicture(terrain, "picture.bmp").isEmpty());
    const QString day = QString::fromStdString(directory.file("day.png"));
    terrain.setFixedSize(800, 400);
    QTest::qWait(50);
    EXPECT_TRUE(savePicture(terrain, day).isEmpty());
    for (const ThemeName dark : {ThemeName::NightRed, ThemeName::HighContrast}) {
        QTest::keyClick(window.get(), dark == ThemeName::NightRed ? Qt::Key_5 : Qt::Key_6,
                        Qt::ControlModifier);
        ASSERT_EQ(lookInForce().theme, dark);
        QTest::qWait(50);
        const QImage shown = gui::painted(terrain);
        const QString to = QString::fromStdString(directory.file("dark.png"));
        EXPECT_TRUE(savePicture(terrain, to).isEmpty());
        EXPECT_EQ(QImage(to), QImage(day)) << "paper is white";
        EXPECT_EQ(lookInForce().theme, dark);
        QTest::qWait(50);
        EXPECT_EQ(gui::painted(terrain), shown);
    }
    QTest::keyClick(window.get(), Qt::Key_4, Qt::ControlModifier);
    window->numbers()->refresh(0.0);
    NumbersTable& table = *window->numbers()->table();
    EXPECT_FALSE(saveNumbers(window->moment(), table, "/nowhere/numbers.csv").isEmpty());
    const std::string to = directory.file("numbers.csv");
    EXPECT_TRUE(saveNumbers(window->moment(), table, QString::fromStdString(to)).isEmpty());
    const std::string text = *readFile(to, 1U << 20U);
    EXPECT_EQ(text.rfind("t_s,measured_s,pitch_rad", 0), 0U);
    EXPECT_NE(text.find("\n2,"), std::string::npos);
}

TEST(ReviewNotes, comeBackAsTheyWereWritten)
{
    TemporaryDirectory directory;
    const std::string session = directory.file("a.tts");
    const std::vector<ReviewNote> notes{{0.0, "plain"},      {1.25, "a, \"step\", or so"},
                                        {2.5, "\"quoted\""}, {3.0, "two\nlines\r\nand a third"},
                                        {4.0, ","},          {5.0, "\""},
                                        {6.0, ""},           {7.0, "schod, který „uhýbá“"}};
    ASSERT_TRUE(writeNotes(session, notes));
    const auto read = readNotes(session);
    ASSERT_TRUE(read) << read.error().text;
    EXPECT_EQ(*read, notes);

    const auto errorOf = [&](const std::string& text) {
        EXPECT_TRUE(writeFileAtomically(notesPath(session), text));
        const auto bad = readNotes(session);
        return bad ? std::string() : bad.error().text;
    };
    EXPECT_NE(errorOf("t_s,note\n1,\"two\nlines\"\n2,\"open\n").find("line 4: a quote"),
              std::string::npos);
    EXPECT_NE(errorOf("t_s,note\n1,\"a\"b\n").find("line 2"), std::string::npos);
    EXPECT_NE(errorOf("t_s,note\nsoon,x\n").find("line 2: t_s"), std::string::npos);
    EXPECT_NE(errorOf("t_s,note\nnan,x\n").find("line 2: t_s"), std::string::npos);
    EXPECT_NE(errorOf("t_s,note\n1,a,b\n").find("line 2"), std::string::npos);
    EXPECT_NE(errorOf("t_s,note\n1,torn").find("line 2: is torn"), std::string::npos);
    EXPECT_NE(errorOf("t,what\n").find("line 1: is no file of notes"), std::string::npos);
    EXPECT_NE(errorOf("").find("line 1"), std::string::npos);
    EXPECT_EQ(errorOf("t_s,note\r\n1,of another program\r\n"), "");
}

struct ExportOf : ReviewOf {
    /// Opens the dialog by its key.
    ReviewExportDialog& ask()
    {
        press(Qt::Key_E, Qt::ControlModifier);
        return *window->exportDialog();
    }
    /// Chooses by what a list says, and the name of the file.
    void choose(const QString& what, const QString& format, const std::string& name)
    {
        ReviewExportDialog& dialog = ask();
        choose(*dialog.what(), what);
        choose(*dialog.format(), format);
        dialog.pathEdit()->setText(QString::fromStdString(directory.file(name)));
    }
    static void choose(QComboBox& box, const QString& text)
    {
        const int index = box.findText(text, Qt::MatchStartsWith);
        ASSERT_GE(index, 0) << text.toStdString();
        box.setCurrentIndex(index);
    }
    void write()
    {
        ReviewExportDialog& dialog = *window->exportDialog();
        QTest::mouseClick(dialog.exportButton(), Qt::LeftButton);
        ASSERT_TRUE(eventually([&] { return !dialog.writes(); }));
        EXPECT_TRUE(dialog.resultLabel()->text().startsWith("Written"))
            << dialog.resultLabel()->text().toStdString();
    }
    std::string written(const std::string& name)
    {
        return *readFile(directory.file(name), 1U << 26U);
    }
    /// What the command line would write.
    std::string commandWrites(const std::string& name, const ExportSelection& selection)
    {
        auto session = SessionReader::open(path.toStdString());
        const std::string to = directory.file(name);
        EXPECT_TRUE(writeExport(*session, to, *exportFormatOf(to), selection));
        return *readFile(to, 1U << 26U);
    }
    QStringList files() { return QDir(QFileInfo(path).path()).entryList(QDir::Files); }
};

TEST_F(ExportOf, whatIsVisibleAndEverythingAreWhatTheCommandLineWrites)
{
    record();
    open();
    choose("CAN frames", ".log", "all.log");
    QTest::mouseClick(window->exportDialog()->wholeSession(), Qt::LeftButton);
    write();
    EXPECT_EQ(written("all.log"), commandWrites("command-all.log", {}));

    window->timeline()->showSpan(1.0, 3.0);
    choose("CAN frames", ".asc", "zoomed.asc");
    QTest::mouseClick(window->exportDialog()->visibleSpan(), Qt::LeftButton);
    write();
    EXPECT_EQ(written("zoomed.asc"),
              commandWrites("command-zoomed.asc", {.from = window->timeline()->first(),
                                                   .to = window->timeline()->last()}));

    window->activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(window.get()));
    window->goTo(1.5);
    press(Qt::Key_B);
    window->goTo(1.0);
    press(Qt::Key_A);
    const ExportSelection cursors{.what = ExportKind::Frames, .from = 1.0, .to = 1.5};
    choose("CAN frames", ".csv", "cursors.csv");
    EXPECT_TRUE(window->exportDialog()->visibleSpan()->text().contains("A to B"));
    write();
    EXPECT_EQ(written("cursors.csv"), commandWrites("command-cursors.csv", cursors));
    EXPECT_LT(written("cursors.csv").size(), 0.5 * static_cast<double>(written("all.log").size()));
    choose("CAN frames", ".mcap", "cursors.mcap");
    write();
    EXPECT_EQ(written("cursors.mcap"), commandWrites("command-cursors.mcap", cursors));
}

TEST_F(ExportOf, whatIsShownIsWrittenByTheSameDialog)
{
    record();
    open();
    window->goTo(At::kMarker);
    for (const char* format : {".png", ".svg", ".pdf"}) {
        choose("Picture", format, std::string("picture") + format);
        write();
        EXPECT_GT(written(std::string("picture") + format).size(), 2000U);
    }
    choose("Numbers", ".csv", "numbers.csv");
    write();
    EXPECT_EQ(written("numbers.csv").rfind("t_s,measured_s,pitch_rad", 0), 0U);
    choose("Report", ".html", "report");  // the ending is added
    write();
    EXPECT_NE(written("report.html").find("Scene 1 of review.tts"), std::string::npos);
    window->goTo(0.0);
    choose("Report", ".html", "none.html");
    EXPECT_FALSE(window->exportDialog()->exportButton()->isEnabled()) << "no estimate stands";
}

TEST_F(ExportOf, aButtonThatCannotBePressedSaysWhyNot)
{
    {
        auto writer = robotSession(path.toStdString(), 60.0, 850.0);
        ASSERT_TRUE(writer) << writer.error().text;
        ASSERT_TRUE(writer->seal());
    }
    open();
    gui::TipsOfButtons tips;
    window->rail()->choose(window->rail()->pageOf(Qt::Key_F6));
    for (const double time : {0.0, At::kMarker}) {
        window->goTo(time);
        tips.look(*window);
    }
    window->goTo(0.0);
    choose("Report", ".html", "report.html");
    ReviewExportDialog& dialog = *window->exportDialog();
    tips.look(dialog);
    EXPECT_EQ(dialog.exportButton()->toolTip(), "No estimate stands at this time");
    choose("Frames, signals", ".mcap", "");
    dialog.pathEdit()->clear();
    tips.look(dialog);
    EXPECT_EQ(dialog.exportButton()->toolTip(), "Name the file first");
    choose("Frames, signals", ".mcap", "big.mcap");
    tips.look(dialog);
    QTest::mouseClick(dialog.exportButton(), Qt::LeftButton);
    ASSERT_TRUE(dialog.writes());
    tips.look(dialog);
    QTest::keyClick(&dialog, Qt::Key_Escape);
    ASSERT_TRUE(eventually([&] { return !dialog.writes(); }));
    EXPECT_EQ(tips.silent(), std::vector<std::string>());
    for (const char* name : {"Export", "Cancel", "Choose …", "As recorded", "Estimate again (E)"})
        EXPECT_TRUE(tips.compared().contains(name)) << name;
}

TEST_F(ExportOf, aFileThatIsThereIsReplacedOnlyByAButtonThatSaysSo)
{
    record();
    open();
    ASSERT_TRUE(writeFileAtomically(directory.file("old.log"), "old"));
    choose("CAN frames", ".log", "old.log");
    ReviewExportDialog& dialog = *window->exportDialog();
    EXPECT_EQ(dialog.exportButton()->text(), "Replace the file");
    dialog.pathEdit()->setText("/nowhere/new.log");
    EXPECT_EQ(dialog.exportButton()->text(), "Export");
    QTest::mouseClick(dialog.exportButton(), Qt::LeftButton);
    ASSERT_TRUE(eventually([&] { return !dialog.writes(); }));
    EXPECT_TRUE(dialog.resultLabel()->text().startsWith("NOT WRITTEN: /nowhere/new.log"))
        << dialog.resultLabel()->text().toStdString();
    EXPECT_EQ(written("old.log"), "old");
}

TEST_F(ExportOf, theDialogHasRoomForEveryTextAndNamesForEveryControl)
{
    record();
    for (const int scale : {100, 150, 200}) {
        applyLook(*qApp, ThemeName::Day, scale);
        open();
        ReviewExportDialog& dialog = ask();
        for (int what = 0; what < dialog.what()->count(); ++what) {
            dialog.what()->setCurrentIndex(what);
            QCoreApplication::processEvents();
            EXPECT_EQ(cutText(dialog), std::vector<std::string>{}) << scale << " " << what;
        }
        for (const QWidget* widget : dialog.findChildren<QWidget*>()) {
            const auto* button = qobject_cast<const QAbstractButton*>(widget);
            if (!widget->isVisible() || widget->objectName().startsWith("qt_")) continue;
            if (!button && !(widget->focusPolicy() & Qt::TabFocus)) continue;
            EXPECT_FALSE(widget->accessibleName().isEmpty()
                         && (!button || button->text().isEmpty()))
                << widget->metaObject()->className();
            EXPECT_GE(widget->height(), 32) << widget->metaObject()->className();
        }
    }
    applyLook(*qApp);
}

TEST_F(ExportOf, oneThatIsCancelledLeavesNoFileAndTheReviewGoesOnMeanwhile)
{
    {
        auto writer = robotSession(path.toStdString(), 60.0, 850.0);
        ASSERT_TRUE(writer) << writer.error().text;
        ASSERT_TRUE(writer->seal());
    }
    open();
    const QStringList before = files();
    choose("Frames, signals", ".mcap", "big.mcap");
    ReviewExportDialog& dialog = *window->exportDialog();
    QTest::mouseClick(dialog.exportButton(), Qt::LeftButton);
    ASSERT_TRUE(dialog.writes()) << "does not wait";
    EXPECT_TRUE(dialog.progressBar()->isVisible());
    EXPECT_FALSE(dialog.exportButton()->isEnabled());
    window->goTo(12.0);
    EXPECT_EQ(now(), 12.0);
    QTest::keyClick(&dialog, Qt::Key_Escape);
    ASSERT_TRUE(eventually([&] { return !dialog.writes(); }));
    EXPECT_TRUE(dialog.resultLabel()->text().startsWith("Cancelled"))
        << dialog.resultLabel()->text().toStdString();
    EXPECT_EQ(files(), before);
    EXPECT_TRUE(dialog.isVisible());

    QTest::mouseClick(dialog.exportButton(), Qt::LeftButton);
    window.reset();  // closed while it is written
    EXPECT_EQ(files(), before);
}

TEST_F(ReviewOf, recordedSettingsGiveTheRecordedEstimateBitForBit)
{
    const std::string model = TERRATACT_SOURCE_DIR "/resources/models/default.ttm";
    const auto loaded = modelFileLoader(model, absolem())();
    ASSERT_TRUE(loaded) << loaded.error().text;
    SessionStart start = someStart();
    start.robot = *readFile(TERRATACT_SOURCE_DIR "/resources/robots/absolem.toml", 1U << 16U);
    auto writer = SessionWriter::create(path.toStdString(), start);
    ASSERT_TRUE(writer) << writer.error().text;
    ASSERT_TRUE(
        writer->add(ModelRow{.id = 1, .name = "default.ttm", .hash = *sha256OfFile(model)}));
    SceneRow scene{.id = 1, .time = sessionTimeOf(1.0)};
    scene.measurement.pitch = 0.05;
    scene.measurement.roll = 0.2;  // warned of
    scene.measurement.force = {0.0, 0.0, 0.0, 0.0, 0.0, 7.0};
    ASSERT_TRUE(writer->add(scene));
    EstimateRow row{.id = 1, .time = sessionTimeOf(1.5), .scene = 1, .model = 1};
    Settings settings;
    settings.seed = 18'446'744'073'709'551'557U;
    row.estimate = loaded->estimate({scene.measurement, {}, settings}, Watch{});
    ASSERT_TRUE(writer->add(row));
    ASSERT_TRUE(writer->seal());

    open({QString::fromStdString(model)});
    window->goTo(1.5);
    press(Qt::Key_E);
    WhatIfPage& page = *window->whatIf();
    EXPECT_EQ(page.seed()->text(), "18446744073709551557");
    ASSERT_TRUE(eventually([&] { return page.answer().has_value(); }, 60000));
    EXPECT_TRUE(page.result()->text().contains("bit for bit"))
        << page.result()->text().toStdString();
    EXPECT_EQ(*page.answer(), row.estimate);

    page.threshold()->setValue(20.0);
    page.estimate();
    ASSERT_TRUE(eventually([&] { return page.answer() && *page.answer() != row.estimate; }, 60000));
    EXPECT_FALSE(page.result()->text().contains("bit for bit"));
    EXPECT_EQ(page.answer()->settings.forceThreshold, 20.0);
    window->goTo(1.0);
    EXPECT_FALSE(page.answer()) << "of another estimate";
}

TEST_F(ReviewOf, theShippedSessionIsRepeatedBitForBit)
{
    path = TERRATACT_SOURCE_DIR "/resources/sessions/demo.tts";
    open({TERRATACT_SOURCE_DIR "/resources/models/default.ttm"});
    press(Qt::Key_4);
    for (int estimate = 0; estimate < 2; ++estimate) {
        if (estimate > 0) {
            window->goTo(secondsOf(window->session().estimates().back().time));
            ASSERT_TRUE(window->moment().state.probed);
        }
        ASSERT_TRUE(window->moment().estimate);
        window->whatIf()->estimate();
        ASSERT_TRUE(eventually([&] { return window->whatIf()->answer().has_value(); }, 60000));
        EXPECT_TRUE(window->whatIf()->result()->text().contains("bit for bit"))
            << window->whatIf()->result()->text().toStdString();
    }
}

TEST_F(ReviewOf, everyTextHasItsRoomAndEveryControlAName)
{
    applyLook(*qApp);
    record();
    open();
    window->resize(1200, 680);
    for (int page = 0; page < window->rail()->pages(); ++page) {
        window->rail()->choose(page);
        window->goTo(At::kMarker);
        QCoreApplication::processEvents();
        // The table of numbers is seen to by its own test; four draws that fall apart are too much for it.
        if (window->rail()->keyOf(page) != Qt::Key_F3) {
            EXPECT_EQ(cutWhenSettled(), std::vector<std::string>{}) << page;
        }
        for (const QWidget* widget : window->findChildren<QWidget*>()) {
            const auto* button = qobject_cast<const QAbstractButton*>(widget);
            if (!widget->isVisible() || widget->objectName().startsWith("qt_")) continue;
            if (!button && !(widget->focusPolicy() & Qt::TabFocus)) continue;
            EXPECT_FALSE(widget->accessibleName().isEmpty()
                         && (!button || button->text().isEmpty()))
                << page << widget->metaObject()->className();
            EXPECT_GE(widget->height(), 32) << page << widget->accessibleName().toStdString();
        }
    }
    EXPECT_TRUE(window->keys().html().contains("Space"));
}

TEST_F(ReviewOf, nothingIsCutInLargeLettersAndTheTerrainHasTheRoomThereIs)
{
    applyLook(*qApp);
    record();
    open();
    struct Case {
        int scale;  // [%]
        QSize size;
        double terrain;  // [px] of a metre, at least
    };
    const Case cases[]{{100, {1200, 680}, 300.0}, {100, {1440, 900}, 320.0},
                       {120, {1200, 680}, 200.0}, {150, {1200, 680}, 170.0},
                       {150, {1440, 900}, 340.0}, {200, {1920, 1080}, 340.0}};
    int scale = 100;
    for (const Case& c : cases) {
        window->setRoom(c.size);
        for (; scale < c.scale; scale += 10) press(Qt::Key_Plus, Qt::ControlModifier);
        window->resize(c.size);
        EXPECT_EQ(lookInForce().fontScale, c.scale) << c.size.width();
        for (int page = 0; page < window->rail()->pages(); ++page) {
            window->rail()->choose(page);
            window->goTo(At::kMarker);
            if (window->rail()->keyOf(page) == Qt::Key_F3) continue;
            EXPECT_EQ(cutWhenSettled(), std::vector<std::string>{}) << c.scale << " " << page;
            EXPECT_EQ(gui::overlaps(*window), std::vector<std::string>{}) << c.scale << " " << page;
        }
        window->rail()->choose(0);
        QTest::qWait(50);
        EXPECT_EQ(window->size(), c.size);
        const TerrainProfileView& terrain = *window->terrainPage()->terrain();
        EXPECT_GE(terrain.transform(QwtPlot::xBottom, 1.0)
                      - terrain.transform(QwtPlot::xBottom, 0.0),
                  c.terrain)
            << c.scale << " % " << c.size.width();
    }
    press(Qt::Key_0, Qt::ControlModifier);
}

TEST_F(ReviewOf, nothingIsCutInAnyLanguage)
{
    applyLook(*qApp);
    record();
    for (const char* language : {"en", "cs", "de"}) {
        window.reset();
        if (installLanguage(*qApp, language) != QLatin1String(language))
            GTEST_SKIP() << "built without translations";
        open();
        for (const QSize size : {QSize(1200, 680), QSize(1440, 900)}) {
            window->resize(size);
            for (int page = 0; page < window->rail()->pages(); ++page) {
                window->rail()->choose(page);
                window->goTo(At::kMarker);
                if (window->rail()->keyOf(page) == Qt::Key_F3) continue;
                EXPECT_EQ(cutWhenSettled(), std::vector<std::string>{}) << language << " " << page;
            }
        }
        press(Qt::Key_E, Qt::ControlModifier);
        const ReviewExportDialog* dialog = window->exportDialog();
        ASSERT_TRUE(dialog);
        QTest::qWait(20);
        EXPECT_EQ(cutText(*dialog), std::vector<std::string>{}) << language;
    }
    installLanguage(*qApp, "en");
}

TEST(ScenesOfAFile, areEstimatedOneByOneAndCommandNothing)
{
    std::vector<Scene> scenes(2);
    scenes[0].run = "first";
    scenes[0].s.force.fill(0.0);
    scenes[1] = scenes[0];
    scenes[1].run = "second";
    scenes[1].s.pitch = 0.2;
    scenes[1].truth[3] = -0.2;  // the other bins are not known
    ScenesWindow window({.path = "/some/scenes.csv",
                         .scenes = scenes,
                         .robot = absolem(),
                         .model = modelFileLoader(
                             TERRATACT_SOURCE_DIR "/resources/models/default.ttm", absolem())});
    showActive(window);
    ASSERT_TRUE(eventually([&] { return window.estimate().has_value(); }, 60000));
    const TerrainEstimate first = *window.estimate();
    EXPECT_TRUE(window.stateLabel()->text().contains("first"));
    QTest::keyClick(&window, Qt::Key_Period);
    EXPECT_EQ(window.scene(), 1U);
    EXPECT_FALSE(window.estimate()) << "of another scene";
    ASSERT_TRUE(eventually([&] { return window.estimate().has_value(); }, 60000));
    EXPECT_NE(*window.estimate(), first);
    EXPECT_FALSE(painted(window).isNull());
    QTest::keyClick(&window, Qt::Key_Period);
    EXPECT_EQ(window.scene(), 1U) << "is the last";
    QTest::keyClick(&window, Qt::Key_Comma);
    EXPECT_EQ(window.scene(), 0U);
    for (const QPushButton* button : commandButtons(*window.terrainPage()))
        EXPECT_FALSE(button->isVisible() && button->isEnabled());
    EXPECT_FALSE(window.header()->stopButton()->isVisible());
    EXPECT_FALSE(saysThatStopIsDead(window));
    QTest::keyClick(&window, Qt::Key_F12);
    EXPECT_TRUE(saysThatStopIsDead(window));
}

TEST(KindOfFile, isToldByWhatIsInIt)
{
    TemporaryDirectory directory;
    const std::string session = directory.file("a.log");
    {
        auto writer = someSession(session, 200);
        ASSERT_TRUE(writer);
        ASSERT_TRUE(writer->seal());
    }
    EXPECT_EQ(kindOfFile(QString::fromStdString(session)), FileKind::Session);
    const std::string scenes = directory.file("a.tts");
    ASSERT_TRUE(writeFileAtomically(scenes, "run,t_s,pitch_rad,front_rad\n"));
    EXPECT_EQ(kindOfFile(QString::fromStdString(scenes)), FileKind::Scenes);
    const std::string log = directory.file("b.tts");
    ASSERT_TRUE(writeFileAtomically(log, "(1.0) can0 100#00\n"));
    EXPECT_EQ(kindOfFile(QString::fromStdString(log)), FileKind::Log);
    EXPECT_EQ(kindOfFile("/nowhere/x"), FileKind::Log);
}

/// What playing costs, by a command: TERRATACT_REVIEW_SECONDS=3600 app.review_test --gtest_filter=*Costs*
TEST_F(ReviewOf, playbackCostsLittle)
{
    const char* given = std::getenv("TERRATACT_REVIEW_SECONDS");
    const double seconds = given ? std::atof(given) : 10.0;
    {
        auto writer = robotSession(path.toStdString(), seconds, 850.0);
        ASSERT_TRUE(writer) << writer.error().text;
        ASSERT_TRUE(writer->seal());
    }
    open();
    ASSERT_TRUE(eventually([&] { return window->surveyed(); }, 120000));
    const auto used = [] {
        rusage usage{};
        ::getrusage(RUSAGE_SELF, &usage);
        const auto of = [](const timeval& t) {
            return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
        };
        return std::pair(of(usage.ru_utime) + of(usage.ru_stime), usage.ru_maxrss / 1024);
    };
    const double from = seconds / 2.0, before = used().first;
    window->goTo(from);
    press(Qt::Key_L);
    QElapsedTimer watch;
    watch.start();
    QTest::qWait(given ? 20000 : 1000);
    const double elapsed = 1e-3 * static_cast<double>(watch.elapsed());
    const auto [after, megabytes] = used();
    std::printf("%lld frames: playback of %.2f s at 1x took %.1f %% of a core, %ld MB at most\n",
                static_cast<long long>(window->session().frameCount()), now() - from,
                100.0 * (after - before) / elapsed, megabytes);
    EXPECT_GT(now(), from + 0.1);
    EXPECT_LE(now(), from + elapsed + 0.1);
}

}  // namespace
}  // namespace terratact
