// Estimates of extreme scenes by every method: each is right or refused with a text, without NaN and
// without a hang.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/infer/estimator.h"
#include "core/learn/model/clearance.h"
#include "core/terrain/kinematic_reconstruction.h"
#include "tests/core/infer/extreme_scenes.h"

namespace terratact {
namespace {

/// Returns the robot with its IMU raised: robot and ground lie deeper in the DEM frame.
RobotModel loweredBy(double metres)
{
    RobotModel low = robot();
    low.imu.z += metres;
    return low;
}

class EveryMethod : public testing::TestWithParam<Method> {
protected:
    Asked asked()
    {
        Asked a;
        a.settings.method = GetParam();
        a.settings.draws = 200;
        a.settings.burnIn = 10;
        return a;
    }
    std::string what() { return std::string(name(GetParam())); }
};

TEST_P(EveryMethod, answersWithNoBinUnknown)
{
    Asked all = asked();
    for (int bin = 0; bin < kBins; ++bin)
        all.arm.push_back({bin, *all.scene.truth[static_cast<std::size_t>(bin)], 0.03});
    const TerrainEstimate e = estimateOf(all);
    expectSound(e, what());
    for (std::size_t i = 0; i < kBins; ++i) {
        EXPECT_EQ(e.origin[i], Origin::Arm);
        EXPECT_NEAR(e.mean[i], *all.scene.truth[i], 0.1) << what() << ", bin " << i;
    }
}

TEST_P(EveryMethod, answersWithEveryBinUnknown)
{
    Asked nothing = asked();
    nothing.settings.contacts = ContactRule::None;
    const TerrainEstimate e = estimateOf(nothing);
    expectSound(e, what());
    EXPECT_EQ(std::count(e.origin.begin(), e.origin.end(), Origin::Sampled), kBins);
}

TEST_P(EveryMethod, oneDrawOfOneChainNeverConverges)
{
    for (const int draws : {1, 2, 3, 5}) {
        Asked one = asked();
        one.settings.draws = draws;
        one.settings.chains = 1;
        one.settings.burnIn = 0;
        const TerrainEstimate e = estimateOf(one);
        expectSound(e, what());
        EXPECT_EQ(e.draws.size(), static_cast<std::size_t>(draws));
        if (!isClosedForm(GetParam())) {
            EXPECT_FALSE(e.converged) << draws;
        }
    }
}

TEST_P(EveryMethod, answersContradictoryContactsWithAWarning)
{
    Asked odd = asked();
    odd.settings.contacts = ContactRule::Any;
    odd.scene.s.force.fill(150.0);
    odd.scene.s.front = 1.2;  // an upright flipper with every element loaded
    const auto contacts = reconstructContacts(robot(), odd.scene.s, 2.0, false).contacts;
    ASSERT_GT(contacts.size(), 1U);
    odd.arm.push_back({contacts.front().bin, -1.0, 0.03});
    if (GetParam() == Method::Clearance) {  // training never had uncovered ground so far ahead
        EXPECT_THROW((void)estimateOf(odd), NotLearnt);
        return;
    }
    const TerrainEstimate e = estimateOf(odd);
    expectSound(e, what());
    EXPECT_EQ(e.origin[static_cast<std::size_t>(contacts.front().bin)], Origin::Arm);
    if (usesForces(GetParam())) {
        EXPECT_TRUE(std::any_of(e.warnings.begin(), e.warnings.end(), [](const Message& w) {
            return w.english().find("contact and arm disagree") != std::string::npos;
        })) << what();
    }
}

TEST_P(EveryMethod, takesAProbeTenDeviationsOutsideItsPrior)
{
    Asked own = asked();
    own.settings.hazardRate = 0.0;  // a hazard's sd would carry the probe hundreds of metres away
    const TerrainEstimate before = estimateOf(own);
    for (const int bin : {0, 5, 10})
        for (const double sds : {-10.0, 10.0, -1000.0}) {
            const auto i = static_cast<std::size_t>(bin);
            Asked probed = own;
            probed.arm.push_back({bin, before.mean[i] + sds * std::max(before.sd[i], 0.02), 0.03});
            const TerrainEstimate e = estimateOf(probed);
            expectSound(e, what() + ", bin " + std::to_string(bin));
            EXPECT_EQ(e.origin[i], Origin::Arm);
            const double read = probed.arm.front().height;
            const bool bounded = isClosedForm(GetParam()) && !std::isinf(e.ceiling[i]);
            const double reading = bounded ? std::max(read, e.ceiling[i] - kDeepestSurface) : read;
            if (isOfPaper(GetParam())) {
                EXPECT_EQ(e.mean[i], read);
                // a few sd away, or more than half of the distance
            } else if (reading < e.ceiling[i]) {
                const double near = 4.0 * std::max(e.sd[i], 0.03);
                EXPECT_NEAR(e.mean[i], reading,
                            std::max(near, 0.5 * std::abs(reading - before.mean[i])))
                    << what() << ", bin " << bin << ", " << sds << " deviations";
            }
        }
}

TEST_P(EveryMethod, keepsBelowCeilingsThatLieBelowEveryTrainingHeight)
{
    for (const double by : {1.0, 10.0, 1e6})
        for (const ContactRule contacts : {ContactRule::None, ContactRule::Any}) {
            Asked deep = asked();
            deep.scene.s.pitch = 0.0;  // otherwise the IMU is far ahead, too
            deep.settings.draws = 64;
            deep.settings.contacts = contacts;
            const TerrainEstimate e = estimateOf(deep, {}, loweredBy(by));
            const std::string which = what() + ", by " + std::to_string(by);
            expectSound(e, which);
            int below = 0;
            for (std::size_t i = 0; i < kBins; ++i) {
                if (e.origin[i] != Origin::Sampled || std::isinf(e.ceiling[i])) continue;
                ASSERT_LT(e.ceiling[i], modelData().heights.minCoeff()) << which;
                if (GetParam() == Method::Pa) continue;  // uses no ceiling
                ++below;
                const double most =
                    e.ceiling[i] + (isClosedForm(GetParam()) ? kDeepestSinking : 0.0);
                for (const double height : {e.mean[i], e.height[i], e.q10[i], e.q90[i]})
                    EXPECT_LE(height, most + 1e-12 * by) << which << ", bin " << i;
                for (const Heights& draw : e.draws) EXPECT_LE(draw[i], most) << which;
            }
            if (GetParam() != Method::Pa) {
                EXPECT_GE(below, 3) << which;
            }
        }
}

TEST_P(EveryMethod, answersOrRefusesEveryPose)
{
    int answered = 0, refused = 0;
    for (const double pitch : {-89.0, -45.0, 45.0, 89.0})
        for (const double front : {-180.0, -90.0, 0.0, 180.0})
            for (const double rear : {-180.0, 90.0, 180.0}) {
                Asked odd = asked();
                odd.settings.draws = 16;
                odd.settings.burnIn = 2;
                odd.scene.s.pitch = pitch / 57.29577951308232;
                odd.scene.s.front = front / 57.29577951308232;
                odd.scene.s.rear = rear / 57.29577951308232;
                try {
                    expectSound(estimateOf(odd), what() + " at " + std::to_string(pitch) + ", "
                                                     + std::to_string(front));
                    ++answered;
                } catch (const NotLearnt& why) {
                    EXPECT_NE(std::string(why.what()).find("training scenes"), std::string::npos);
                    ++refused;
                }
            }
    std::cout << what() << ": " << answered << " answered, " << refused << " refused\n";
    EXPECT_EQ(answered + refused, 48);
    if (GetParam() == Method::Clearance) {  // distinguishes covered and open bins
        EXPECT_GE(answered, 1);
        EXPECT_GE(refused, 1);
    } else {
        EXPECT_EQ(refused, 0);
    }
}

TEST_P(EveryMethod, refusesWhatIsNotANumber)
{
    for (double Proprioception::*field :
         {&Proprioception::pitch, &Proprioception::front, &Proprioception::rear})
        for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
            Asked odd = asked();
            odd.scene.s.*field = bad;
            EXPECT_THROW((void)estimateOf(odd), std::invalid_argument) << what();
        }
    Asked odd = asked();
    odd.scene.s.force[2] = std::nan("");
    if (usesForces(GetParam())) {
        EXPECT_THROW((void)estimateOf(odd), std::invalid_argument) << what();
    }
    odd = asked();
    odd.arm.push_back({4, std::nan(""), 0.03});
    EXPECT_THROW((void)estimateOf(odd), std::invalid_argument) << what();
}

TEST_P(EveryMethod, isCancelledAtEveryPollAndThenRepeatable)
{
    Asked quick = asked();
    quick.settings.draws = isClosedForm(GetParam()) ? 30000 : 16;
    quick.settings.stopEarly = !isClosedForm(GetParam());
    quick.settings.burnIn = 1;
    int asking = 0;
    Watch counting;
    counting.cancelled = [&] {
        ++asking;
        return false;
    };
    const TerrainEstimate expected = estimateOf(quick, counting);
    const int fewest = asking;
    EXPECT_GT(fewest, 20);
    const Models fresh(modelData(), robot());
    const auto run = [&](int last) {
        int left = last;
        Watch watch;
        watch.cancelled = [&] {
            ++asking;
            return --left == 0;
        };
        return estimateTerrain(quick.scene.s, {}, robot(), fresh, quick.settings, watch);
    };
    // Models start cold: every cancelled run leaves its models to the next one.
    for (const int last : {1, 2, 3, 5, 8, 13, 21, 34, 55}) {
        if (last > fewest) break;
        EXPECT_THROW((void)run(last), Cancelled) << last;
    }
    EXPECT_EQ(run(-1), expected);
    asking = 0;
    EXPECT_EQ(run(-1), expected);
    const int all = asking;
    for (int last = 1; last <= all; last += std::max(1, all / 60))
        EXPECT_THROW((void)run(last), Cancelled) << last << " of " << all;
    EXPECT_EQ(run(-1), expected);
}

INSTANTIATE_TEST_SUITE_P(Methods, EveryMethod, testing::ValuesIn(kMethods),
                         [](const auto& method) { return std::string(name(method.param)); });

}  // namespace
}  // namespace terratact
