// Tests the parts of the signals page: sparkline, table, filter, raw trace.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "app/console/pages/signals_page.h"
#include "app/display/format.h"
#include "tests/support/gui.h"
#include "widgets/signals/raw_trace.h"
#include "widgets/signals/signal_table.h"

namespace terratact {
namespace {

constexpr float kGap = std::numeric_limits<float>::quiet_NaN();

TEST(Sparkline, breaksAtGapsAndStaysInItsBox)
{
    const QRectF box(10.0, 20.0, 100.0, 30.0);
    const std::vector<float> history{kGap, 1.0F, 2.0F, kGap, 3.0F, -5.0F, 1e30F, kGap};
    const auto lines = sparkline(history, box);
    ASSERT_EQ(lines.size(), 2U);
    EXPECT_EQ(lines[0].size(), 2);
    EXPECT_EQ(lines[1].size(), 3);
    for (const QPolygonF& line : lines)
        for (const QPointF& point : line)
            EXPECT_TRUE(box.adjusted(-1e-6, -1e-6, 1e-6, 1e-6).contains(point))
                << point.x() << " " << point.y();
    EXPECT_NEAR(sparkline(std::vector{1.0F, 1.0F}, box)[0][0].y(), 35.0, 1e-9)
        << "flat: the middle";
    EXPECT_TRUE(sparkline(std::vector{kGap, kGap}, box).empty());
    EXPECT_TRUE(sparkline({}, box).empty());
    const float infinite = std::numeric_limits<float>::infinity();
    EXPECT_EQ(sparkline(std::vector{infinite, 1.0F, -infinite}, box).size(), 1U);
    const float most = std::numeric_limits<float>::max();
    const auto extreme = sparkline(std::vector{most, -most}, box);
    ASSERT_EQ(extreme.size(), 1U);
    for (const QPointF& point : extreme[0])
        EXPECT_TRUE(std::isfinite(point.x()) && std::isfinite(point.y()));
}

TEST(SignalTableWidget, hostileNumbersPaintQuickly)
{
    std::vector<SignalRow> rows;
    for (const double value : gui::kHostile) {
        SignalRow row;
        row.name = "hostile";
        row.rate = row.age = value;
        row.standing = SignalRow::Standing::Fresh;
        row.history.assign(120, static_cast<float>(std::isfinite(value) ? 1.0 : value));
        row.history[60] = std::numeric_limits<float>::max();
        rows.push_back(row);
    }
    SignalTable table;
    table.resize(900, 300);
    table.setRows(rows);
    table.show();
    EXPECT_FALSE(gui::painted(table).isNull());
    EXPECT_EQ(table.text(0, SignalTable::Age), "--");
}

TEST(Load, marksAnAssumedOrUnknownBitRate)
{
    BusLoad load;
    load.fewestBits = 100'000.0;
    load.mostBits = 120'000.0;
    EXPECT_EQ(busLoadText(load, {.bitsPerSecond = 500'000.0}),
              "load 20.0 to 24.0 % of 500 kbit/s (without stuff bits, with the most possible)");
    EXPECT_EQ(busLoadText(load, {.bitsPerSecond = 500'000.0, .nominal = true}),
              "load 20.0 to 24.0 % of nominal 500 kbit/s (without stuff bits, with the most "
              "possible)");
    EXPECT_EQ(busLoadText(load, {}), "load --- (bit rate not known): 100.0 to 120.0 kbit/s");
}

TEST(Filter, takesAnIdentifierOrAPartOfTheName)
{
    const CanFrame frame{.id = 0x22, .length = 8};
    struct Case {
        const char* text;
        bool passes;
    };
    for (const Case& c : {Case{"", true}, Case{"22", true}, Case{"0x022", true}, Case{" 22 ", true},
                          Case{"atti", true}, Case{"23", false}, Case{"222", false},
                          Case{"heart", false}, Case{"ffffffffff", false}})
        EXPECT_EQ(TraceFilter(c.text).passes(frame, "Attitude"), c.passes) << c.text;
}

TEST(RawTraceWidget, showsTheNewestFirstFiltersAndHolds)
{
    RawTrace trace([](const CanFrame&) { return TraceText(); },
                   [](const CanFrame& f) { return f.id == 0x22 ? "Attitude" : "other"; });
    const auto frames = [](std::uint32_t id, std::uint64_t count) {
        std::vector<TracedFrame> made;
        for (std::uint64_t i = 1; i <= count; ++i)
            made.push_back({.number = i, .frame = {.id = id}});
        return made;
    };
    const auto cell = [&](int row, int column) {
        return trace.view()->model()->index(row, column).data().toString();
    };
    auto mixed = frames(0x22, 5);
    mixed[1].frame.id = 0x33;
    trace.setFrames(mixed);
    EXPECT_EQ(cell(0, 0), "5");
    trace.filter()->setText("33");
    EXPECT_EQ(trace.view()->model()->rowCount(), 1);
    EXPECT_EQ(cell(0, 0), "2");
    trace.filter()->clear();
    trace.pauseButton()->click();
    trace.setFrames(frames(0x22, 9));
    EXPECT_EQ(cell(0, 0), "5") << "held";
    trace.pauseButton()->click();
    trace.setFrames(frames(0x22, 9));
    EXPECT_EQ(cell(0, 0), "9");
}

}  // namespace
}  // namespace terratact
