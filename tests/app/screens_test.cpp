// Every state of the console as a picture.  The pictures go where TERRATACT_PICTURES says, else nowhere:
//   TERRATACT_PICTURES=DIR build/release/tests/app.screens_test && tests/app/contact_sheet.sh DIR
// In each state no text may be cut and STOP must be there.
#include <gtest/gtest.h>

#include <QPushButton>
#include <QRegularExpression>
#include <QStackedWidget>
#include <map>
#include <set>

#include "app/language.h"
#include "app/main_window.h"
#include "app/resources.h"
#include "app/robot_in_process.h"
#include "app/steady_now.h"
#include "core/sim/terrain_shapes.h"
#include "core/wire/frame_layout.h"
#include "tests/support/absolem.h"
#include "tests/support/estimates.h"
#include "tests/support/gui.h"
#include "widgets/arming_control.h"
#include "widgets/atem_panel.h"
#include "widgets/drive_pad.h"
#include "widgets/held_button.h"
#include "widgets/look.h"
#include "widgets/navigation_rail.h"
#include "widgets/probe_card.h"
#include "widgets/status_header.h"
#include "widgets/terrain_profile_view.h"
#include "widgets/verdict_strip.h"
#include "widgets/words.h"

namespace terratact {
namespace {

using namespace std::chrono_literals;
using gui::eventually;

/// Names of frames and signals are those of the DBC in every language, and frames' traces full of them.
const QRegularExpression& namesOfTheBus()
{
    static const QRegularExpression kNames = [] {
        QStringList names;
        for (const FrameLayout& layout : frameLayouts()) {
            names << words::text(layout.name);
            for (const SignalLayout& signal : layout.payload) names << words::text(signal.name);
        }
        names.replaceInStrings(QRegularExpression("[0-9]+"), "#");
        std::sort(names.begin(), names.end(),  // the longest first
                  [](const QString& a, const QString& b) { return a.size() > b.size(); });
        return QRegularExpression(names.join('|'));
    }();
    return kNames;
}

/// Whether a text may read in another language as in English: nothing in it but names, units, files and words that the
/// languages share.
bool isSameEverywhere(const std::string& text)
{
    static const QRegularExpression kNames(
        "\\b(pa|pac|pafc|pafac|local|joint|clearance|Absolem|Terratact|SIMULATED "
        "ROBOT|English|Deutsch|Eigen|Qwt|"
        "OpenBLAS.*|Linux.*|R-hat|ESS|AVX|rad|STOP|Token|terratact (simulate|train) "
        ".*|[Mm]odel|[Rr]obot|Start|Status|"
        "Name|Training|Signal|Rate|Bytes)\\b|[^ ]*\\.(ttm|toml|csv)(: no such file)?\\b|Čeština");
    static const QRegularExpression kWord("[A-Za-z]{3}");
    QString rest = QString::fromStdString(text);
    return !rest.remove(kNames).remove(namesOfTheBus()).contains(kWord);
}

/// In English, then in the other languages, of which no text may be as in English.
struct Screens : testing::TestWithParam<const char*> {
    void SetUp() override
    {
        applyLook(*qApp);
        if (installLanguage(*qApp, GetParam()) != QLatin1String(GetParam()))
            GTEST_SKIP() << "built without translations";
    }
    void TearDown() override
    {
        static std::map<std::string, std::set<std::string>> inEnglish;  // by the test
        const std::string test = testing::UnitTest::GetInstance()->current_test_info()->name();
        std::set<std::string>& english = inEnglish[test.substr(0, test.find('/'))];
        if (GetParam() == std::string_view("en"))
            english = said;
        else
            for (const std::string& text : said) {
                EXPECT_TRUE(!english.contains(text) || isSameEverywhere(text))
                    << GetParam() << ": " << text;
            }
        installLanguage(*qApp, "en");
    }
    ~Screens() override
    {
        window.reset();  // its source lives on the bus
        robot.reset();
    }

