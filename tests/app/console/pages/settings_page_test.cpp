// Tests that changes on the settings page take effect at once.
#include "app/console/pages/settings_page.h"

#include <gtest/gtest.h>

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QWheelEvent>
#include <algorithm>
#include <filesystem>
#include <numbers>
#include <vector>

#include "app/console/main_window.h"
#include "app/start/language.h"
#include "core/learn/model/file/model_file.h"
#include "core/log/session_reader.h"
#include "core/sim/ground/terrain_shapes.h"
#include "tests/support/absolem.h"
#include "tests/support/estimates.h"
#include "tests/support/gui.h"
#include "tests/support/sim_source.h"
#include "tests/support/temporary_directory.h"
#include "tests/support/toy_model.h"
#include "widgets/base/theme.h"
#include "widgets/control/atem_panel.h"
#include "widgets/signals/event_list.h"
#include "widgets/terrain/readings/verdict_strip.h"

namespace terratact {
namespace {

using gui::eventually;

/// Records the commands it receives; the record outlives the window that owned it.
class WitnessedRobot final : public MeasurementSource {
public:
    WitnessedRobot(const SimulatedRobot& robot, std::vector<Command>& told)
        : robot_(robot, 1.0), told_(told)
    {
    }
    std::string name() const override { return robot_.name(); }
    Result<std::optional<Sample>> next(std::chrono::milliseconds patience) override
    {
        return robot_.next(patience);
    }
    Status send(const Command& command) override
    {
        told_.push_back(command);
        return robot_.send(command);
    }

private:
    SimSource robot_;
    std::vector<Command>& told_;
};

struct SettingsInForce : testing::Test {
    SettingsInForce()
    {
        MainWindow::Options options;
        options.robot = absolem();
        SimulatedRobot::Options simulation;
        simulation.startX = 2.0;
        options.source = std::make_unique<WitnessedRobot>(
            SimulatedRobot(options.robot, demoTerrain(), simulation), told);
        options.exploration.linkLostAfter = 3.0;  // long, because the machine may be busy
        options.model = [] {
            return Result<LoadedModel>(
                LoadedModel{.estimate = [](const EstimateRequest&,
                                           const Watch&) { return equalSides(stepEstimate()); },
                            .name = "fake.ttm",
                            .details = {},
                            .content = "measured"});
        };
        options.recorder = std::make_shared<SessionRecorder>(SessionRecorder::Options{
            .folder = directory.file("sessions"), .start = {}, .patience = kBusyDisk});
        options.presets = {
            "measured",
            {{Method::Local, QualityPreset::Fast, 250, 16, 16, 175, 0.5, 0.0, 25.0, 1.0},
             {Method::Pac, QualityPreset::Fast, 250, 16, 16, 175, 4.0, 11.3, 34.0, 0.13}}};
        window = std::make_unique<MainWindow>(std::move(options));
        gui::showActive(*window);
        QTest::keyClick(window.get(), Qt::Key_F7);
    }
    ~SettingsInForce() override
    {
        applyLook(*qobject_cast<QApplication*>(QApplication::instance()));
    }
    const Settings& inForce() const { return window->exploration().options().settings; }
    SettingsPage& page() const { return *window->settings(); }
    template <class T>
    bool wasTold() const
    {
        return std::ranges::any_of(told,
                                   [](const Command& c) { return std::holds_alternative<T>(c); });
    }
    void explore()
    {
        ASSERT_TRUE(eventually([&] { return window->atemPanel()->requestButton()->isEnabled(); }));
        window->exploration().request();
        ASSERT_TRUE(eventually([&] { return exploring(window->exploration().state().phase); }));
        told.clear();
    }

    /// Ends the recording and returns the recorded decisions about `subject`.
    std::vector<std::string> decisions(const std::string& subject)
    {
        window.reset();
        std::vector<std::string> found;
        for (const auto& file : std::filesystem::directory_iterator(directory.file("sessions"))) {
            if (file.path().extension() != ".tts") continue;
            auto session = SessionReader::open(file.path().string());
            EXPECT_TRUE(session) << session.error().text;
            if (!session) continue;
            for (const EventRow& row : session->events())
                if (row.kind == EventKind::Decision && row.subject == subject)
                    found.push_back(row.text);
        }
        return found;
    }

