// Tests the files that a review writes, and its export dialog.
#include <gtest/gtest.h>

#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QFileInfo>
#include <QLabel>
#include <algorithm>
#include <cstdint>
#include <vector>

#include "app/pages/numbers_page.h"
#include "app/pages/terrain_page.h"
#include "app/review/review_export.h"
#include "app/review/review_export_dialog.h"
#include "app/review/review_signals_page.h"
#include "app/review/review_window.h"
#include "core/store/file_write.h"
#include "tests/support/gui.h"
#include "tests/support/review_bench.h"
#include "tests/support/robot_session.h"
#include "tests/support/temporary_directory.h"
#include "widgets/base/navigation_rail.h"
#include "widgets/base/theme.h"
#include "widgets/signals/signal_table.h"
#include "widgets/terrain/numbers_table.h"
#include "widgets/terrain/terrain_profile_view.h"

namespace terratact {
namespace {

using namespace gui;
using At = RobotSessionTimes;

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
    for (const Qt::Key theme : {Qt::Key_6, Qt::Key_4})  // fits the font to the remaining room
        QTest::keyClick(window.get(), theme, Qt::ControlModifier);
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

struct ExportOf : ReviewOf {
    /// Opens the dialog with its key.
    ReviewExportDialog& ask()
    {
        press(Qt::Key_E, Qt::ControlModifier);
        return *window->exportDialog();
    }
    /// Chooses list entries by their text, and sets the file name.
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
    /// Returns the output of the command line.
    std::string commandWrites(const std::string& name, const ExportSelection& selection)
    {
        auto session = SessionReader::open(path.toStdString());
        const std::string to = directory.file(name);
        EXPECT_TRUE(writeExport(*session, to, *exportFormatOf(to), selection));
        return *readFile(to, 1U << 26U);
    }
    QStringList files() { return QDir(QFileInfo(path).path()).entryList(QDir::Files); }
};

TEST_F(ExportOf, visibleAndWholeExportsEqualTheCommandLines)
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

/// A session with frames of a gas sensor and a battery, and their DBC file.
struct PayloadOf : ExportOf {
    static QString dbcFile()
    {
        return QStringLiteral(TERRATACT_SOURCE_DIR "/docs/can_payload.dbc");
    }
    void record()
    {
        auto writer = robotSession(path.toStdString(), 4.0);
        ASSERT_TRUE(writer) << writer.error().text;
        const auto add = [&](double seconds, std::uint32_t id, bool extended,
                             std::vector<std::uint8_t> bytes) {
            CanFrame frame;
            frame.id = id;
            frame.extended = extended;
            frame.length = static_cast<std::uint8_t>(bytes.size());
            std::copy(bytes.begin(), bytes.end(), frame.data.begin());
            ASSERT_TRUE(writer->add(FrameRow{.time = sessionTimeOf(seconds), .frame = frame}));
        };
        add(4.0, 0x500, false, {0x00, 0xEB, 0xCF, 0xFD, 0xD0, 0x01});
        add(4.1, 0x18FED101, true, {0x00, 0xAB, 0x63, 0x62, 0, 0, 0, 0});
        add(4.2, 0x18FED101, true, {0x01, 0, 0, 0, 0, 0x80, 0x3B, 0x43});
        add(4.3, 0x501, false, {0x01, 0x02});
        add(4.5, 0x500, false, {0x00, 0xF3, 0xCE, 0xFD, 0xD0, 0x01});
        ASSERT_TRUE(writer->seal());
    }
    QString valueOf(const QString& name) const
    {
        const SignalTable& table = *window->signalsPage()->table();
        for (int row = 0; row < table.rows(); ++row)
            if (table.text(row, SignalTable::Name) == name)
                return table.text(row, SignalTable::Value);
        return QStringLiteral("no such row");
    }
};

TEST_F(PayloadOf, theReviewShowsWhatOtherDevicesHadSent)
{
    applyLook(*qApp);
    record();
    open();
    window->preferences().change([](Preferences& p) { p.dbc = {dbcFile()}; });
    window->goTo(4.25);
    press(Qt::Key_F7);
    ASSERT_TRUE(eventually([&] { return valueOf("Oxygen") == "20.7"; }));
    EXPECT_EQ(valueOf("CarbonMonoxide"), "23.5");
    EXPECT_EQ(valueOf("State"), "ready");
    EXPECT_EQ(valueOf("Voltage"), "25.187") << "of a multiplexor's other half";
    EXPECT_EQ(valueOf("Power"), "187.5");
    EXPECT_EQ(cutWhenSettled(), std::vector<std::string>());
    window->goTo(4.4);
    EXPECT_EQ(valueOf("Oxygen"), "--") << "it comes every 0.1 s, and has not for 0.4 s";
    EXPECT_EQ(valueOf("Power"), "187.5") << "comes when it likes";
    window->goTo(4.5);
    EXPECT_EQ(valueOf("Oxygen"), "20.6") << "at this time";
    window->goTo(3.9);
    EXPECT_EQ(window->signalsPage()->table()->rows(), 0);
    EXPECT_TRUE(window->signalsPage()->headline()->text().startsWith("No other device"));
    window->goTo(4.5);
    window->preferences().change([](Preferences& p) { p.dbc.clear(); });
    EXPECT_TRUE(eventually([&] { return valueOf("Oxygen") == "no such row"; }));
    EXPECT_GT(window->signalsPage()->table()->rows(), 0) << "their bytes";
}

TEST_F(PayloadOf, signalsAreExportedWithThoseOfDbcFiles)
{
    record();
    open();
    choose("Signals", ".csv", "none.csv");
    EXPECT_FALSE(window->exportDialog()->withPayload()->isEnabled()) << "no DBC file is chosen";
    window->preferences().change([](Preferences& p) { p.dbc = {dbcFile()}; });
    const auto book = readDbcBook(CanProtocol::Terratact, {dbcFile().toStdString()});
    ASSERT_TRUE(book);
    for (const char* format : {"csv", "mcap"}) {
        const std::string name = std::string("payload.") + format;
        choose("Signals", QStringLiteral(".") + format, name);
        EXPECT_TRUE(window->exportDialog()->withPayload()->isEnabled());
        QTest::mouseClick(window->exportDialog()->wholeSession(), Qt::LeftButton);
        write();
        EXPECT_EQ(written(name),
                  commandWrites("command-" + name, {.what = ExportKind::Signals, .book = *book}));
    }
    EXPECT_NE(written("payload.csv").find("GasSensor.Oxygen [%]"), std::string::npos);
    choose("Signals", ".csv", "without.csv");
    window->exportDialog()->withPayload()->setChecked(false);
    write();
    EXPECT_EQ(written("without.csv").find("GasSensor"), std::string::npos);
    choose("CAN frames", ".csv", "frames.csv");
    EXPECT_FALSE(window->exportDialog()->withPayload()->isEnabled()) << "frames hold no signals";
}

TEST_F(PayloadOf, aDbcFileThatIsGoneStopsTheExport)
{
    record();
    open();
    window->preferences().change([](Preferences& p) { p.dbc = {"/nowhere/gone.dbc"}; });
    choose("Signals", ".csv", "none.csv");
    QTest::mouseClick(window->exportDialog()->exportButton(), Qt::LeftButton);
    ASSERT_TRUE(eventually([&] { return !window->exportDialog()->writes(); }));
    const QString said = window->exportDialog()->resultLabel()->text();
    EXPECT_TRUE(said.startsWith("NOT WRITTEN") && said.contains("gone.dbc")) << said.toStdString();
    EXPECT_FALSE(files().contains("none.csv"));
}

TEST_F(ExportOf, defaultNamesDifferAndGoToTheDocuments)
{
    const QByteArray home = qgetenv("HOME"), config = qgetenv("XDG_CONFIG_HOME");
    qputenv("HOME", QByteArray::fromStdString(directory.file("home")));
    qunsetenv("XDG_CONFIG_HOME");
    const QString documents = QString::fromStdString(directory.file("home/Documents"));
    ASSERT_TRUE(QDir().mkpath(documents));
    record();
    open();
    QSet<QString> names;
    for (const double at : {At::kScene, At::kMarker}) {
        window->goTo(at);
        ReviewExportDialog& dialog = ask();
        for (int what = 0; what < dialog.what()->count(); ++what) {
            dialog.what()->setCurrentIndex(what);
            const QString name = dialog.pathEdit()->text();
            EXPECT_EQ(QFileInfo(name).absolutePath(), documents);
            static const QRegularExpression kSecond(QStringLiteral("-[0-9]+[.][0-9]s[.]"));
            if (at == At::kScene || name.contains(kSecond)) {
                EXPECT_FALSE(names.contains(name)) << name.toStdString();
            }
            names << name;
        }
        dialog.close();
    }
    EXPECT_GE(names.size(), 8);
    qputenv("HOME", home);
    if (!config.isNull()) qputenv("XDG_CONFIG_HOME", config);
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
    choose("Report", ".html", "report");  // the dialog adds the ending
    write();
    EXPECT_NE(written("report.html").find("Scene 1 of review.tts"), std::string::npos);
    window->goTo(0.0);
    choose("Report", ".html", "none.html");
    EXPECT_FALSE(window->exportDialog()->exportButton()->isEnabled()) << "no estimate stands";
}

TEST_F(ExportOf, aDisabledButtonSaysWhy)
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
        tips.poll(*window);
    }
    window->goTo(0.0);
    choose("Report", ".html", "report.html");
    ReviewExportDialog& dialog = *window->exportDialog();
    tips.poll(dialog);
    EXPECT_EQ(dialog.exportButton()->toolTip(), "No estimate stands at this time");
    choose("Frames, signals", ".mcap", "");
    dialog.pathEdit()->clear();
    tips.poll(dialog);
    EXPECT_EQ(dialog.exportButton()->toolTip(), "Name the file first");
    choose("Frames, signals", ".mcap", "big.mcap");
    tips.poll(dialog);
    QTest::mouseClick(dialog.exportButton(), Qt::LeftButton);
    ASSERT_TRUE(dialog.writes());
    tips.poll(dialog);
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

TEST_F(ExportOf, dialogCutsNoTextAndNamesEveryControl)
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
            EXPECT_GE(std::min(widget->width(), widget->height()), 32)
                << widget->metaObject()->className();
        }
    }
    applyLook(*qApp);
}

TEST_F(ExportOf, cancelledExportLeavesNoFileAndBlocksNothing)
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
    window.reset();  // closes the window during the export
    EXPECT_EQ(files(), before);
}

}  // namespace
}  // namespace terratact
