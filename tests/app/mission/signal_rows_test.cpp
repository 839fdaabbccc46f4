// Tests the rows of the signal table and the texts of the trace.
#include "app/mission/signal_rows.h"

#include <gtest/gtest.h>

#include "app/display/format.h"
#include "app/display/translated.h"
#include "app/link/dbc_book.h"
#include "app/start/language.h"
#include "tests/support/temporary_directory.h"
#include "widgets/signals/signal_table.h"

namespace terratact {
namespace {

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

TEST(Trace, textsOfDbcFilesAreNotTranslated)
{
    ASSERT_EQ(installLanguage(*qApp, "cs"), "cs");
    const TemporaryDirectory dir;
    auto book = std::make_shared<DbcBook>();
    ASSERT_TRUE(book->add(dir.write("theirs.dbc", "BO_ 1200 Gearbox: 1 G\n"
                                                  " SG_ Gear : 0|8@1+ (1,0) [0|1] \"\" D\n"
                                                  "VAL_ 1200 Gear 0 \"stopped\" 1 \"no\" ;\n")));
    EXPECT_EQ(traceText({.id = 1200, .length = 1}, book).content, "Gear stopped");
    EXPECT_NE(translated(TR_NOOP("core", "stopped")), "stopped")
        << "a word of the robot's, elsewhere";
    installLanguage(*qApp, "en");
}

}  // namespace
}  // namespace terratact
