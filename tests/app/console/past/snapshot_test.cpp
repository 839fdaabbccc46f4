// Tests snapshots: their files, their events and their note.
#include "app/console/past/snapshot.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QSignalSpy>
#include <QTimeZone>
#include <future>
#include <memory>

#include "app/console/past/history_control.h"
#include "app/console/past/history_window.h"
#include "core/log/session_reader.h"
#include "tests/support/benches/console_bench.h"
#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

const QDateTime kNoon(QDate(2026, 3, 4), QTime(12, 0, 1, 250), QTimeZone::utc());

TEST(SnapshotFiles, lieBesideTheSessionUnderAFreeName)
{
    const TemporaryDirectory directory;
    const std::string session = directory.file("drive.tts");
    const SnapshotFiles first = snapshotFiles(session, kNoon);
    EXPECT_EQ(first.base, directory.file("drive-snapshot-120001-250"));
    directory.write("drive-snapshot-120001-250.png", "taken");
    EXPECT_EQ(snapshotFiles(session, kNoon).base, first.base + "-2");
    directory.write("drive-snapshot-120001-250-2.csv", "taken");
    EXPECT_EQ(snapshotFiles(session, kNoon).base, first.base + "-3") << "its numbers";
    directory.write("drive-snapshot-120001-250-3.txt", "taken");
    EXPECT_EQ(snapshotFiles(session, kNoon).base, first.base + "-4") << "its note";
}

TEST(SnapshotFiles, lieInAFolderOfTheOperatorWithoutASession)
{
    const std::string base = snapshotFiles({}, kNoon).base;
    EXPECT_TRUE(base.ends_with("/terratact-20260304-120001-250")) << base;
}

TEST(SnapshotWriter, reportsAFolderThatCannotBeWritten)
{
    SnapshotWriter writer;
    QSignalSpy wrote(&writer, &SnapshotWriter::wrote);
    writer.write({"/nowhere/at/all"}, QImage(4, 4, QImage::Format_RGB32), "a,b\n");
    ASSERT_TRUE(wrote.wait());
    EXPECT_TRUE(wrote.first().at(1).toString().contains("/nowhere/at/all.png"));
}

TEST(SnapshotWriter, refusesASecondOneWhileTheFirstIsBeingWritten)
{
    const TemporaryDirectory directory;
    SnapshotWriter writer;
    QSignalSpy wrote(&writer, &SnapshotWriter::wrote);
    const QImage picture(4, 4, QImage::Format_RGB32);
    EXPECT_TRUE(writer.write({directory.file("a")}, picture, "a,b\n"));
    EXPECT_FALSE(writer.write({directory.file("b")}, picture, "a,b\n"));
    ASSERT_TRUE(wrote.wait());
    EXPECT_FALSE(writer.isWriting());
    EXPECT_TRUE(writer.write({directory.file("b")}, picture, "a,b\n"));
    ASSERT_TRUE(wrote.wait());
    EXPECT_TRUE(wrote.last().at(1).toString().isEmpty());
}

TEST(SnapshotWriter, leavesNothingOfASnapshotThatFails)
{
    const TemporaryDirectory directory;
    SnapshotWriter writer;
    QSignalSpy wrote(&writer, &SnapshotWriter::wrote);
    EXPECT_TRUE(writer.write({directory.file("a")}, QImage(), "a,b\n"));
    ASSERT_TRUE(wrote.wait());
    EXPECT_TRUE(wrote.last().at(1).toString().contains("cannot be coded"));
    QDir().mkpath(QString::fromStdString(directory.file("b.csv")));
    EXPECT_TRUE(writer.write({directory.file("b")}, QImage(4, 4, QImage::Format_RGB32), "a,b\n"));
    ASSERT_TRUE(wrote.wait());
    EXPECT_FALSE(wrote.last().at(1).toString().isEmpty());
    EXPECT_EQ(QDir(QString::fromStdString(directory.file(""))).entryList(QDir::Files),
              QStringList());
}

TEST(SnapshotWriter, aDiskThatHangsDoesNotKeepTheConsoleOpen)
{
    std::promise<void> disk, ended;
    std::shared_future<void> answers = disk.get_future().share();
    auto writer = std::make_unique<SnapshotWriter>(
        [answers, &ended](const SnapshotFiles&, const QImage&, const std::string&) {
            answers.wait();
            ended.set_value_at_thread_exit();
            return QString();
        },
        std::chrono::milliseconds(1));
    EXPECT_TRUE(writer->write({"/nowhere"}, QImage(), {}));
    writer.reset();  // the test would hang here
    disk.set_value();
    ended.get_future().wait();
}

