#include "core/learn/gp/symmetric_eigen.h"

#include <gtest/gtest.h>

#include <Eigen/Core>

namespace terratact {
namespace {

TEST(SymmetricEigen, productGivesTheMatrix)
{
    Eigen::Matrix3d A;
    A << 2.0, -1.0, 0.5, -1.0, 3.0, 0.25, 0.5, 0.25, -4.0;
    const SymmetricEigen eigen = symmetricEigen(A);
    EXPECT_LT(eigen.values[0], eigen.values[1]);
    EXPECT_LT(eigen.values[1], eigen.values[2]);
    EXPECT_TRUE(
        (eigen.vectors * eigen.values.asDiagonal() * eigen.vectors.transpose()).isApprox(A, 1e-14));
    EXPECT_TRUE((eigen.vectors.transpose() * eigen.vectors).isIdentity(1e-14));
}

TEST(SymmetricEigen, readsTheLowerTriangle)
{
    Eigen::Matrix2d A;
    A << 1.0, 99.0, 2.0, 1.0;
    const SymmetricEigen eigen = symmetricEigen(A);
    EXPECT_NEAR(eigen.values[0], -1.0, 1e-14);
    EXPECT_NEAR(eigen.values[1], 3.0, 1e-14);
}

}  // namespace
}  // namespace terratact
