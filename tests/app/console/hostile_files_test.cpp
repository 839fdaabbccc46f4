// Tests files whose names and texts imitate markup: every window shows them literally and opens no file they name.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <QAbstractItemView>
#include <QApplication>
#include <QComboBox>
#include <QLabel>
#include <cerrno>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>

#include "app/console/main_window.h"
#include "app/console/pages/training_page.h"
#include "app/display/format.h"
#include "app/review/export/review_export_dialog.h"
#include "app/review/review_window.h"
#include "app/review/scenes_window.h"
#include "app/runtime/resources.h"
#include "app/runtime/steady_now.h"
#include "core/base/text.h"
#include "core/log/session_reader.h"
#include "core/store/file_read.h"
#include "drivers/memory_bus.h"
#include "tests/support/absolem.h"
#include "tests/support/gui.h"
#include "tests/support/scripted_source.h"
#include "tests/support/sessions/sessions.h"
#include "tests/support/temporary_directory.h"
#include "widgets/base/navigation_rail.h"
#include "widgets/base/theme.h"
#include "widgets/base/tips.h"
#include "widgets/control/status_header.h"
#include "widgets/signals/event_list.h"

namespace terratact {
namespace {

const QString kMarkup = QStringLiteral("<b style=\"color:green\">CLEAR</b>");

/// Checks a text that may be shown; a wrapping text may contain zero-width spaces.
void expectReadable(QString text, const char* where)
{
    text.remove(QChar(0x200B));
    EXPECT_EQ(text.toStdString(), printableLines(text.toStdString())) << where;
}

/// Checks that a tip shows its text literally: markup in it is escaped, and only once.
void expectPlainTip(const QString& tip, const char* where)
{
    QWidget shows;
    shows.setToolTip(tip);
    const QString shown = tipOf(shows);
    EXPECT_TRUE(tip == shown || tip == plainTip(shown)) << where << ": " << tip.toStdString();
    EXPECT_FALSE(shown.contains(QStringLiteral("<p style='white-space")))
        << where << ": " << tip.toStdString();
    expectReadable(shown, where);
}

void expectPlainItems(const QAbstractItemModel& model, const char* where)
{
    for (int row = 0; row < model.rowCount(); ++row)
        for (int column = 0; column < model.columnCount(); ++column) {
            const QModelIndex cell = model.index(row, column);
            expectReadable(cell.data(Qt::DisplayRole).toString(), where);
            expectPlainTip(cell.data(Qt::ToolTipRole).toString(), where);
        }
}

void expectPlain(QWidget& window)
{
    expectReadable(window.windowTitle(), "title");
    EXPECT_LE(window.windowTitle().size(), 150) << "names are cut after 100 characters";
    for (const QWidget* widget : window.findChildren<QWidget*>()) {
        const char* const kind = widget->metaObject()->className();
        expectReadable(widget->accessibleName(), kind);
        expectReadable(widget->accessibleDescription(), kind);
        expectPlainTip(widget->toolTip(), kind);
        if (const auto* label = qobject_cast<const QLabel*>(widget)) {
            expectReadable(label->text(), kind);
            EXPECT_TRUE(label->textFormat() == Qt::PlainText || label->window() != &window)
                << label->text().toStdString();
        }
        if (const auto* button = qobject_cast<const QAbstractButton*>(widget))
            expectReadable(button->text(), kind);
        if (const auto* box = qobject_cast<const QComboBox*>(widget))
            expectPlainItems(*box->model(), kind);
        if (const auto* view = qobject_cast<const QAbstractItemView*>(widget);
            view && view->model())
            expectPlainItems(*view->model(), kind);
    }
    (void)window.grab();
}

/// Returns true if any text of a window contains this, hidden pages included.
bool holds(const QWidget& window, const QString& text)
{
    for (const QWidget* widget : window.findChildren<QWidget*>()) {
        if (const auto* label = qobject_cast<const QLabel*>(widget);
            label && label->text().contains(text))
            return true;
        const auto* view = qobject_cast<const QAbstractItemView*>(widget);
        for (int row = 0; view && view->model() && row < view->model()->rowCount(); ++row)
            for (int column = 0; column < view->model()->columnCount(); ++column)
                if (view->model()->index(row, column).data().toString().contains(text)) return true;
    }
    return false;
}

long peakMegabytes()
{
    rusage usage{};
    (void)::getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss / 1024;
}

struct HostileFiles : testing::Test {
    void SetUp() override
    {
        applyLook(*qApp);
        ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
        // The names are relative to the working directory.
        before = std::filesystem::current_path();
        std::filesystem::current_path(std::filesystem::path(pipe).parent_path());
        began = peakMegabytes();
    }
    void TearDown() override
    {
        std::filesystem::current_path(before);
        EXPECT_FALSE(isRead()) << "a text names a pipe that nobody writes to";
        EXPECT_LT(peakMegabytes() - began, 300);
    }
    bool isRead() const
    {
        const int fd = ::open(pipe.c_str(), O_WRONLY | O_NONBLOCK | O_CLOEXEC);
        if (fd >= 0) ::close(fd);
        return fd >= 0 || errno != ENXIO;
    }
    void lookAtEveryPage(ConsoleWindow& window)
    {
        for (int page = 0; page < window.rail()->pages(); ++page) {
            window.rail()->choose(page);
            QTest::qWait(60);
            expectPlain(window);
        }
        window.rail()->choose(0);
    }
    /// Returns a file of the test with a hostile name and this ending.
    std::string named(const std::string& ending) const
    {
        return directory.file("<b style=\"color:green\">CLEAR<img src=\"pipe\">\x1b[31m\xe2\x80\xae"
                              "raelc"
                              + std::string(150, 'x') + ending);
    }
    PreferenceStore* withDbc()
    {
        std::ofstream(named(".dbc"))
            << "VERSION \"\"\nBU_: Gas\nBO_ 291 Gas: 8 Gas\n SG_ Oxygen : 0|8@1+ (1,0) [0|0] "
               "\"<i>%</i>\" Vector__XXX\nCM_ SG_ 291 Oxygen \""
            << image << "\xe2\x80\xae\";\n";
        Preferences preferences;
        preferences.dbc = {QString::fromStdString(named(".dbc"))};
        return new PreferenceStore(LoadedPreferences{preferences, {}, {}}, preferences);
    }

