// Tests the diagnostics page: lateness of the event loop.
#include <gtest/gtest.h>

#include <QApplication>
#include <QRegularExpression>
#include <QTimer>
#include <cerrno>

#include "app/console/diagnostics_page.h"
#include "app/shell/loop_meter.h"
#include "tests/support/foreign_tongue.h"

namespace terratact {
namespace {

TEST(NewestValues, quantilesAreOfTheNewest)
{
    NewestValues values(100);
    EXPECT_EQ(values.quantile(0.99), 0.0);
    for (int i = 1; i <= 250; ++i) values.add(i);
    EXPECT_EQ(values.count(), 100U);
    EXPECT_EQ(values.quantile(0.0), 151.0);
    EXPECT_EQ(values.quantile(0.5), 200.0);
    EXPECT_EQ(values.quantile(0.99), 249.0);
    EXPECT_EQ(values.most(), 250.0);
    EXPECT_THROW((void)values.quantile(1.1), std::invalid_argument);
}

TEST(LoopMeter, countsWhatABeatIsLate)
{
    LoopMeter meter(0.01);
    for (const double beat : {5.0, 5.01, 5.05, 5.055}) meter.beat(beat);
    EXPECT_EQ(meter.lateness().count(), 3U);
    EXPECT_NEAR(meter.lateness().most(), 0.03, 1e-9);
    EXPECT_NEAR(meter.lateness().quantile(0.0), 0.0, 1e-9) << "early is not late";
    meter.frame(0.004, 0.02);
    meter.frame(0.005, -1.0);
    EXPECT_EQ(meter.frames().count(), 2U);
    EXPECT_EQ(meter.latencies().count(), 1U);
    EXPECT_THROW(LoopMeter(0.0), std::invalid_argument);
}

TEST(ConsoleDiagnostics, countEstimatesThatContradictTheReadings)
{
    ConsoleFacts facts;
    facts.estimates = {.estimates = 41, .contradicting = 3};
    const QString text = plainText(consoleDiagnostics(facts, LoopMeter(0.01)));
    EXPECT_TRUE(text.contains("  estimates: 3 of 41 contradicted the readings\n"))
        << text.toStdString();
}

TEST(ConsoleDiagnostics, nameTheFixForAKernelWithoutCan)
{
    const auto lastLine = [](int error) { return canSocketWords(error).section('\n', -1); };
    EXPECT_EQ(canSocketWords(0), "✔ possible");
    EXPECT_EQ(canSocketWords(EAFNOSUPPORT),
              "✘ not possible: the kernel has no CAN sockets (Address family not supported by "
              "protocol)\n"
              "sudo modprobe can_raw   (where that fails: a kernel with CONFIG_CAN_RAW)");
    EXPECT_TRUE(lastLine(EPERM).contains("container"));
    EXPECT_EQ(lastLine(ENOMEM),
              "✘ not possible: a CAN socket cannot be opened (Cannot allocate memory)");
    const ForeignTongue foreign;
    const QString words = canSocketWords(EAFNOSUPPORT);
    EXPECT_FALSE(words.contains(QRegularExpression("[A-Za-z]"))) << words.toStdString();
}

}  // namespace
}  // namespace terratact
