// Tests the parts of the signals page: sparkline, table, filter, raw trace.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "app/console/signals_page.h"
#include "app/display/format.h"
#include "app/link/dbc_book.h"
#include "app/mission/signal_rows.h"
#include "app/shell/language.h"
#include "tests/support/gui.h"
#include "tests/support/temporary_directory.h"
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

TappedFrame attitude(double age)
{
    TappedFrame frame;
    frame.kind = FrameKind::Attitude;
    frame.newest = pack({.kind = FrameKind::Attitude, .values = {0.21, -0.05, 1.0}});
    frame.rate = 20.0;
    frame.age = age;
    frame.payload.resize(3);
    for (std::size_t i = 0; i < 3; ++i)
        frame.payload[i] = {.last = 0.21, .least = -0.5, .most = 0.5, .history = {}};
    return frame;
}

TEST(SignalRows, haveValueUnitRateAgeAndExtremes)
{
    SignalTable table;
    table.setRows(signalRows({attitude(0.04)}));
    ASSERT_EQ(table.rows(), 3);
    EXPECT_EQ(table.text(0, SignalTable::Frame), "022 Attitude");
    EXPECT_EQ(table.text(0, SignalTable::Name), "Pitch");
    EXPECT_EQ(table.text(0, SignalTable::Value), "0.2100");
    EXPECT_EQ(table.text(0, SignalTable::Unit), "rad");
    EXPECT_EQ(table.text(0, SignalTable::Rate), "20.0 Hz");
    EXPECT_EQ(table.text(0, SignalTable::Age), "40 ms");
    EXPECT_EQ(table.text(0, SignalTable::Least), QString::fromUtf8("\u22120.5000"));
    EXPECT_EQ(table.text(1, SignalTable::Frame), "") << "once for a frame";
}

TEST(SignalRows, staleOnesReadNothing)
{
    SignalTable table;
    table.setRows(signalRows({attitude(0.151)}));
    EXPECT_EQ(table.text(0, SignalTable::Value), "--");
    EXPECT_EQ(table.text(0, SignalTable::Age), "151 ms");
    TappedFrame unmeasured = attitude(0.04);
    unmeasured.isMeasured = false;
    unmeasured.payload[2].last = 0.0;
    table.setRows(signalRows({unmeasured}));
    EXPECT_EQ(table.text(0, SignalTable::Value), "--");
    EXPECT_EQ(table.text(2, SignalTable::Value), "no") << "that it was not measured is fresh";
}

TEST(SignalRows, oldValuesOfOccasionalFramesStayReadable)
{
    TappedFrame frame;
    frame.kind = FrameKind::PressFlippers;
    frame.newest = pack({.kind = FrameKind::PressFlippers, .values = {3.0, 18.0}});
    frame.age = 7.0;
    frame.payload.resize(2);
    frame.payload[1].last = 18.0;
    const auto rows = signalRows({frame});
    EXPECT_EQ(rows[1].standing, SignalRow::Standing::Said);
    EXPECT_EQ(rows[1].value, "18.00");
}

TEST(Load, saysWhatItAssumesOrThatItIsNotKnown)
{
    BusLoad load;
    load.fewestBits = 100'000.0;
    load.mostBits = 120'000.0;
    EXPECT_EQ(loadWords(load, {.bitsPerSecond = 500'000.0}),
              "load 20.0 to 24.0 % of 500 kbit/s (without stuff bits, with the most possible)");
    EXPECT_EQ(loadWords(load, {.bitsPerSecond = 500'000.0, .nominal = true}),
              "load 20.0 to 24.0 % of nominal 500 kbit/s (without stuff bits, with the most "
              "possible)");
    EXPECT_EQ(loadWords(load, {}), "load --- (bit rate not known): 100.0 to 120.0 kbit/s");
}

TEST(Trace, textsOfDbcFilesAreNotTranslated)
{
    if (installLanguage(*qApp, "cs") != "cs") GTEST_SKIP() << "built without translations";
    const TemporaryDirectory dir;
    auto book = std::make_shared<DbcBook>();
    ASSERT_TRUE(book->add(dir.write("theirs.dbc", "BO_ 1200 Gearbox: 1 G\n"
                                                  " SG_ Gear : 0|8@1+ (1,0) [0|1] \"\" D\n"
                                                  "VAL_ 1200 Gear 0 \"stopped\" 1 \"no\" ;\n")));
    EXPECT_EQ(traceWords({.id = 1200, .length = 1}, book).content, "Gear stopped");
    EXPECT_NE(format::sentence("stopped"), "stopped") << "a word of the robot's, elsewhere";
    installLanguage(*qApp, "en");
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
    RawTrace trace([](const CanFrame&) { return TraceWords(); },
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