TEST(SnapshotNote, aTypedNoteIsKeptForItsOwnSnapshot)
{
    QWidget console;
    SnapshotNote note(console);
    std::vector<std::pair<std::string, QString>> noted;
    QObject::connect(&note, &SnapshotNote::noted, &note,
                     [&](const SnapshotFiles& files, const QString& text) {
                         noted.emplace_back(files.base, text);
                     });
    using Noted = decltype(noted);
    note.ask({"/a"}, "a");
    note.field()->setText("first");
    note.accept();
    EXPECT_EQ(noted, Noted()) << "its files are not there yet";
    note.setWritten("a");
    EXPECT_EQ(noted, (Noted{{"/a", "first"}}));
    note.ask({"/b"}, "b");
    note.setWritten("b");
    note.field()->setText("second");
    note.ask({"/c"}, "c");
    EXPECT_EQ(noted, (Noted{{"/a", "first"}, {"/b", "second"}}));
    EXPECT_TRUE(note.field()->text().isEmpty());
    note.reject();
    note.setWritten("c");
    EXPECT_EQ(noted.size(), 2U);
}

struct Snapshots : Console {
    void openRecorded()
    {
        open(fastRobot(robot, 2.0));
        MainWindow::Options options;
        options.robot = robot;
        options.source = fastRobot(robot, 2.0);
        options.model = [] { return Result<LoadedModel>(madeUp()); };
        options.recorder = std::make_shared<SessionRecorder>(SessionRecorder::Options{
            .folder = directory.file("sessions"), .start = {}, .patience = kBusyDisk});
        recorder = options.recorder.get();
        window = std::make_unique<MainWindow>(std::move(options));
        window->resize(1280, 720);
        gui::showActive(*window);
        ASSERT_TRUE(gui::eventually([&] { return recorder->state().recording; }));
    }
    QStringList files(const char* ending) const
    {
        return QDir(QString::fromStdString(directory.file("sessions")))
            .entryList({QString("*-snapshot-*") + ending});
    }
    TemporaryDirectory directory;
    SessionRecorder* recorder = nullptr;
};

TEST_F(Snapshots, oneKeySavesPictureNumbersAndEvents)
{
    openRecorded();
    QTest::keyClick(window.get(), Qt::Key_C);
    ASSERT_NE(window->snapshotNote(), nullptr);
    EXPECT_TRUE(says("is being written")) << "not yet saved";
    ASSERT_TRUE(gui::eventually([&] { return says("beside the session"); }));
    for (const QLabel* banner : window->findChildren<QLabel*>(QStringLiteral("banner")))
        EXPECT_FALSE(banner->isVisible()) << "a banner looks like trouble";
    ASSERT_EQ(files(".csv").size(), 1);
    ASSERT_EQ(files(".png").size(), 1);
    const QString base = QString::fromStdString(directory.file("sessions/"));
    EXPECT_EQ(QImage(base + files(".png")[0]).size(), window->size());
    QFile numbers(base + files(".csv")[0]);
    ASSERT_TRUE(numbers.open(QIODevice::ReadOnly));
    const QByteArray csv = numbers.readAll();
    EXPECT_TRUE(csv.contains("pitch_rad,")) << csv.toStdString();

    QTest::keyClicks(window->snapshotNote()->field(), "smoke, gas 3 %");
    QTest::keyClick(window->snapshotNote()->field(), Qt::Key_Return);
    EXPECT_FALSE(window->snapshotNote()->isVisible());
    const std::string path = recorder->state().path;
    window.reset();  // seals the session
    const auto session = SessionReader::open(path);
    ASSERT_TRUE(session);
    std::vector<std::pair<std::string, std::string>> markers;
    for (const EventRow& event : session->events())
        if (event.kind == EventKind::Marker) markers.emplace_back(event.subject, event.text);
    ASSERT_EQ(markers.size(), 2U);
    EXPECT_EQ(markers[0].first, "snapshot");
    EXPECT_EQ(markers[0].second + ".png", files(".png")[0].toStdString());
    EXPECT_EQ(markers[1],
              std::pair(std::string("snapshot note"), markers[0].second + ": smoke, gas 3 %"));
}

