// Tests the window that makes a session of another program's recording.
#include "app/imports/import_window.h"

#include <gtest/gtest.h>

#include <QComboBox>
#include <QDragEnterEvent>
#include <QLabel>
#include <QMimeData>
#include <QPlainTextEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalSpy>
#include <QUrl>
#include <filesystem>

#include "app/imports/import_page.h"
#include "app/modelling/simulation/simulated_recording.h"
#include "app/shell/dropped_files.h"
#include "app/shell/open_file.h"
#include "core/log/session_reader.h"
#include "core/store/file_write.h"
#include "tests/support/gui.h"
#include "tests/support/temporary_directory.h"
#include "widgets/base/theme.h"

namespace terratact {
namespace {

using namespace gui;

/// A recording of some stops, and the window that imports it.
struct ImportBench : testing::Test {
    explicit ImportBench(int stops = 3) : robot(*readRobotFile(kRobot))
    {
        applyLook(*qApp);
        std::vector<RecordedStop> made(static_cast<std::size_t>(stops));
        for (RecordedStop& stop : made) {
            stop.run = "a";
            stop.s.currents.fill(2.0);
            for (auto& forces : stop.s.forces) forces.fill(1.0);
        }
        file = directory.file("drive.mcap");
        FileGroup files;
        if (!addSimulatedRecording(files, file, robot.model, made) || !files.commit())
            throw std::runtime_error("no recording");
    }

    void open()
    {
        window = std::make_unique<ImportWindow>(QString::fromStdString(file), robot,
                                                QString::fromStdString(directory.file("")));
        window->resize(ConsoleWindow::kMin);
        showActive(*window);
        page = window->page();
    }
    bool isIdle() const { return !page->cancelButton()->isEnabled(); }
    bool opensAndSurveys()
    {
        open();
        return eventually([this] { return isIdle(); });
    }
    /// Chooses a shipped mapping.
    void choose(const QString& name)
    {
        const int index = page->mappingChoice()->findText(name, Qt::MatchContains);
        page->mappingChoice()->setCurrentIndex(index);
        emit page->mappingChoice()->activated(index);
    }