    TemporaryDirectory directory;
    std::vector<Command> told;
    std::unique_ptr<MainWindow> window;
};

TEST_F(SettingsInForce, methodQualityAndLimitsReachTheNextEstimate)
{
    ASSERT_TRUE(page().isVisible());
    page().methodBox()->setCurrentText("pafc");
    EXPECT_EQ(inForce().method, Method::Pafc);
    page().qualityBox()->setCurrentIndex(static_cast<int>(QualityPreset::Accurate));
    EXPECT_EQ(inForce().draws, withPreset(Settings{}, QualityPreset::Accurate).draws);
    page().thresholdBox()->setValue(3.5);
    EXPECT_EQ(inForce().forceThreshold, 3.5);
    page().obstacleBox()->setValue(0.20);
    EXPECT_NEAR(window->exploration().options().stepLimit, 0.20, 1e-12);
    EXPECT_NEAR(window->verdict()->limit(), 0.20, 1e-12);
    EXPECT_EQ(window->preferences().current().method, Method::Pafc);
    EXPECT_EQ(window->exploration().options().seconds, 0.0) << "off until somebody wants it";
    page().secondsBox()->setValue(5);
    EXPECT_EQ(window->exploration().options().seconds, 5.0);
}

TEST_F(SettingsInForce, aSettingChangesNoOther)
{
    const Preferences before = window->preferences().current();
    page().thresholdBox()->setValue(3.5);
    Preferences wanted = before;
    wanted.forceThreshold = 3.5;
    EXPECT_EQ(window->preferences().current(), wanted)
        << "limits finer than their boxes show, such as 0.1 rad, stay as they are";
}

TEST_F(SettingsInForce, theWheelChangesOnlyTheBoxWithTheFocus)
{
    const auto turn = [](QWidget& over) {
        QWheelEvent wheel(QPointF(5, 5), over.mapToGlobal(QPointF(5, 5)), {}, QPoint(0, -120),
                          Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
        QApplication::sendEvent(&over, &wheel);
    };
    const Preferences before = window->preferences().current();
    for (QWidget* box : std::initializer_list<QWidget*>{page().methodBox(), page().themeBox(),
                                                        page().thresholdBox()}) {
        turn(*box);
        EXPECT_FALSE(box->hasFocus());
    }
    EXPECT_EQ(window->preferences().current(), before);
    page().thresholdBox()->setFocus();
    turn(*page().thresholdBox());
    EXPECT_LT(window->preferences().current().forceThreshold, before.forceThreshold);
}

TEST_F(SettingsInForce, theThemeChangesAtOnceAndBackAgain)
{
    page().themeBox()->setCurrentIndex(static_cast<int>(ThemeName::NightRed));
    EXPECT_EQ(window->preferences().current().theme, ThemeName::NightRed);
    const QColor night = theme().card;
    page().themeBox()->setCurrentIndex(static_cast<int>(ThemeName::Day));
    EXPECT_NE(theme().card, night);
}

TEST_F(SettingsInForce, aQualityShowsItsCostOrThatNoneWasMeasured)
{
    EXPECT_TRUE(eventually([&] { return page().qualityBox()->itemText(0).contains("0.5 ms"); }));
    EXPECT_TRUE(page().qualityBox()->itemText(0).contains("(exact)"));
    EXPECT_TRUE(page().qualityBox()->itemText(1).contains("not measured"));
    page().methodBox()->setCurrentText("pafc");
    EXPECT_TRUE(page().qualityBox()->itemText(0).contains("not measured"));
    page().methodBox()->setCurrentText("pac");
    EXPECT_TRUE(page().qualityBox()->itemText(0).contains("± 11.3 mm"));
}

TEST_F(SettingsInForce, qualityCostsAreShownForTheMeasuredModelOnly)
{
    const auto costs = [&] { return page().qualityBox()->itemText(0).contains("0.5 ms"); };
    ASSERT_TRUE(eventually(costs));
    const std::string other = directory.file("other.ttm");
    ASSERT_TRUE(writeModel(other, toyModel(4)));
    window->preferences().change([&](Preferences& p) { p.model = QString::fromStdString(other); });
    EXPECT_TRUE(eventually([&] { return !costs(); }));
}

TEST_F(SettingsInForce, pageFollowsChangesOfPreferences)
{
    window->preferences().change([](Preferences& p) { p.forceThreshold = 4.0; });
    EXPECT_EQ(page().thresholdBox()->value(), 4.0);
    EXPECT_EQ(inForce().forceThreshold, 4.0);
}

TEST_F(SettingsInForce, aModelThatCannotBeLoadedLeavesTheOneInUse)
{
    ASSERT_TRUE(eventually([&] { return page().modelCard().contains("fake.ttm"); }));
    window->preferences().change([](Preferences& p) { p.model = "/no/such.ttm"; });
    QTest::qWait(300);  // waits for an event that must not come
    EXPECT_TRUE(window->modelTrouble().isEmpty());
    EXPECT_TRUE(eventually([&] { return page().modelCard().contains("fake.ttm"); }));
}

TEST_F(SettingsInForce, anotherRobotRebuildsTheWindow)
{
    int wanted = 0;
    QObject::connect(window.get(), &MainWindow::reopenWanted, window.get(), [&] { ++wanted; });
    window->preferences().change([](Preferences& p) { p.robot = "/robots/other.toml"; });
    EXPECT_EQ(wanted, 1);
}

TEST_F(SettingsInForce, anotherLanguageRebuildsUnlessExploring)
{
    int wanted = 0;
    QObject::connect(window.get(), &MainWindow::reopenWanted, window.get(), [&] { ++wanted; });
    page().languageBox()->setCurrentIndex(2);
    EXPECT_EQ(wanted, 1);
    explore();
    EXPECT_TRUE(eventually([&] { return !page().languageBox()->isEnabled(); }));
    window->preferences().change(
        [](Preferences& p) { p.language = "de"; });  // same call as the menu's
    EXPECT_EQ(wanted, 1);
    EXPECT_TRUE(exploring(window->exploration().state().phase));
    EXPECT_TRUE(window->events()->item(0)->text().contains("next start"));
}

TEST_F(SettingsInForce, everyChangeIsOnRecordWithWhatWasBefore)
{
    page().methodBox()->setCurrentText("pafc");
    page().thresholdBox()->setValue(3.5);
    page().themeBox()->setCurrentIndex(static_cast<int>(ThemeName::NightRed));
    window->preferences().change([](Preferences& p) {
        p.rollLimit = 0.125;
        p.layout = Layout::Drive;
    });
    EXPECT_EQ(decisions("settings"),
              (std::vector<std::string>{"method: trail → pafc", "force-threshold: 2 → 3.5",
                                        "theme: day → night-red",
                                        "layout: probe → drive; roll-limit: 0.1 → 0.125"}));
}

TEST_F(SettingsInForce, probePolicyTakesEffectAndIsRecorded)
{
    EXPECT_EQ(window->exploration().options().probes, ProbePolicy::Variance) << "as in the paper";
    page().probesBox()->setCurrentIndex(2);
    EXPECT_EQ(window->exploration().options().probes, ProbePolicy::Question);
    EXPECT_EQ(decisions("settings"),
              (std::vector<std::string>{"probe-policy: variance → question"}));
}

TEST_F(SettingsInForce, aMarkerWithoutRecordingIsReported)
{
    const auto newest = [&] { return window->events()->item(0)->text(); };
    ASSERT_TRUE(eventually([&] {
        QTest::keyClick(window.get(), Qt::Key_K);
        return newest().contains("marked in the recording");
    }));
    window->preferences().change([](Preferences& p) { p.record = false; });
    EXPECT_TRUE(eventually([&] {
        QTest::keyClick(window.get(), Qt::Key_K);
        return newest().contains("not marked: nothing is recorded");
    }));
}

TEST_F(SettingsInForce, theSecondMethodIsOnRecord)
{
    window->exploration().setSecondMethod(Method::Joint);
    window->exploration().setSecondMethod(std::nullopt);
    EXPECT_EQ(decisions("second method"), (std::vector<std::string>{"joint", "none"}));
}

TEST_F(SettingsInForce, settingsThatRebuildAreDisabledWhileExploring)
{
    ASSERT_TRUE(eventually([&] { return page().defaultsButton()->isEnabled(); }));
    explore();
    for (const QPushButton* button : {page().defaultsButton(), page().robotButton()}) {
        EXPECT_TRUE(eventually([&] { return !button->isEnabled(); }));
        EXPECT_TRUE(button->toolTip().contains("Esc")) << button->toolTip().toStdString();
    }
    window->exploration().abort();
    EXPECT_TRUE(eventually([&] { return page().defaultsButton()->isEnabled(); }));
}

TEST_F(SettingsInForce, allBackToTheDefaultsAsksFirst)
{
    ASSERT_TRUE(eventually([&] { return page().defaultsButton()->isEnabled(); }));
    window->preferences().change([](Preferences& p) { p.obstacleLimit = 0.2; });
    page().defaultsButton()->click();
    page().defaultsButton()->click();  // a double click
    EXPECT_EQ(window->preferences().current().obstacleLimit, 0.2);
    EXPECT_TRUE(page().defaultsButton()->text().contains("again"));
    EXPECT_TRUE(eventually([&] {
        page().defaultsButton()->click();
        return window->preferences().current().obstacleLimit == Preferences{}.obstacleLimit;
    }));
}

TEST_F(SettingsInForce, rebuildingTheWindowEndsItsMotion)
{
    ASSERT_TRUE(eventually([&] { return !window->exploration().whyNotDriving(); }));
    window->exploration().drive(1);
    window->preferences().change([](Preferences& p) { p.robot = "/robots/other.toml"; });
    EXPECT_TRUE(wasTold<HaltCommand>());
}

TEST_F(SettingsInForce, destroyingTheWindowAbortsTheExploration)
{
    explore();
    window.reset();
    EXPECT_TRUE(wasTold<AbortAtemCommand>());
}

QDoubleSpinBox* boxOf(const SettingsPage& page, const char* name)
{
    for (QDoubleSpinBox* box : page.findChildren<QDoubleSpinBox*>())
        if (box->accessibleName() == QString::fromUtf8(name)) return box;
    return nullptr;
}

TEST(SettingsPageAlone, everyNumberCanBeReadOnASmallScreen)
{
    PreferenceStore store(LoadedPreferences{}, Preferences{});
    for (const char* language : {"en", "de", "cs"}) {
        ASSERT_EQ(installLanguage(*qApp, language), QLatin1String(language));
        SettingsPage page(store);
        page.resize(900, 500);
        gui::showActive(page);
        QApplication::processEvents();
        for (const auto* box : page.findChildren<QAbstractSpinBox*>()) {
            const auto* const edit = box->findChild<QLineEdit*>();
            EXPECT_GE(edit->width(), edit->fontMetrics().horizontalAdvance(edit->text()))
                << language << ": " << box->accessibleName().toStdString();
        }
    }
    installLanguage(*qApp, "en");
}

TEST(SettingsPageAlone, showsWhateverTheFileMayHold)
{
    constexpr double kDegrees = std::numbers::pi / 180.0;
    const struct {
        const char *key, *box;
        double Preferences::*value;
        double unit = 1.0;
    } cases[]{
        {"obstacle-limit", "An obstacle is a step above", &Preferences::obstacleLimit},
        {"force-threshold", "An element counts as contact above", &Preferences::forceThreshold},
        {"probe-above", "The arm is offered above a sd of", &Preferences::probeAbove},
        {"roll-limit", "The verdict is withheld above a roll of", &Preferences::rollLimit,
         kDegrees},
        {"asymmetry-limit", "… or left and right flippers differ by", &Preferences::asymmetryLimit,
         kDegrees},
        {"tilt-amber", "Pitch or roll is steep from", &Preferences::tiltAmber, kDegrees},
        {"tilt-red", "Pitch or roll is dangerous from", &Preferences::tiltRed, kDegrees}};
    TemporaryDirectory directory;
    int files = 0;  // a new file each time, because QSettings caches what it has read
    PreferenceStore store(LoadedPreferences{}, Preferences{});
    const SettingsPage page(store);
    for (const auto& [key, name, value, unit] : cases) {
        const QDoubleSpinBox* box = boxOf(page, name);
        ASSERT_TRUE(box) << name;
        const auto saying = [&, of = key](double number) {
            const std::string path =
                directory.write(std::to_string(++files) + ".ini",
                                "[General]\nschema=1\n" + std::string(of) + "="
                                    + QByteArray::number(number, 'g', 17).toStdString() + "\n");
            return loadPreferences(QString::fromStdString(path));
        };
        for (const auto& [end, outwards] :
             {std::pair(box->minimum(), -1e-4), std::pair(box->maximum(), 1e-4)}) {
            const LoadedPreferences held = saying(end * unit);
            EXPECT_TRUE(held.troubles.empty()) << key << " " << end;
            EXPECT_NEAR(held.preferences.*value, end * unit, 1e-12) << key;
            store.change([&](Preferences& p) { p = held.preferences; });
            EXPECT_NEAR(box->value(), end, 1e-9) << key;
            EXPECT_FALSE(saying((end + outwards) * unit).troubles.empty())
                << key << " may be more than the page can show";
        }
    }
    const std::string path = directory.write("method.ini", "[General]\nschema=1\nmethod=pafac\n");
    EXPECT_EQ(loadPreferences(QString::fromStdString(path)).troubles.size(), 1U)
        << "the page does not offer it";
}

}  // namespace
}  // namespace terratact
