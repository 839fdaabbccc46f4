#include "widgets/terrain/readings/estimate_strip.h"

#include <gtest/gtest.h>

#include "tests/support/estimates.h"
#include "tests/support/gui.h"

namespace terratact {
namespace {

TEST(EstimateStripOfTwoTracks, aWarningOfOneSideNamesThatSide)
{
    EstimateStrip strip;
    gui::showActive(strip);
    TwoTrackEstimate e = leftStepEstimate();
    const Message both = Message::verbatim("no current"), one = Message::verbatim("no force");
    e.side[0].warnings = {both};
    e.side[1].warnings = {both, one};
    strip.setEstimate(e, 0.1);
    EXPECT_EQ(strip.warningText().toStdString(), "! no current · right: no force");
    e.side[1].warnings.clear();
    e.side[1].converged = false;
    strip.setEstimate(e, 0.1);
    EXPECT_EQ(strip.warningText().toStdString(),
              "! left: no current · right: the chains have not converged");
}

}  // namespace
}  // namespace terratact
