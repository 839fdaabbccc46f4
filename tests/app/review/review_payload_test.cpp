// Tests frames of other devices in a review.
#include "app/review/review_payload.h"

#include <gtest/gtest.h>

#include <QRadioButton>
#include <algorithm>
#include <cstdint>
#include <vector>

#include "app/review/export/review_export_dialog.h"
#include "app/review/review_signals_page.h"
#include "app/review/review_window.h"
#include "tests/support/benches/export_bench.h"
#include "tests/support/gui.h"
#include "tests/support/sessions/robot_session.h"
#include "widgets/base/theme.h"
#include "widgets/signals/signal_table.h"
#include "widgets/terrain/readings/numbers_table.h"

namespace terratact {
namespace {

using namespace gui;
using At = RobotSessionTimes;

/// A session with frames of a gas sensor and a battery, and their DBC file.
struct PayloadOf : ExportOf {
    static QString dbcFile()
    {
        return QStringLiteral(TERRATACT_SOURCE_DIR "/docs/can_payload.dbc");
    }
    void record()
    {
        auto writer = robotSession(path.toStdString(), 4.0);
        ASSERT_TRUE(writer) << writer.error().text;
        const auto add = [&](double seconds, std::uint32_t id, bool extended,
                             std::vector<std::uint8_t> bytes) {
            CanFrame frame;
            frame.id = id;
            frame.extended = extended;
            frame.length = static_cast<std::uint8_t>(bytes.size());
            std::copy(bytes.begin(), bytes.end(), frame.data.begin());
            ASSERT_TRUE(writer->add(FrameRow{.time = sessionTimeOf(seconds), .frame = frame}));
        };
        add(4.0, 0x500, false, {0x00, 0xEB, 0xCF, 0xFD, 0xD0, 0x01});
        add(4.1, 0x18FED101, true, {0x00, 0xAB, 0x63, 0x62, 0, 0, 0, 0});
        add(4.2, 0x18FED101, true, {0x01, 0, 0, 0, 0, 0x80, 0x3B, 0x43});
        add(4.3, 0x501, false, {0x01, 0x02});
        add(4.5, 0x500, false, {0x00, 0xF3, 0xCE, 0xFD, 0xD0, 0x01});
        ASSERT_TRUE(writer->seal());
    }
    QString valueOf(const QString& name) const
    {
        const SignalTable& table = *window->signalsPage()->table();
        for (int row = 0; row < table.rows(); ++row)
            if (table.text(row, SignalTable::Name) == name)
                return table.text(row, SignalTable::Value);
        return QStringLiteral("no such row");
    }
};

TEST_F(PayloadOf, theReviewShowsWhatOtherDevicesHadSent)
{
    applyLook(*qApp);
    record();
    open();
    window->preferences().change([](Preferences& p) { p.dbc = {dbcFile()}; });
    window->goTo(4.25);
    press(Qt::Key_F7);
    ASSERT_TRUE(eventually([&] { return valueOf("Oxygen") == "20.7"; }));
    EXPECT_EQ(valueOf("CarbonMonoxide"), "23.5");
    EXPECT_EQ(valueOf("State"), "ready");
    EXPECT_EQ(valueOf("Voltage"), "25.187") << "of a multiplexor's other half";
    EXPECT_EQ(valueOf("Power"), "187.5");
    EXPECT_EQ(cutWhenSettled(), std::vector<std::string>());
    window->goTo(4.4);
    EXPECT_EQ(valueOf("Oxygen"), "--") << "it comes every 0.1 s, and has not for 0.4 s";
    EXPECT_EQ(valueOf("Power"), "187.5") << "comes when it likes";
    window->goTo(4.5);
    EXPECT_EQ(valueOf("Oxygen"), "20.6") << "at this time";
    window->goTo(3.9);
    EXPECT_EQ(window->signalsPage()->table()->rows(), 0);
    EXPECT_TRUE(window->signalsPage()->headline()->text().startsWith("No other device"));
    window->goTo(4.5);
    window->preferences().change([](Preferences& p) { p.dbc.clear(); });
    EXPECT_TRUE(eventually([&] { return valueOf("Oxygen") == "no such row"; }));
    EXPECT_GT(window->signalsPage()->table()->rows(), 0) << "their bytes";
}

TEST_F(PayloadOf, signalsAreExportedWithThoseOfDbcFiles)
{
    record();
    open();
    choose("Signals", ".csv", "none.csv");
    EXPECT_FALSE(window->exportDialog()->withPayload()->isEnabled()) << "no DBC file is chosen";
    window->preferences().change([](Preferences& p) { p.dbc = {dbcFile()}; });
    const auto book = readDbcBook(CanProtocol::Terratact, {dbcFile().toStdString()});
    ASSERT_TRUE(book);
    for (const char* format : {"csv", "mcap"}) {
        const std::string name = std::string("payload.") + format;
        choose("Signals", QStringLiteral(".") + format, name);
        EXPECT_TRUE(window->exportDialog()->withPayload()->isEnabled());
        QTest::mouseClick(window->exportDialog()->wholeSession(), Qt::LeftButton);
        write();
        EXPECT_EQ(written(name),
                  commandWrites("command-" + name, {.what = ExportKind::Signals, .book = *book}));
    }
    EXPECT_NE(written("payload.csv").find("GasSensor.Oxygen [%]"), std::string::npos);
    choose("Signals", ".csv", "without.csv");
    window->exportDialog()->withPayload()->click();
    write();
    EXPECT_EQ(written("without.csv").find("GasSensor"), std::string::npos);
    choose("CAN frames", ".csv", "frames.csv");
    EXPECT_FALSE(window->exportDialog()->withPayload()->isEnabled()) << "frames hold no signals";
    choose("Signals", ".csv", "again.csv");
    EXPECT_FALSE(window->exportDialog()->withPayload()->isChecked()) << "the choice is kept";
    window->exportDialog()->withPayload()->click();
    choose("CAN frames", ".csv", "frames.csv");
    EXPECT_FALSE(window->exportDialog()->withPayload()->isChecked()) << "it holds none";
    choose("Signals", ".csv", "again.csv");
    EXPECT_TRUE(window->exportDialog()->withPayload()->isChecked());
}

TEST_F(PayloadOf, aDbcFileThatIsGoneStopsTheExport)
{
    record();
    open();
    window->preferences().change([](Preferences& p) { p.dbc = {"/nowhere/gone.dbc"}; });
    choose("Signals", ".csv", "none.csv");
    QTest::mouseClick(window->exportDialog()->exportButton(), Qt::LeftButton);
    ASSERT_TRUE(eventually([&] { return !window->exportDialog()->writes(); }));
    const QString said = window->exportDialog()->resultLabel()->text();
    EXPECT_TRUE(said.startsWith("NOT WRITTEN") && said.contains("gone.dbc")) << said.toStdString();
    EXPECT_FALSE(files().contains("none.csv"));
}

}  // namespace
}  // namespace terratact