    void open(ModelLoader loader, RobotFault fault = RobotFault::None)
    {
        SimulatedRobot::Options simulation;
        simulation.startX = kDemoStep - 0.55;
        robot = std::make_unique<RobotInProcess>(
            bus, model, SimulatedRobot(model, demoTerrain(), simulation),
            RobotOnBus::Options{.firstEpoch = 9, .speed = 4.0, .fault = fault, .faultAt = 3.0});
        auto source = std::make_unique<CanSource>(
            bus.join("can0"), model,
            CanSource::Options{.mode = CanSource::Mode::Transmit,
                               .name = "SIMULATED ROBOT",
                               .link = {.gate = {.operatorAge = 3.0}},
                               .truth = [this] { return robot->truth(); },
                               .bitrate = 500e3});
        MainWindow::Options options;
        options.robot = model;
        options.link = source.get();
        options.source = std::move(source);
        options.model = std::move(loader);
        options.modelPath = resourcePath("models/default.ttm");
        options.robotDetails = QStringLiteral("robots/absolem.toml");
        options.exploration.linkLostAfter = 3.0;
        options.exploration.driveSpeed = 0.03;
        options.exploration.settings.probeAbove = 0.03;
        options.exploration.limits.approval = 600.0;  // a busy machine may draw slowly
        options.presets.model = readPresets(resourcePath("models/default.presets.csv"))->model;
        options.presets.costs = {{Method::Local, Quality::Balanced, 1.1, 2.0, 25.0}};
        window = std::make_unique<MainWindow>(std::move(options));
        window->header()->arming()->confirmButton()->setHoldTime(150);
        window->probeCard()->approveButton()->setHoldTime(150);
        window->resize(1440, 900);
        gui::showActive(*window);
    }
    ModelLoader shipped() const
    {
        return modelFileLoader(resourcePath("models/default.ttm"), model);
    }
    /// Takes the picture and looks at it.
    void picture(const QString& name)
    {
        QTest::qWait(120);
        EXPECT_TRUE(window->header()->stopButton()->isVisible()) << name.toStdString();
        (void)eventually([&] { return gui::cutText(*window).empty(); },
                         2000);  // a busy machine lays out late
        for (const std::string& text : gui::cutText(*window))
            ADD_FAILURE() << "cut in " << name.toStdString() << ": " << text;
        const QImage image = gui::painted(*window);
        EXPECT_GT(gui::colours(image), 20) << name.toStdString();
        for (const std::string& text : gui::textsOf(*window)) said.insert(text);
        const QString folder = qEnvironmentVariable("TERRATACT_PICTURES");
        if (!folder.isEmpty()) {
            const bool english = GetParam() == std::string_view("en");
            const QString prefix = english ? QString() : QString(GetParam()) + "_";
            EXPECT_TRUE(image.save(folder + "/" + prefix + name + ".png"));
        }
    }
    void arm()
    {
        auto* arming = window->header()->arming();
        ASSERT_TRUE(eventually([&] { return arming->armButton()->isEnabled(); }));
        QTest::keyClick(window.get(), Qt::Key_M);
        ASSERT_TRUE(eventually([&] { return arming->confirmButton()->isVisible(); }));
        picture("03_arming");
        QTest::keyPress(window.get(), Qt::Key_M);
        ASSERT_TRUE(eventually([&] { return window->exploration().armed(); }));
        QTest::keyRelease(window.get(), Qt::Key_M);
        QTest::qWait(100);
    }
    bool reaches(AtemPhase phase)
    {
        return eventually([&] { return window->exploration().state().phase == phase; }, 60000);
    }
    void page(Qt::Key key, const QString& name)
    {
        QTest::keyClick(window.get(), key);
        picture(name);
    }

