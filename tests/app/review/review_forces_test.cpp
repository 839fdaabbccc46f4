// Tests the peaks of forces in a review.
#include "app/review/review_forces.h"

#include <gtest/gtest.h>

#include "app/pages/terrain_page.h"
#include "app/review/review_window.h"
#include "tests/support/benches/review_bench.h"
#include "tests/support/gui.h"
#include "tests/support/sessions/robot_session.h"
#include "widgets/signals/force_bars.h"

namespace terratact {
namespace {

using namespace gui;
using At = RobotSessionTimes;

TEST_F(ReviewOf, forcePeaksAtATimeDoNotDependOnThePath)
{
    path = TERRATACT_SOURCE_DIR "/resources/sessions/demo.tts";
    open();
    const auto peaks = [&] {
        const ForceBars& bars = *window->terrainPage()->forces();
        std::vector<std::optional<double>> all;
        for (int array = 0; array < bars.arrays(); ++array)
            for (int e = 0; e < kForceElements; ++e) all.push_back(bars.peak(e, array));
        return all;
    };
    const auto shown = [&](double time) {
        window->goTo(time);
        return peaks();
    };
    constexpr double kLetGo = 20.0;  // [s] start of the search
    double at = 0.0;                 // time at which an element's force falls
    std::vector<std::optional<double>> jumped;
    for (double t = kLetGo; at == 0.0 && t < window->player().end(); t += 0.5) {
        jumped = shown(t);
        const auto& measured = window->moment().measurement;
        for (std::size_t e = 0; measured && e < measured->force.size(); ++e)
            if (jumped[e] && *jumped[e] > measured->force[e] + 1.0) at = t;
    }
    ASSERT_GT(at, 0.0) << "the session has a peak that stands above its bar";
    for (double t = at - 1.0; t < at; t += 0.04) window->goTo(t);
    EXPECT_EQ(shown(at), jumped) << "played there";
    for (double t = at + 5.0; t > at; t -= 0.3) window->goTo(t);
    EXPECT_EQ(shown(at), jumped) << "played there backwards";
    window->goTo(1.0);
    EXPECT_EQ(shown(at), jumped) << "from far away";
    open();
    EXPECT_EQ(shown(at), jumped) << "in a window that was nowhere else";
}

}  // namespace
}  // namespace terratact
