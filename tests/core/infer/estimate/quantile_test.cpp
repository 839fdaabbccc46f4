#include "core/infer/estimate/quantile.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace terratact {
namespace {

TEST(Quantile, interpolatesAsRDoesByDefault)
{
    const std::vector<double> x{4.0, 1.0, 8.0, 2.0};  // quantile(x, p, type = 7)
    EXPECT_DOUBLE_EQ(quantile(x, 0.0), 1.0);
    EXPECT_DOUBLE_EQ(quantile(x, 0.25), 1.75);
    EXPECT_DOUBLE_EQ(quantile(x, 0.5), 3.0);
    EXPECT_DOUBLE_EQ(quantile(x, 0.75), 5.0);
    EXPECT_DOUBLE_EQ(quantile(x, 1.0), 8.0);
    EXPECT_DOUBLE_EQ(quantile({5.0}, 0.3), 5.0);
    EXPECT_THROW(quantile({}, 0.5), std::invalid_argument);
    EXPECT_THROW(quantile(x, 1.5), std::invalid_argument);
}

}  // namespace
}  // namespace terratact