    std::set<std::string> said;  ///< in all pictures so far
    MemoryBus bus{steadyNow};
    RobotModel model = absolem();
    std::unique_ptr<RobotInProcess> robot;
    std::unique_ptr<MainWindow> window;
};

TEST_P(Screens, ofAWholeExploration)
{
    std::atomic<bool> go = false;
    open([&, load = shipped()] {
        while (!go) std::this_thread::sleep_for(5ms);
        return load();
    });
    ASSERT_TRUE(eventually([&] { return window->exploration().linkAlive(); }));
    picture("01_model_loading");
    go = true;
    ASSERT_TRUE(eventually([&] { return window->header()->arming()->armButton()->isEnabled(); }));
    picture("02_not_armed");
    arm();
    ASSERT_TRUE(eventually([&] { return window->atemPanel()->requestButton()->isEnabled(); }));
    picture("04_ready");
    QTest::keyPress(window.get(), Qt::Key_W);
    QTest::qWait(200);
    picture("05_driving");
    QTest::keyRelease(window.get(), Qt::Key_W);
    ASSERT_TRUE(eventually([&] { return window->atemPanel()->requestButton()->isEnabled(); }));
    QTest::keyClick(window.get(), Qt::Key_A);
    ASSERT_TRUE(eventually([&] { return window->exploration().estimation().live().has_value(); }));
    picture("06_live_preview");
    ASSERT_TRUE(reaches(AtemPhase::ProposingProbe));
    picture("07_probe_proposed");
    QTest::keyClick(window.get(), Qt::Key_D);
    window->exploration().setSecondMethod(Method::Pafc);
    ASSERT_TRUE(
        eventually([&] { return window->exploration().estimation().second().has_value(); }, 60000));
    window->terrain()->inspect(8);
    picture("08_draws_second_method_and_a_bin_up_close");
    window->terrain()->inspect(std::nullopt);
    QTest::keyClick(window.get(), Qt::Key_D);
    window->exploration().setSecondMethod(std::nullopt);
    for (int page = 1; page < window->rail()->pages(); ++page) {
        QTest::keyClick(window.get(), window->rail()->keyOf(page));
        picture(QStringLiteral("2%1_page_%2")
                    .arg(page)
                    .arg(window->rail()->button(page)->accessibleName()));
    }
    QTest::keyClick(window.get(), Qt::Key_F2);
    window->resize(1200, 680);
    picture("09_smallest");
    window->resize(1440, 900);
    if (window->exploration().state().phase != AtemPhase::ProposingProbe)
        return;  // too slow a machine
    QTest::keyPress(window.get(), Qt::Key_Space);
    ASSERT_TRUE(reaches(AtemPhase::Probing));
    QTest::keyRelease(window.get(), Qt::Key_Space);
    picture("10_probing");
    ASSERT_TRUE(reaches(AtemPhase::Presenting));
    ASSERT_TRUE(eventually([&] { return window->showsEstimate(); }));
    picture("11_probed");
    QTest::keyPress(window.get(), Qt::Key_S);
    ASSERT_TRUE(eventually(
        [&] {
            const auto ghost = window->exploration().estimation().ghost();
            return ghost && ghost->motion.way > 0.2;
        },
        60000))
        << window->exploration().estimation().whyNoGhost().toStdString();
    QTest::keyRelease(window.get(), Qt::Key_S);
    picture("16_ghost");
    const std::pair<ThemeName, const char*> themes[]{
        {ThemeName::NightRed, "17_ghost_by_night"},
        {ThemeName::HighContrast, "18_ghost_in_high_contrast"}};
    window->resize(1200, 680);
    for (const auto& [theme, name] : themes) {
        window->preferences().change([theme = theme](Preferences& p) { p.theme = theme; });
        picture(name);
    }
    window->preferences().change([](Preferences& p) { p.theme = ThemeName::Day; });
    window->resize(1440, 900);
    QTest::keyClick(window.get(), Qt::Key_F12);
    ASSERT_TRUE(reaches(AtemPhase::Stopped));
    picture("12_stopped");
}

TEST_P(Screens, ofALostRobot)
{
    open(shipped(), RobotFault::Silence);
    ASSERT_TRUE(eventually([&] { return window->exploration().linkAlive(); }));
    ASSERT_TRUE(eventually([&] { return !window->exploration().linkAlive(); }, 60000));
    picture("13_link_lost");
    QTest::keyClick(window.get(), Qt::Key_F4);
    picture("14_alarms_of_a_lost_link");
}

TEST_P(Screens, withoutAModel)
{
    open([]() -> Result<LoadedModel> { return Error{"models/mine.ttm: no such file", 2}; });
    ASSERT_TRUE(eventually([&] { return !window->modelTrouble().isEmpty(); }));
    picture("15_no_model");
}

INSTANTIATE_TEST_SUITE_P(Languages, Screens, testing::Values("en", "cs", "de"));

}  // namespace
}  // namespace terratact