    static constexpr const char* kRobot = TERRATACT_SOURCE_DIR "/resources/robots/absolem.toml";
    TemporaryDirectory directory;
    RobotFile robot;
    std::string file;
    std::unique_ptr<ImportWindow> window;
    ImportPage* page = nullptr;
};

TEST_F(ImportBench, recordingIsListedAndAMappingProposed)
{
    ASSERT_TRUE(opensAndSurveys());
    EXPECT_TRUE(page->holdsText()->toPlainText().contains("/joint_states"));
    EXPECT_TRUE(page->mappingText()->toPlainText().contains("[front_left]"));
    EXPECT_TRUE(page->importButton()->isEnabled());
}

TEST_F(ImportBench, shippedMappingMakesASession)
{
    ASSERT_TRUE(opensAndSurveys());
    choose("simulated_robot.toml");
    EXPECT_TRUE(page->mappingText()->toPlainText().contains("flipper_fl"));
    const QSignalSpy made(window.get(), &ImportWindow::sessionMade);
    page->importInto(QString::fromStdString(directory.file("drive.tts")));
    EXPECT_FALSE(page->importButton()->isEnabled());
    ASSERT_TRUE(eventually([&] { return made.count() == 1; }));
    EXPECT_TRUE(page->stateLabel()->text().contains("3 scenes"))
        << page->stateLabel()->text().toStdString();
    const auto session = SessionReader::open(directory.file("drive.tts"));
    ASSERT_TRUE(session);
    EXPECT_EQ(session->scenes().size(), 3U);
    page->importInto(QString::fromStdString(directory.file("drive.tts")));
    ASSERT_TRUE(eventually([&] { return isIdle(); }));
    EXPECT_EQ(made.count(), 1) << "an existing file is not overwritten";
}

TEST_F(ImportBench, checkListsTheWarnings)
{
    ASSERT_TRUE(opensAndSurveys());
    choose("simulated_robot.toml");
    page->checkButton()->click();
    ASSERT_TRUE(eventually([&] { return isIdle(); }));
    EXPECT_TRUE(page->resultText()->toPlainText().contains("it is stuck"))
        << page->resultText()->toPlainText().toStdString();
}

TEST_F(ImportBench, wrongMappingIsOneSentence)
{
    ASSERT_TRUE(opensAndSurveys());
    page->mappingText()->setPlainText("name = ");
    page->checkButton()->click();
    ASSERT_TRUE(eventually([&] { return isIdle(); }));
    EXPECT_TRUE(page->stateLabel()->text().contains("line 1"));
    EXPECT_TRUE(page->importButton()->isEnabled());
}

struct LongImportBench : ImportBench {
    LongImportBench() : ImportBench(200) {}
};

TEST_F(LongImportBench, cancelLeavesNoSession)
{
    ASSERT_TRUE(opensAndSurveys());
    choose("simulated_robot.toml");
    page->importInto(QString::fromStdString(directory.file("drive.tts")));
    page->cancelButton()->click();
    ASSERT_TRUE(eventually([&] { return isIdle(); }));
    EXPECT_TRUE(page->stateLabel()->text().contains("Cancelled"));
    EXPECT_FALSE(std::filesystem::exists(directory.file("drive.tts")));
}

TEST_F(LongImportBench, closingEndsTheReading)
{
    open();
    window.reset();
    EXPECT_TRUE(std::filesystem::exists(file));
}

TEST_F(ImportBench, fileThatIsNoRecordingIsRefused)
{
    ASSERT_TRUE(writeFileAtomically(file, "\x89MCAP and nothing else"));
    ASSERT_TRUE(opensAndSurveys());
    EXPECT_TRUE(page->stateLabel()->text().contains("drive.mcap"));
    EXPECT_TRUE(page->mappingText()->toPlainText().isEmpty());
}

TEST_F(ImportBench, keyboardReachesEveryControl)
{
    ASSERT_TRUE(opensAndSurveys());
    page->holdsText()->setFocus();
    std::set<const QWidget*> reached;
    for (int i = 0; i < 12; ++i) {
        reached.insert(QApplication::focusWidget());
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
    }
    for (const QWidget* control : std::initializer_list<QWidget*>{
             page->holdsText(), page->mappingText(), page->mappingChoice(), page->checkButton(),
             page->importButton(), page->resultText()}) {
        EXPECT_TRUE(reached.contains(control)) << control->accessibleName().toStdString();
    }
}

TEST_F(ImportBench, kindIsKnownByTheContent)
{
    EXPECT_EQ(kindOfFile(QString::fromStdString(file)), FileKind::Recording);
    const std::string csv = directory.write("a.csv", "time,pitch\n0.0,0.1\n0.1,0.1\n");
    EXPECT_EQ(kindOfFile(QString::fromStdString(csv)), FileKind::Recording);
    const std::string bag = directory.write("b.x", "#ROSBAG V2.0\n");
    EXPECT_EQ(kindOfFile(QString::fromStdString(bag)), FileKind::Recording);
}

TEST_F(ImportBench, droppedFilesAreOpened)
{
    QWidget target;
    QStringList opened;
    openDroppedFiles(target, [&opened](const QString& path) { opened << path; });
    QMimeData mime;
    mime.setUrls({QUrl::fromLocalFile(QString::fromStdString(file)), QUrl("http://example.org/a"),
                  QUrl::fromLocalFile("/nowhere/x")});
    QDragEnterEvent enter({1, 1}, Qt::CopyAction, &mime, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&target, &enter);
    EXPECT_TRUE(enter.isAccepted());
    QDropEvent drop(QPointF(1, 1), Qt::CopyAction, &mime, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&target, &drop);
    EXPECT_EQ(opened, QStringList{QString::fromStdString(file)});
}

TEST_F(ImportBench, isReadableInEveryThemeAndSize)
{
    for (const ThemeName theme : {ThemeName::Day, ThemeName::NightRed, ThemeName::HighContrast}) {
        applyLook(*qApp, theme);  // a window keeps the theme with which it was made
        ASSERT_TRUE(opensAndSurveys());
        window->setRoom({1024, 600});
        ASSERT_TRUE(eventually([&] { return !window->isFittingFont(); }));
        window->resize(1024, 600);
        EXPECT_LE(window->minimumHeight(), 600);
        EXPECT_LE(window->minimumWidth(), 1024);
        const QByteArray folder = qgetenv("TERRATACT_PICTURES");
        if (!folder.isEmpty())
            window->grab().save(QString::fromLocal8Bit(folder)
                                + QStringLiteral("/import_%1.png").arg(static_cast<int>(theme)));
        for (const QWidget* control : std::initializer_list<QWidget*>{
                 page->checkButton(), page->importButton(), page->mappingChoice()}) {
            EXPECT_TRUE(control->isVisible());
            EXPECT_GE(control->width(), control->minimumSizeHint().width());
        }
    }
}

}  // namespace
}  // namespace terratact
