// Tests rows, span and saved sets of the plots.
#include "app/pages/plots_state.h"

#include <gtest/gtest.h>

#include <limits>

#include "app/pages/plot_sets.h"
#include "app/plotting/plot_source.h"
#include "app/shell/preferences/preference_store.h"

namespace terratact {
namespace {

TEST(PlotsState, rowsHaveBounds)
{
    PlotsState state;
    EXPECT_EQ(state.chosen(), -1);
    EXPECT_TRUE(state.add("a", 0));
    EXPECT_TRUE(state.add("a", 0)) << "it is there once";
    EXPECT_EQ(state.rows(), (PlotRows{{"a"}}));
    for (const char* key : {"b", "c", "d"}) EXPECT_TRUE(state.add(key, 0));
    EXPECT_FALSE(state.add("e", 0)) << "four in a row";
    for (const char* key : {"e", "f", "g", "h", "i"}) EXPECT_TRUE(state.add(key, 99));
    EXPECT_FALSE(state.add("j", 99)) << "six rows";
    EXPECT_TRUE(state.add("a", 1)) << "a signal may be in two rows";
    for (const char* key : {"j", "k", "l"}) EXPECT_TRUE(state.add(key, 2));
    EXPECT_TRUE(state.isFull());
    EXPECT_FALSE(state.add("m", 3)) << "twelve signals";
    EXPECT_EQ(state.keys().size(), PlotSource::kMaxChosen);
    state.choose(5);
    state.removeRow(5);
    EXPECT_EQ(state.chosen(), 4);
    state.remove("e", 1);
    state.remove("a", 1);
    EXPECT_EQ(state.rows().size(), 4U) << "an empty row goes";
    state.removeRow(77);
}

TEST(PlotsState, spanFollowsZoomsAndStaysAtTheData)
{
    PlotsState state;
    state.setEnds(100.0, 200.0);
    state.follow();
    const double span = state.to() - state.from();
    state.setEnds(100.0, 250.0);
    EXPECT_GT(state.to(), 250.0);
    EXPECT_NEAR(state.to() - state.from(), span, 1e-9);
    state.zoom(2.0, 120.0);
    EXPECT_TRUE(state.follows()) << "a zoom stays at the newest values";
    EXPECT_NEAR(state.to() - state.from(), span / 2.0, 0.1);
    state.move(-10.0);
    EXPECT_FALSE(state.follows());
    state.show(110.0, 130.0);
    state.zoom(2.0, 115.0);
    EXPECT_NEAR(state.from(), 112.5, 1e-9);
    EXPECT_NEAR(state.to(), 122.5, 1e-9);
    state.move(-1e6);
    EXPECT_GT(state.to(), 100.0) << "some of the data stays in sight";
    state.showAll();
    EXPECT_EQ(state.from(), 100.0);
    EXPECT_EQ(state.to(), 250.0);
    const double infinity = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 200; ++i) state.zoom(2.0, 150.0);
    EXPECT_NEAR(state.to() - state.from(), PlotsState::kMinSpan, 1e-9);
    for (int i = 0; i < 200; ++i) state.zoom(0.5, 150.0);
    EXPECT_NEAR(state.to() - state.from(), 180.0, 1e-6);
    state.zoom(infinity, 150.0);
    state.zoom(0.0, 150.0);
    state.show(5.0, -infinity);
    EXPECT_NEAR(state.to() - state.from(), 180.0, 1e-6);
}

TEST(PlotsState, theTimeUnderReviewStaysInSight)
{
    PlotsState state;
    state.setEnds(0.0, 100.0);
    state.show(10.0, 20.0);
    state.keepInView(15.0);
    state.keepInView(20.5);
    EXPECT_LT(state.from(), 20.5);
    EXPECT_GT(state.to(), 20.5);
    EXPECT_NEAR(state.to() - state.from(), 10.0, 1e-9);
    state.show(50.0, 60.0);
    state.keepInView(21.0);
    EXPECT_EQ(state.from(), 50.0) << "it was not in sight: the operator looks elsewhere";
}

TEST(PlotSets, surviveTheFile)
{
    const PlotSet set{"my set",
                      {{"telemetry:pitch", "bus:Attitude.Roll"}, {"payload:500 Gas.Oxygen"}}};
    EXPECT_EQ(plotSetFrom(textOf(set)), set);
    EXPECT_FALSE(textOf({"a\nb", {}}).contains('\n')) << "one line";
    for (const char* bad :
         {"", "x", "{}", R"({"name":"","rows":[]})", R"({"name":"a","rows":[[]]})",
          R"({"name":"a","rows":[[1]]})", R"({"name":"a","rows":[["a","b","c","d","e"]]})",
          R"({"name":"a","rows":[["a"],["a"],["a"],["a"],["a"],["a"],["a"]]})"})
        EXPECT_FALSE(plotSetFrom(bad)) << bad;
}

TEST(PlotSets, areReplacedByName)
{
    PreferenceStore preferences;
    savePlotSet(preferences, {"a", {{"telemetry:pitch"}}});
    savePlotSet(preferences, {"b", {{"telemetry:roll"}}});
    savePlotSet(preferences, {"a", {{"telemetry:force1"}}});
    auto sets = savedPlotSets(preferences);
    ASSERT_EQ(sets.size(), 2U);
    EXPECT_EQ(sets[1].rows, (PlotRows{{"telemetry:force1"}}));
    savePlotSet(preferences, {"b", {}});
    EXPECT_EQ(savedPlotSets(preferences).size(), 1U);
    for (int i = 0; i < 100; ++i)
        savePlotSet(preferences, {QString::number(i), {{"telemetry:pitch"}}});
    EXPECT_EQ(preferences.current().plotSets.size(), kMaxPlotSets);
}

}  // namespace
}  // namespace terratact
