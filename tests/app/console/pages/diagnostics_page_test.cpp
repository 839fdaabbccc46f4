// Tests the diagnostics page: lateness of the event loop.
#include <gtest/gtest.h>

#include <QApplication>
#include <QRegularExpression>
#include <cerrno>

#include "app/console/pages/diagnostics_page.h"
#include "app/shell/loop_meter.h"
#include "tests/support/foreign_tongue.h"

namespace terratact {
namespace {

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
    const auto lastLine = [](int error) { return canSocketText(error).section('\n', -1); };
    EXPECT_EQ(canSocketText(0), "✔ possible");
    EXPECT_EQ(canSocketText(EAFNOSUPPORT),
              "✘ not possible: the kernel has no CAN sockets (Address family not supported by "
              "protocol)\n"
              "sudo modprobe can_raw   (where that fails: a kernel with CONFIG_CAN_RAW)");
    EXPECT_TRUE(lastLine(EPERM).contains("container"));
    EXPECT_EQ(lastLine(ENOMEM),
              "✘ not possible: a CAN socket cannot be opened (Cannot allocate memory)");
    const ForeignTongue foreign;
    const QString words = canSocketText(EAFNOSUPPORT);
    EXPECT_FALSE(words.contains(QRegularExpression("[A-Za-z]"))) << words.toStdString();
}

}  // namespace
}  // namespace terratact
