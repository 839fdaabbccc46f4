#include "tests/app/console/screens/screens.h"

#include <qwt_legend.h>

#include <QAction>
#include <QApplication>
#include <QMenu>
#include <QPainter>
#include <QPushButton>
#include <QRegularExpression>
#include <QScrollBar>
#include <algorithm>
#include <iterator>
#include <map>

#include "app/display/format.h"
#include "app/runtime/resources.h"
#include "app/start/language.h"
#include "core/log/session_reader.h"
#include "core/sim/ground/terrain_shapes.h"
#include "tests/app/console/screens/screens_texts.h"
#include "tests/support/benches/arming.h"
#include "tests/support/gui.h"
#include "tests/support/held_estimate.h"
#include "tests/support/sessions/sessions.h"
#include "tests/support/toy_model.h"
#include "widgets/base/held_button.h"
#include "widgets/base/theme.h"
#include "widgets/control/arming_control.h"
#include "widgets/control/atem_panel.h"
#include "widgets/control/probe_card.h"
#include "widgets/control/status_header.h"

namespace terratact {
namespace {

using gui::eventually;

constexpr double kSpeed = 10.0;   // simulated seconds per second
constexpr int kHold = 1500;       // [ms] hold time that is pictured at its half
constexpr int kSettles = 50;      // [ms] until the whole window is repainted
constexpr int kPatience = 60000;  // [ms]
constexpr const char* kLanguages[]{"en", "cs", "de"};

const Chapter& chapterOfThisTest()
{
    const std::string test = testing::UnitTest::GetInstance()->current_test_info()->name();
    const auto found = std::ranges::find(chapters(), test, &Chapter::name);
    if (found == chapters().end()) throw std::logic_error("no chapter is called " + test);
    return *found;
}

SimulatedRobot simulated(const RobotModel& model, const Screens::Setting& setting)
{
    SimulatedRobot::Options options;
    options.startX = kDemoStep - setting.before;
    options.probeSeconds = 3.0;
    SimulatedRobot robot(model, demoTerrain(), options);
    if (!setting.isPressed) return robot;
    robot.command(PressCommand{18.0});
    for (int i = 0; i < 1000 && robot.activity() != RobotActivity::Pressed; ++i) robot.step(0.05);
    return robot;
}

}  // namespace

Screens::Screens() : chapter_(chapterOfThisTest())
{
    QApplication::setApplicationVersion("0.0");
    applyLook(*qApp);
}

Screens::~Screens()
{
    close();
    installLanguage(*qApp, "en");
    applyLook(*qApp);
}

void Screens::close()
{
    holdsEstimates = false;
    scenes.reset();
    review.reset();
    console.reset();  // its source uses the bus
    robot.reset();
    board.reset();
    sessions_.reset();
    applyLook(*qApp);
}

void Screens::inEveryLanguage(const std::function<void()>& tour)
{
    const std::string only = qEnvironmentVariable("TERRATACT_LANGUAGE").toStdString();
    for (const char* language : kLanguages) {
        if ((!only.empty() && language != only) || HasFailure()) continue;
        ASSERT_EQ(installLanguage(*qApp, language), QLatin1String(language));
        const testing::ScopedTrace trace(__FILE__, __LINE__, language);
        language_ = language;
        said.clear();
        taken_.clear();
        alterEstimates({});
        tour();
        close();
        for (const std::string_view name : chapter_.pictures)
            EXPECT_EQ(taken_.count(name), 1U) << "pictures of " << name;
        compareWithEnglish();
    }
}

void Screens::compareWithEnglish()
{
    if (language_ == "en") english_ = said;
    for (const std::string& text : said)
        EXPECT_TRUE(language_ == "en" || !english_.contains(text) || isSameEverywhere(text))
            << text;
}

void Screens::unsay(const QString& recorded)
{
    static const QRegularExpression kDigits(QStringLiteral("[0-9]+"));
    for (QString line : recorded.split(QLatin1Char('\n')))
        for (const std::string& part :
             partsOf(line.replace(kDigits, QStringLiteral("#")).trimmed().toStdString()))
            said.erase(part);
}

ConsoleWindow& Screens::window() const
{
    if (console) return *console;
    if (review) return *review;
    return *scenes;
}

bool Screens::reads(const QString& text) const
{
    return missingIn(gui::readableTexts(window()), {text}).isEmpty();
}

QImage Screens::paintedWindow() const
{
    window().finishFitting();  // a late layout may have begun it again
    return gui::painted(window());
}

void Screens::picture(std::string_view name, const QStringList& says)
{
    poll(name, says);
    save(paintedWindow(), name);
}

void Screens::pictureWith(QWidget& above, std::string_view name, const QStringList& says)
{
    poll(name, says, &above);
    QImage image = paintedWindow();
    if (above.isWindow()) {
        const QImage sheet = gui::painted(above);
        QPainter painter(&image);
        painter.drawImage((image.width() - sheet.width()) / 2,
                          (image.height() - sheet.height()) / 2, sheet);
    }
    save(image, name);
}

void Screens::pictureOfMenu(QPushButton& button, std::string_view name, const QStringList& says)
{
    ASSERT_TRUE(button.isVisible() && button.menu()) << name;
    QMenu& menu = *button.menu();
    menu.popup({});
    ASSERT_TRUE(eventually([&] { return menu.isVisible(); })) << name;
    QStringList lines;
    for (const QAction* action : menu.actions()) lines << action->text();
    for (const QString& text : missingIn(lines, says))
        ADD_FAILURE() << name << " does not say: " << text.toStdString();
    EXPECT_EQ(menu.size().expandedTo(menu.sizeHint()), menu.size()) << name << ": lines are cut";
    QImage image = paintedWindow();
    // The menu opens below the button, or above it, and never beyond the window.
    QRect place(button.mapTo(&window(), QPoint(0, button.height())), menu.size());
    if (place.bottom() > image.height()) place.moveBottom(place.top() - button.height());
    place.moveRight(std::min(place.right(), image.width() - 1));
    place.moveTop(std::max(place.top(), 0));
    EXPECT_TRUE(image.rect().contains(place)) << name << " has no room";
    QPainter(&image).drawImage(place.topLeft(), gui::painted(menu));
    menu.close();
    poll(name, {button.text()});
    save(image, name);
}

void Screens::poll(std::string_view name, const QStringList& says, QWidget* above)
{
    const auto untidy = [&] {
        auto found = gui::cutText(window());
        if (!above) std::ranges::copy(gui::overlaps(window()), std::back_inserter(found));
        if (above && above->isWindow())
            std::ranges::copy(gui::cramped(*above), std::back_inserter(found));
        for (const auto* legend : window().findChildren<QwtLegend*>())
            if (legend->isVisible() && legend->verticalScrollBar()->isVisible())
                found.emplace_back("a legend has no room for all of it");
        return found;
    };
    const auto unsaid = [&] {
        QStringList texts = gui::readableTexts(window());
        if (above && above->isWindow()) texts << gui::readableTexts(*above);
        return missingIn(texts, says);
    };
    EXPECT_FALSE(says.isEmpty()) << name << ": what does it show?";
    (void)eventually([&] { return unsaid().isEmpty(); }, 15000);
    EXPECT_TRUE(eventually([&] { return !window().isFittingFont(); }))
        << "the letters are not fitted";
    QTest::qWait(kSettles);
    // A busy machine lays out late, and may lose the link for a moment.
    (void)eventually([&] { return unsaid().isEmpty() && untidy().empty(); });
    for (const QString& text : unsaid())
        ADD_FAILURE() << name << " does not say: " << text.toStdString()
                      << "\nbut says: " << gui::readableTexts(window()).join(" | ").toStdString();
    for (const std::string& text : untidy()) ADD_FAILURE() << "in " << name << ": " << text;
    if (console) {
        EXPECT_TRUE(console->header()->stopButton()->isVisible()) << name;
    }
    for (const QWidget* seen : std::initializer_list<const QWidget*>{&window(), above}) {
        if (!seen) continue;
        for (const std::string& text : gui::textsOf(*seen))
            if (!isWordsOfAFile(text)) said.merge(partsOf(text));
    }
}

void Screens::save(const QImage& image, std::string_view name)
{
    EXPECT_GT(gui::colours(image), 20) << name;
    taken_.insert(name);
    const QString file = pictureFile(name);
    EXPECT_FALSE(file.isEmpty()) << "no chapter has " << name;
    const QString folder = qEnvironmentVariable("TERRATACT_PICTURES");
    if (folder.isEmpty()) return;
    const QString prefix = language_ == "en" ? QString() : QString::fromStdString(language_ + "_");
    EXPECT_TRUE(image.save(folder + "/" + prefix + file + ".png"));
}

Result<LoadedModel> Screens::shipped() const
{
    static std::map<std::string, Result<LoadedModel>>
        inLanguage;  // loaded once, because it takes long
    const std::string key = language_ + modelFile;
    const auto found = inLanguage.find(key);
    if (found != inLanguage.end()) return found->second;
    const ModelLoader load = modelFileLoader(resourcePath("models/" + modelFile), model);
    return inLanguage.emplace(key, load()).first->second;
}

ModelLoader Screens::altered()
{
    return [this]() -> Result<LoadedModel> {
        auto loaded = shipped();
        if (!loaded) return loaded;
        LoadedModel changed = *loaded;
        changed.estimate = [this, estimate = changed.estimate](const EstimateRequest& request,
                                                               const Watch& watch) {
            if (holdsEstimates) watch.progress(0.4);
            waitWhile([this] { return holdsEstimates.load(); }, watch);
            TwoTrackEstimate made = estimate(request, watch);
            const std::scoped_lock lock(mutex_);
            for (TerrainEstimate& side : made.side)
                if (alters_) alters_(side);
            return made;
        };
        return changed;
    };
}

void Screens::alterEstimates(std::function<void(TerrainEstimate&)> how)
{
    const std::scoped_lock lock(mutex_);
    alters_ = std::move(how);
}

void Screens::open(const Setting& setting)
{
    close();
    sessions_ = std::make_unique<TemporaryDirectory>();
    robot = std::make_unique<StagedRobot>(bus, model, simulated(model, setting),
                                          RobotOnBus::Options{.firstEpoch = 9, .speed = kSpeed},
                                          [this] { return clock.now(); });
    robot->stage(setting.staging);
    const auto recorder = std::make_shared<SessionRecorder>(SessionRecorder::Options{
        .folder = setting.sessions.empty() ? sessions_->file("sessions") : setting.sessions,
        .start = someStart(),
        .patience = kBusyDisk});
    const bool transmits = setting.mode == CanSource::Mode::Transmit;
    auto source = std::make_unique<CanSource>(
        bus.join(setting.busName), model,
        CanSource::Options{
            .mode = setting.mode,
            .name = transmits ? "SIMULATED ROBOT" : "",
            .truth = [this] { return robot->truth(); },
            .bitrate = 500e3,
            .received = [recorder](std::span<const BusFrame> frames) { recorder->add(frames); },
            .clock = [this] { return clock.now(); }});
    MainWindow::Options options;
    options.training.nice = 0;  // at the lowest priority, a busy machine never ends it
    options.robot = model;
    options.link = source.get();
    options.inputClock = [this] { return clock.now(); };
    options.source = std::move(source);
    options.model = setting.model ? setting.model : altered();
    options.modelPath = resourcePath("models/default.ttm");
    options.robotDetails = QStringLiteral("robots/absolem.toml");
    options.recorder = recorder;
    options.exploration.linkLostAfter = options.exploration.staleAfter = setting.linkLostAfter;
    options.exploration.limits = setting.limits;
    options.exploration.driveSpeed = 0.03;
    Preferences preferences;
    preferences.probeAbove = 0.03;
    options.exploration.settings = withPreferences({}, preferences);
    options.preferences =
        std::make_unique<PreferenceStore>(LoadedPreferences{preferences, {}, {}}, preferences);
    options.presets = *readPresets(resourcePath("models/default.presets.csv"));
    if (setting.hasPanel) {
        board = std::make_unique<PanelBoard>();
        options.panel = std::make_unique<OperatorPanel>(
            PanelConfig{}, [this](const GpioRequest&) { return board->open(); });
    }
    if (setting.hasGamepad) options.gamepad = desk.gamepad();
    console = std::make_unique<MainWindow>(std::move(options));
    if (setting.safeMode) console->showSafeMode();
    show(*console);
    (void)eventually([&] { return console->probeCard()->isVisible(); },
                     5000);  // waits for its size
}

void Screens::show(ConsoleWindow& opened)
{
    opened.setRoom({1440, 900});
    opened.resize(1440, 900);
    gui::showActive(opened);
}

void Screens::openReview()
{
    close();
    auto session = SessionReader::open(resourcePath("sessions/demo.tts"));
    ASSERT_TRUE(session) << session.error().text;
    review = std::make_unique<ReviewWindow>(ReviewWindow::Options{
        .session = std::move(*session),
        .robot = model,
        .models = {QString::fromStdString(resourcePath("models/default.ttm"))}});
    show(*review);
}

void Screens::openScenes()
{
    close();
    scenes = std::make_unique<ScenesWindow>(
        ScenesWindow::Options{.path = "seen/scenes.csv",
                              .scenes = onBothSides(someScenes(3, 5)),
                              .robot = model,
                              .model = altered()});
    show(*scenes);
}

void Screens::press(int key, Qt::KeyboardModifiers with)
{
    QTest::keyClick(&window(), static_cast<Qt::Key>(key), with);
}

void Screens::arm()
{
    console->header()->arming()->confirmButton()->setHoldTime(1);
    ASSERT_TRUE(arms(*console)) << describe(console->link()->view().link.arming.cause).english;
    ASSERT_TRUE(eventually([&] { return console->exploration().armed(); }, kPatience));
}

bool Screens::reaches(AtemPhase phase)
{
    return eventually([&] { return console->exploration().state().phase == phase; }, kPatience);
}

void Screens::explore()
{
    Exploration& exploration = console->exploration();
    const auto phase = [&] { return exploration.state().phase; };
    ASSERT_NO_FATAL_FAILURE(arm());
    if (exploring(phase())) exploration.abort();
    ASSERT_TRUE(
        eventually([&] { return console->atemPanel()->requestButton()->isEnabled(); }, kPatience));
    press(Qt::Key_A);
    ASSERT_TRUE(eventually([&] { return exploring(phase()); }, kPatience));
    ASSERT_TRUE(eventually(
        [&] { return phase() == AtemPhase::ProposingProbe || !exploring(phase()); }, kPatience));
    ASSERT_EQ(phase(), AtemPhase::ProposingProbe)
        << describe(phase()).english << ": " << exploration.stateText().english();
    ASSERT_TRUE(eventually(
        [&] { return console->probeCard()->shown() || phase() != AtemPhase::ProposingProbe; },
        kPatience));
}

void Screens::exploreWithoutProbe()
{
    Exploration& exploration = console->exploration();
    const auto phase = [&] { return exploration.state().phase; };
    ASSERT_NO_FATAL_FAILURE(arm());
    ASSERT_TRUE(
        eventually([&] { return console->atemPanel()->requestButton()->isEnabled(); }, kPatience));
    press(Qt::Key_A);
    ASSERT_TRUE(eventually([&] { return exploring(phase()); }, kPatience));
    ASSERT_TRUE(eventually([&] { return !exploring(phase()); }, kPatience));
    ASSERT_TRUE(exploration.estimation().estimate())
        << describe(exploration.state().failure).english;
}

void Screens::approve()
{
    ASSERT_TRUE(console->exploration().proposal());
    console->exploration().approve(console->exploration().proposal()->id);
}

void Screens::holdAtHalf(HoldToConfirmButton& button, Qt::Key key, std::string_view name,
                         const QStringList& says)
{
    button.setHoldTime(kHold);
    QTest::keyPress(&window(), key);
    ASSERT_TRUE(eventually([&] { return button.share() >= 0.4; })) << name;
    picture(name, says);
    EXPECT_TRUE(button.isHeld() && button.share() < 0.9) << name << ": " << button.share();
}

}  // namespace terratact
