// Tests recomputed estimates in a review.
#include "app/review/what_if_page.h"

#include <gtest/gtest.h>

#include <QDoubleSpinBox>
#include <QTableWidget>

#include "app/mission/estimator_worker.h"
#include "app/pages/terrain_page.h"
#include "app/review/review_window.h"
#include "app/review/scenes_window.h"
#include "tests/support/benches/review_bench.h"
#include "tests/support/gui.h"
#include "tests/support/sessions/robot_session.h"
#include "widgets/terrain/readings/estimate_strip.h"
#include "widgets/terrain/terrain_profile_view.h"

namespace terratact {
namespace {

using namespace gui;
using At = RobotSessionTimes;

/// Writes a session with one scene that has a memory, and one without.
void recordScenes(const QString& path, const std::string& model, const LoadedModel& loaded)
{
    SessionStart start = someStart();
    start.robot = *readFile(TERRATACT_SOURCE_DIR "/resources/robots/absolem.toml", 1U << 16U);
    auto writer = SessionWriter::create(path.toStdString(), start);
    ASSERT_TRUE(writer) << writer.error().text;
    ASSERT_TRUE(writer->add(ModelRow{.id = 1,
                                     .name = "default.ttm",
                                     .hash = *sha256OfFile(model),
                                     .trailName = loaded.trail.name.toStdString(),
                                     .trailHash = loaded.trail.hash.toStdString()}));
    for (const std::int64_t id : {1, 2}) {
        SceneRow scene = someScene(id, sessionTimeOf(static_cast<double>(id)));
        EXPECT_EQ(scene.memory.has_value(), id == 1);
        ASSERT_TRUE(writer->add(scene));
        EstimateRow row{.id = id, .time = scene.time + 1000, .scene = id, .model = 1};
        EstimateRequest request;
        request.measurement = scene.measurement;
        request.memory = scene.memory;
        request.settings.method = scene.memory ? Method::Trail : Method::Local;
        row.estimate = loaded.estimate(request, Watch{});
        ASSERT_TRUE(writer->add(row));
    }
    ASSERT_TRUE(writer->seal());
}

TEST_F(ReviewOf, anEstimateWithAMemoryIsRepeatedBitForBit)
{
    const std::string model = TERRATACT_SOURCE_DIR "/resources/models/default.ttm";
    const auto loaded = modelFileLoader(model, absolem())();
    ASSERT_TRUE(loaded) << loaded.error().text;
    ASSERT_NO_FATAL_FAILURE(recordScenes(path, model, *loaded));
    open({QString::fromStdString(model)});
    window->goTo(1.5);
    WhatIfPage& page = *window->whatIf();
    EXPECT_EQ(page.method()->currentText(), "trail");
    page.estimate();
    ASSERT_TRUE(eventually([&] { return page.answer().value().has_value(); }, 60000));
    EXPECT_TRUE(page.result()->text().contains("bit for bit"))
        << page.result()->text().toStdString();
    EXPECT_TRUE(
        window->terrainPage()->strip()->details().contains("memory: 0.75 m · earlier presses: 3"))
        << window->terrainPage()->strip()->details().toStdString();

    window->goTo(2.5);
    EXPECT_EQ(page.method()->currentText(), "local");
    EXPECT_EQ(page.method()->findText("trail"), -1) << "nothing is remembered there";
    window->goTo(1.5);
    EXPECT_EQ(page.method()->currentText(), "trail");
}

TEST_F(ReviewOf, recordedSettingsGiveTheRecordedEstimateBitForBit)
{
    const std::string model = TERRATACT_SOURCE_DIR "/resources/models/default.ttm";
    const auto loaded = modelFileLoader(model, absolem())();
    ASSERT_TRUE(loaded) << loaded.error().text;
    SessionStart start = someStart();
    start.robot = *readFile(TERRATACT_SOURCE_DIR "/resources/robots/absolem.toml", 1U << 16U);
    auto writer = SessionWriter::create(path.toStdString(), start);
    ASSERT_TRUE(writer) << writer.error().text;
    ASSERT_TRUE(
        writer->add(ModelRow{.id = 1, .name = "default.ttm", .hash = *sha256OfFile(model)}));
    SceneRow scene{.id = 1, .time = sessionTimeOf(1.0)};
    scene.measurement.pitch = 0.05;
    scene.measurement.roll = 0.2;  // causes a warning
    scene.measurement.force = {0.0, 0.0, 0.0, 0.0, 0.0, 7.0};
    ASSERT_TRUE(writer->add(scene));
    EstimateRow row{.id = 1, .time = sessionTimeOf(1.5), .scene = 1, .model = 1};
    Settings settings;
    settings.seed = 18'446'744'073'709'551'557U;
    row.estimate = loaded->estimate({scene.measurement, {}, settings}, Watch{});
    ASSERT_TRUE(writer->add(row));
    EstimateRow rounded = row;  // rounded like on another processor
    rounded.id = 2;
    rounded.time = sessionTimeOf(1.7);
    for (TerrainEstimate& side : rounded.estimate.side) side.height[4] += 1e-12;
    ASSERT_TRUE(writer->add(rounded));
    ASSERT_TRUE(writer->seal());

    open({QString::fromStdString(model)});
    window->goTo(1.5);
    press(Qt::Key_E);
    WhatIfPage& page = *window->whatIf();
    EXPECT_EQ(page.seed()->text(), "18446744073709551557");
    ASSERT_TRUE(eventually([&] { return page.answer().value().has_value(); }, 60000));
    EXPECT_TRUE(page.result()->text().contains("bit for bit"))
        << page.result()->text().toStdString();
    EXPECT_EQ(*page.answer(), row.estimate);

    page.threshold()->setValue(20.0);
    page.estimate();
    ASSERT_TRUE(eventually([&] { return page.answer() && *page.answer() != row.estimate; }, 60000));
    EXPECT_FALSE(page.result()->text().contains("bit for bit"));
    EXPECT_EQ(page.answer()->side[0].settings.forceThreshold, 20.0);
    window->goTo(1.0);
    EXPECT_FALSE(page.answer()) << "of another estimate";

    window->goTo(1.7);
    page.estimate();
    ASSERT_TRUE(eventually([&] { return page.answer().value().has_value(); }, 60000));
    EXPECT_TRUE(page.result()->text().contains("except for rounding in the last bits"))
        << page.result()->text().toStdString();
}

TEST_F(ReviewOf, theShippedSessionOfTwoTracksIsReproduced)
{
    path = TERRATACT_SOURCE_DIR "/resources/sessions/two_tracks.tts";
    open({TERRATACT_SOURCE_DIR "/resources/models/default.ttm"});
    press(Qt::Key_4);
    ASSERT_TRUE(window->moment().estimate);
    WhatIfPage& page = *window->whatIf();
    EXPECT_EQ(page.table()->rowCount(), 2 * kBins);
    page.estimate();
    ASSERT_TRUE(eventually([&] { return page.answer().value().has_value(); }, 60000));
    EXPECT_FALSE(page.answer()->onePlane);
    const QString text = page.result()->text();
    EXPECT_TRUE(text.contains("reproduce the recorded estimate")) << text.toStdString();
    EXPECT_TRUE(text.contains("\nLeft: CANNOT TELL (")) << text.toStdString();
    EXPECT_TRUE(text.contains("\nRight: CANNOT TELL (")) << text.toStdString();
    EXPECT_TRUE(page.table()->item(0, 0)->text().endsWith("left"));
    EXPECT_TRUE(page.table()->item(kBins, 0)->text().endsWith("right"));
    window->goTo(0.0);
    EXPECT_EQ(page.table()->rowCount(), kBins) << "no estimate";
}

/// Other processors and later versions may round the last bits differently.
TEST_F(ReviewOf, theShippedSessionIsReproduced)
{
    path = TERRATACT_SOURCE_DIR "/resources/sessions/demo.tts";
    open({TERRATACT_SOURCE_DIR "/resources/models/one_plane.ttm"});
    press(Qt::Key_4);
    for (int estimate = 0; estimate < 2; ++estimate) {
        if (estimate > 0) {
            window->goTo(secondsOf(window->session().estimates().back().time));
            ASSERT_TRUE(window->moment().state.probed);
        }
        ASSERT_TRUE(window->moment().estimate);
        window->whatIf()->estimate();
        ASSERT_TRUE(
            eventually([&] { return window->whatIf()->answer().value().has_value(); }, 60000));
        EXPECT_TRUE(window->whatIf()->result()->text().contains("reproduce the recorded estimate"))
            << window->whatIf()->result()->text().toStdString();
    }
}

}  // namespace
}  // namespace terratact
