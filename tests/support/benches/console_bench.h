#pragma once

#include <gtest/gtest.h>

#include <QApplication>
#include <QLabel>
#include <QPushButton>
#include <algorithm>
#include <functional>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include "app/console/main_window.h"
#include "core/sim/ground/terrain_shapes.h"
#include "tests/support/absolem.h"
#include "tests/support/estimates.h"
#include "tests/support/gui.h"
#include "tests/support/scripted_source.h"
#include "tests/support/sim_source.h"
#include "widgets/base/held_button.h"
#include "widgets/base/theme.h"
#include "widgets/control/atem_panel.h"
#include "widgets/control/probe_card.h"
#include "widgets/control/status_header.h"
#include "widgets/terrain/terrain_profile_view.h"

namespace terratact {

inline std::unique_ptr<SimSource> fastRobot(const RobotModel& robot, double startX)
{
    SimulatedRobot::Options options;
    options.startX = startX;
    return std::make_unique<SimSource>(SimulatedRobot(robot, demoTerrain(), options), 20.0);
}

/// A fast estimator that needs no model.
inline LoadedModel madeUp()
{
    return {.estimate =
                [](const EstimateRequest& request, const Watch& watch) {
                    for (int i = 0; i < 30; ++i) {
                        if (watch.cancelled()) throw Cancelled{};
                        watch.progress(i / 30.0);
                        // 60 ms together: tests see progress before the result.
                        std::this_thread::sleep_for(std::chrono::milliseconds(2));
                    }
                    TerrainEstimate e = request.arm.empty() ? stepEstimate() : probedEstimate();
                    e.settings = request.settings;
                    return equalSides(e);
                },
            .name = "fake.ttm",
            .details = {},
            .content = "measured"};
}

/// The console with a simulated or scripted robot and a fake estimator.
struct Console : testing::Test {
    static void SetUpTestSuite()
    {
        applyLook(*qobject_cast<QApplication*>(QApplication::instance()));
    }

    void TearDown() override
    {
        window.reset();
        if (lookInForce().fontScale != 100) applyLook(*qApp);
    }
    void open(
        std::unique_ptr<MeasurementSource> source,
        ModelLoader model = [] { return Result<LoadedModel>(madeUp()); })
    {
        MainWindow::Options options;
        options.robot = robot;
        options.source = std::move(source);
        options.model = std::move(model);
        // Long, because the machine may be busy.
        options.exploration.linkLostAfter = options.exploration.staleAfter = 3.0;
        options.exploration.driveSpeed = 0.05;
        options.exploration.limits.approval = answerTime;
        options.presets = {
            "measured",
            {{Method::Local, QualityPreset::Fast, 250, 16, 16, 175, 0.5, 0.0, 25.0, 1.0},
             {Method::Pafac, QualityPreset::Fast, 250, 16, 16, 175, 4.0, 11.3, 34.0, 0.13}}};
        if (gamepads) options.gamepad = gamepads();
        window = std::make_unique<MainWindow>(std::move(options));
        window->probeCard()->approveButton()->setHoldTime(150);
        window->atemPanel()->releaseButton()->setHoldTime(150);
        window->resize(1280, 720);
        QObject::connect(&window->exploration(), &Exploration::decided, window.get(),
                         [this](const char* what) { stops += std::string_view(what) == "stop"; });
        gui::showActive(*window);
    }
    ScriptedSource* openScripted()
    {
        auto source = std::make_unique<ScriptedSource>();
        ScriptedSource* script = source.get();
        open(std::move(source));
        return script;
    }
    bool reaches(AtemPhase phase)
    {
        return gui::eventually([&] { return window->exploration().state().phase == phase; }, 60000);
    }
    bool robotIs(RobotActivity activity)
    {
        return gui::eventually([&] {
            const auto latest = window->acquisition().latest();
            return latest && latest->sample.measurement.activity == activity;
        });
    }
    bool says(const QString& words) const
    {
        for (const QLabel* label : window->findChildren<QLabel*>())
            if (label->isVisible() && label->text().contains(words)) return true;
        return false;
    }
    bool readyToExplore()
    {
        return gui::eventually([&] { return window->atemPanel()->requestButton()->isEnabled(); });
    }
    void proposeByKeyboard()
    {
        ASSERT_TRUE(readyToExplore());
        QTest::keyClick(window.get(), Qt::Key_A);
        ASSERT_TRUE(reaches(AtemPhase::ProposingProbe));
        ASSERT_TRUE(gui::eventually([&] { return window->probeCard()->shown().has_value(); }));
    }

    /// Presses STOP through the desktop's window, so that anything that blocks the window or grabs the mouse has an
    /// effect.
    void clickStop()
    {
        const QPushButton& stop = *window->header()->stopButton();
        QTest::mouseClick(window->windowHandle(), Qt::LeftButton, {},
                          stop.mapTo(window.get(), stop.rect().center()));
    }
    /// Returns the number of presses since the last call; repetitions until the robot confirms do not count.
    int stopsPressed() { return std::exchange(stops, 0); }
    static QRect onScreen(const QWidget& widget)
    {
        return {widget.mapToGlobal(QPoint(0, 0)), widget.size()};
    }

    /// Checks every screen and font size. Nothing may be cut, and the font must be as large as was achieved before.
    void fitsEveryScreen(const char* state, std::initializer_list<int> letters)
    {
        struct Screen {
            QSize size;
            int largest;  // font scale [%] that must be possible
        };
        constexpr Screen kScreens[]{{{1200, 680}, 150},
                                    {{1280, 720}, 160},
                                    {{1366, 768}, 170},
                                    {{1440, 900}, 200},
                                    {{1920, 1080}, 200}};
        for (const int wanted : letters)
            for (const Screen& screen : kScreens) {
                window->setRoom(screen.size);
                window->preferences().change([wanted](Preferences& p) { p.fontScale = wanted; });
                window->resize(screen.size);
                const std::string what = std::string(state) + ", " + std::to_string(wanted) + " %, "
                                       + std::to_string(screen.size.width());
                EXPECT_TRUE(gui::eventually([&] { return !window->isFittingFont(); })) << what;
                EXPECT_GE(lookInForce().fontScale, std::min(wanted, screen.largest)) << what;
                EXPECT_EQ(window->preferences().current().fontScale, wanted);
                (void)gui::eventually([&] { return gui::cramped(*window).empty(); });
                EXPECT_EQ(gui::cramped(*window), std::vector<std::string>()) << what;
                EXPECT_EQ(window->size(), screen.size) << what;
                const QPushButton& stop = *window->header()->stopButton();
                EXPECT_TRUE(stop.isVisible() && window->header()->rect().contains(stop.geometry()))
                    << what;
                const QWidget& terrain = *window->terrain()->parentWidget();
                EXPECT_GE(terrain.width(), window->atemPanel()->width()) << what;
                for (const std::string& text : gui::elidedText(*window))
                    EXPECT_NE(text, window->header()->sourceName().toStdString()) << what;
                const QString folder = qEnvironmentVariable("TERRATACT_PICTURES");
                if (!folder.isEmpty())
                    window->grab().save(QStringLiteral("%1/letters_%2_%3_%4.png")
                                            .arg(folder, state)
                                            .arg(wanted)
                                            .arg(screen.size.width()));
            }
    }

    RobotModel robot = absolem();
    double answerTime = AtemLimits{}.approval;  // [s]
    int stops = 0;
    std::function<std::unique_ptr<Gamepad>()> gamepads{};  ///< empty: none is read
    std::unique_ptr<MainWindow> window;
};

}  // namespace terratact
