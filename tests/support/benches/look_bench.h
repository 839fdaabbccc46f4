#pragma once

#include <gtest/gtest.h>

#include "app/console/main_window.h"
#include "core/sim/ground/terrain_shapes.h"
#include "tests/support/absolem.h"
#include "tests/support/estimates.h"
#include "tests/support/gui.h"
#include "tests/support/sim_source.h"
#include "tests/support/temporary_directory.h"
#include "widgets/base/navigation_rail.h"
#include "widgets/base/theme.h"
#include "widgets/control/atem_panel.h"
#include "widgets/control/probe_card.h"

namespace terratact {

inline ModelLoader madeUp()
{
    return [] {
        return Result<LoadedModel>(
            LoadedModel{.estimate =
                            [](const EstimateRequest& request, const Watch&) {
                                TerrainEstimate e = stepEstimate();
                                e.settings = request.settings;
                                return equalSides(e);
                            },
                        .name = "default.ttm",
                        .details = {}});
    };
}

/// The console with its own preferences file and a simulated robot before a step.
struct Look : testing::Test {
    void SetUp() override { open(); }
    void TearDown() override
    {
        window.reset();
        applyLook(*qApp);
    }
    void open(const Preferences& preferences = {})
    {
        applyLook(*qApp, preferences.theme, preferences.fontScale);
        const QString path = QString::fromStdString(directory.file("console.ini"));
        MainWindow::Options options;
        options.robot = absolem();
        SimulatedRobot::Options simulation;
        simulation.startX = 2.1;
        options.source = std::make_unique<SimSource>(
            SimulatedRobot(options.robot, demoTerrain(), simulation), 20.0);
        options.model = madeUp();
        options.exploration.linkLostAfter = 5.0;
        options.preferences = std::make_unique<PreferenceStore>(loadPreferences(path), preferences);
        window = std::make_unique<MainWindow>(std::move(options));
        window->resize(1440, 900);
        gui::showActive(*window);
    }
    void explore()
    {
        ASSERT_TRUE(
            gui::eventually([&] { return window->atemPanel()->requestButton()->isEnabled(); }));
        QTest::keyClick(window.get(), Qt::Key_A);
        ASSERT_TRUE(
            gui::eventually([&] { return window->probeCard()->shown().has_value(); }, 60000));
        QTest::qWait(100);
    }
    void press(Qt::Key key) { QTest::keyClick(window.get(), key, Qt::ControlModifier); }
    void eachPage(const std::function<void()>& poll)
    {
        for (int page = 0; page < window->rail()->pages(); ++page) {
            window->rail()->choose(page);
            QTest::qWait(80);
            poll();
        }
        window->rail()->choose(0);
    }
    Preferences saved() const
    {
        return loadPreferences(QString::fromStdString(directory.file("console.ini"))).preferences;
    }
    TemporaryDirectory directory;
    std::unique_ptr<MainWindow> window;
};

}  // namespace terratact