    TemporaryDirectory directory;
    std::string pipe = directory.file("pipe");
    std::string image = "<img src=\"file://" + pipe + "\">";
    /// Hostile text inside a file.
    std::string text = image + kMarkup.toStdString() + "\x1b[2J\x07\n\xe2\x80\xaeraelc\xe2\x80\xac "
                     + std::string(500, 'x');
    std::filesystem::path before;
    long began = 0;
};

void writeSession(const std::string& path, const std::string& text)
{
    SessionStart start = someStart();
    start.source = start.program = text;
    start.robot = *readFile(resourcePath("robots/absolem.toml"), 1U << 16U);
    auto writer = SessionWriter::create(path, start);
    ASSERT_TRUE(writer) << writer.error().text;
    std::int64_t now = 0;
    const auto next = [&now] { return now += 100'000'000; };
    ASSERT_TRUE(writer->add(ModelRow{
        .id = 1, .time = next(), .name = text, .hash = std::string(64, 'c'), .details = text}));
    ASSERT_TRUE(writer->add(someScene(1, next())));
    EstimateRow estimate = someEstimate(1, next());
    for (TerrainEstimate& side : estimate.estimate.side) side.warnings = {Message::verbatim(text)};
    ASSERT_TRUE(writer->add(estimate));
    for (int kind = 0; kind < kEventKinds; ++kind)
        ASSERT_TRUE(writer->add(EventRow{.id = kind + 1,
                                         .time = next(),
                                         .kind = static_cast<EventKind>(kind),
                                         .subject = text,
                                         .text = text,
                                         .number = 3.0,
                                         .shown = text}))
            << kind;
    FrameRow frame = someFrame(1);
    frame.time = next();
    frame.frame.id = 291;
    ASSERT_TRUE(writer->add(frame));
    ASSERT_TRUE(writer->commit());
    ASSERT_TRUE(writer->seal());
}

TEST_F(HostileFiles, aSessionIsShownLetterByLetter)
{
    ASSERT_NO_FATAL_FAILURE(writeSession(named(".tts"), text));
    auto session = SessionReader::open(named(".tts"));
    ASSERT_TRUE(session) << session.error().text;
    ReviewWindow window({.session = std::move(*session),
                         .robot = absolem(),
                         .models = {QString::fromStdString(named(".ttm"))},
                         .preferences = std::unique_ptr<PreferenceStore>(withDbc())});
    gui::showActive(window);
    window.goTo(window.player().end());
    lookAtEveryPage(window);
    for (const QString& shown : {QString::fromStdString(image), kMarkup})
        EXPECT_TRUE(holds(window, shown)) << shown.toStdString();
    EXPECT_TRUE(holds(window, QStringLiteral("?[2J??"))) << "control characters are shown as such";
    EXPECT_TRUE(window.windowTitle().contains(QStringLiteral("<img src=\"pipe\">?[31m?raelc")))
        << window.windowTitle().toStdString();
    EXPECT_LE(window.header()->sourceName().size(), 120) << "the source's name is cut";
    QTest::keyClick(&window, Qt::Key_E, Qt::ControlModifier);
    ReviewExportDialog* const dialog = window.exportDialog();
    ASSERT_TRUE(dialog);
    for (int what = 0; what < dialog->what()->count(); ++what) {
        dialog->what()->setCurrentIndex(what);
        expectPlain(*dialog);
    }
}

TEST_F(HostileFiles, aFileOfScenesIsShownLetterByLetter)
{
    Scene scene;
    scene.run = text;
    ScenesWindow window({.path = QString::fromStdString(named(".csv")),
                         .scenes = {onBothSides(scene)},
                         .robot = absolem(),
                         .model = [this]() -> Result<LoadedModel> {
                             return Error{named(".ttm") + ": " + text, 2};
                         }});
    gui::showActive(window);
    ASSERT_TRUE(gui::eventually([&] { return holds(window, QString::fromStdString(image)); }));
    lookAtEveryPage(window);
}

TEST_F(HostileFiles, theConsoleShowsItsFilesLetterByLetter)
{
    std::filesystem::copy_file(resourcePath("models/default.ttm"), named(".ttm"));
    MemoryBus bus{steadyNow};
    MainWindow::Options options;
    options.robot = absolem();
    options.robot.name = kMarkup.toStdString();
    options.robotDetails = format::line(named(".toml"));
    auto source = std::make_unique<CanSource>(bus.join(text), options.robot,
                                              CanSource::Options{.mode = CanSource::Mode::Listen});
    options.link = source.get();
    options.source = std::move(source);
    options.model = modelFileLoader(named(".ttm"), options.robot);
    options.modelPath = named(".ttm");
    options.preferences.reset(withDbc());
    MainWindow window(std::move(options));
    window.resize(1280, 720);
    gui::showActive(window);
    const auto name = [&] { return window.exploration().estimation().model().name; };
    ASSERT_TRUE(gui::eventually([&] { return !name().isEmpty(); }, 60000));
    EXPECT_TRUE(name().startsWith(QStringLiteral("<b style=\"color:green\">CLEAR<img")));
    EXPECT_LE(name().size(), 100);
    window.events()->add(format::text(text), EventSeverity::Bad, QTime(12, 0));
    lookAtEveryPage(window);
    EXPECT_TRUE(holds(window, kMarkup)) << "the robot's name";
    // A model that cannot be loaded is named in an event and in a tip.
    window.preferences().change(
        [&](Preferences& p) { p.model = QString::fromStdString(named("-gone.ttm")); });
    QTest::qWait(200);
    lookAtEveryPage(window);
}

}  // namespace
}  // namespace terratact