TEST_F(Snapshots, withoutANoteThereIsOneEvent)
{
    openRecorded();
    QTest::keyClick(window.get(), Qt::Key_C);
    QTest::keyClick(window->snapshotNote(), Qt::Key_Escape);
    ASSERT_TRUE(gui::eventually([&] { return says("beside the session"); }));
    const std::string path = recorder->state().path;
    window.reset();
    const auto session = SessionReader::open(path);
    ASSERT_TRUE(session);
    EXPECT_EQ(std::ranges::count(session->events(), EventKind::Marker, &EventRow::kind), 1);
}

TEST_F(Snapshots, savesThePresentAlone)
{
    openRecorded();
    proposeByKeyboard();
    QTest::keyClick(window.get(), Qt::Key_N);
    ASSERT_TRUE(reaches(AtemPhase::Presenting));
    ASSERT_TRUE(gui::eventually([&] { return window->showsEstimate(); }));
    QTest::keyClick(window.get(), Qt::Key_Delete);
    ASSERT_TRUE(gui::eventually(
        [&] { return !window->exploration().estimation().estimate().has_value(); }));
    window->history().open();
    window->history().window()->list()->setCurrentRow(0);
    ASSERT_TRUE(gui::eventually([&] { return says("not the present one. Backspace"); }));
    window->takeSnapshot();
    EXPECT_FALSE(window->history().showsPast());
    EXPECT_FALSE(says("not the present one. Backspace")) << "the picture has no past either";
    EXPECT_FALSE(window->terrain()->estimate().has_value());
    window->takeSnapshot();
    ASSERT_TRUE(gui::eventually([&] { return says("beside the session"); }));
    EXPECT_EQ(files(".csv").size(), 1) << "the second one was refused";
}

TEST_F(Snapshots, thePictureIsNotBlankWhileTheFontIsBeingFitted)
{
    openRecorded();
    QTest::keyClick(window.get(), Qt::Key_Minus, Qt::ControlModifier);
    ASSERT_TRUE(window->isFittingFont());
    window->takeSnapshot();
    ASSERT_TRUE(gui::eventually([&] { return says("beside the session"); }));
    ASSERT_EQ(files(".png").size(), 1);
    const QString path = QString::fromStdString(directory.file("sessions/")) + files(".png")[0];
    EXPECT_GT(gui::colours(QImage(path)), 20);
}

TEST_F(Snapshots, theNoteBlocksNothingAndLetsTheRobotHalt)
{
    openRecorded();
    ASSERT_TRUE(readyToExplore());
    QTest::keyPress(window.get(), Qt::Key_W);
    ASSERT_TRUE(robotIs(RobotActivity::Driving));
    QTest::keyClick(window.get(), Qt::Key_C);
    SnapshotNote& note = *window->snapshotNote();
    ASSERT_TRUE(note.isVisible());
    EXPECT_FALSE(note.isModal());
    EXPECT_TRUE(robotIs(RobotActivity::Halted)) << "as in every dialog";
    QTest::keyRelease(note.field(), Qt::Key_W);
    QSignalSpy decided(&window->exploration(), &Exploration::decided);
    QTest::keyClicks(note.field(), "wasfmb n1");
    EXPECT_EQ(note.field()->text(), "wasfmb n1");
    EXPECT_EQ(decided.size(), 0) << "typing does not steer";
    QTest::keyClick(note.field(), Qt::Key_F12);
    ASSERT_EQ(decided.size(), 1);
    EXPECT_STREQ(decided[0][0].value<const char*>(), "stop");
}

TEST_F(Snapshots, withoutASessionItSaysWhereTheFilesAre)
{
    const QByteArray home = qgetenv("HOME");
    qputenv("HOME", directory.file("").c_str());
    open(fastRobot(robot, 2.0));
    QTest::keyClick(window.get(), Qt::Key_C);
    EXPECT_TRUE(gui::eventually([&] {
        return says("no session records; the snapshot is in "
                    + QString::fromStdString(directory.file("")));
    }));
    const QDir folder(QString::fromStdString(directory.file("")));
    EXPECT_EQ(folder.entryList({"terratact-*.png", "terratact-*.csv"}).size(), 2)
        << "they are there when it says so";
    qputenv("HOME", home);
}

}  // namespace
}  // namespace terratact
