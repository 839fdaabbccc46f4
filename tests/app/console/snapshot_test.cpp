// Tests snapshots: their files, their events and their note.
#include "app/console/snapshot.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QDateTime>
#include <QFile>
#include <QFileInfo>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>

#include "core/log/session_reader.h"
#include "tests/support/console_bench.h"
#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

const QDateTime kNoon(QDate(2026, 3, 4), QTime(12, 0, 1, 250), Qt::UTC);

TEST(SnapshotFiles, lieBesideTheSessionUnderAFreeName)
{
    const TemporaryDirectory directory;
    const std::string session = directory.file("drive.tts");
    const SnapshotFiles first = snapshotFiles(session, kNoon);
    EXPECT_EQ(first.base, directory.file("drive-snapshot-120001-250"));
    directory.write("drive-snapshot-120001-250.png", "taken");
    EXPECT_EQ(snapshotFiles(session, kNoon).base, first.base + "-2");
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

struct Snapshots : Console {
    void openRecorded()
    {
        open(fastRobot(robot, 2.0));
        MainWindow::Options options;
        options.robot = robot;
        options.source = fastRobot(robot, 2.0);
        options.model = [] { return Result<LoadedModel>(madeUp()); };
        options.recorder = std::make_shared<SessionRecorder>(
            SessionRecorder::Options{.folder = directory.file("sessions"), .start = {}});
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
    ASSERT_TRUE(gui::eventually([&] { return files(".csv").size() == 1; }));
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
    EXPECT_EQ(markers[1], std::pair(std::string("snapshot note"), std::string("smoke, gas 3 %")));
}

TEST_F(Snapshots, withoutANoteThereIsOneEvent)
{
    openRecorded();
    QTest::keyClick(window.get(), Qt::Key_C);
    QTest::keyClick(window->snapshotNote(), Qt::Key_Escape);
    const std::string path = recorder->state().path;
    window.reset();
    const auto session = SessionReader::open(path);
    ASSERT_TRUE(session);
    EXPECT_EQ(std::ranges::count(session->events(), EventKind::Marker, &EventRow::kind), 1);
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
    qputenv("HOME", home);
}

}  // namespace
}  // namespace terratact
