#include "core/base/normal.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace terratact {
namespace {

TEST(Normal, sharesAndQuantilesAreThoseOfTables)
{
    EXPECT_EQ(normalCdf(0.0), 0.5);
    EXPECT_NEAR(normalCdf(1.0), 0.8413447460685429, 1e-15);
    EXPECT_NEAR(normalCdf(-3.0), 0.0013498980316300946, 1e-17);
    EXPECT_EQ(normalQuantile(0.5), 0.0);
    EXPECT_NEAR(normalQuantile(0.9), 1.2815515655446004, 1e-14);
    EXPECT_NEAR(normalQuantile(0.025), -1.9599639845400545, 1e-14);
}

TEST(Normal, quantilesFarInTheTailsKeepTheirShare)
{
    for (int e = 1; e <= 300; ++e) {
        const double p = std::pow(10.0, -e);
        EXPECT_NEAR(normalCdf(normalQuantile(p)) / p, 1.0, 1e-12 * e) << p;
    }
}

TEST(Normal, quantilesOfNoShareAreRefused)
{
    EXPECT_THROW(normalQuantile(-0.1), std::domain_error);
    EXPECT_THROW(normalQuantile(1.1), std::domain_error);
    EXPECT_THROW(normalQuantile(0.0), std::overflow_error);
    EXPECT_THROW(normalQuantile(1.0), std::overflow_error);
}

}  // namespace
}  // namespace terratact
