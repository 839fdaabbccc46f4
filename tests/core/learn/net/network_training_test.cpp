#include "core/learn/net/network_training.h"

#include <cmath>
#include <gtest/gtest.h>

using namespace terratact;

namespace {

/// Inputs on a grid of ±1 and targets x₀ x₁, |x₀|.
struct Bowl {
    Eigen::MatrixXf inputs{2, 1024}, targets{2, 1024};
    Bowl()
    {
        for (Eigen::Index n = 0; n < inputs.cols(); ++n) {
            const float a = static_cast<float>(n % 32) / 15.5F - 1.0F;
            const float b = static_cast<float>(n / 32) / 15.5F - 1.0F;
            inputs.col(n) << a, b;
            targets.col(n) << a * b, std::abs(a);
        }
    }
};

NetworkOptions small()
{
    return {.hidden = {24, 24}, .epochs = 120, .batch = 64, .seed = 3};
}

double rmsError(const Network& network, const Bowl& bowl)
{
    double sum = 0.0;
    for (Eigen::Index n = 0; n < bowl.inputs.cols(); ++n)
        sum += (network.output(bowl.inputs.col(n)) - bowl.targets.col(n)).squaredNorm();
    return std::sqrt(sum / static_cast<double>(bowl.targets.size()));
}

}  // namespace

TEST(NetworkTraining, LearnsAProductAndAMagnitude)
{
    const Bowl bowl;
    const Network network = trainNetwork(bowl.inputs, bowl.targets, small());
    EXPECT_EQ(network.inputs(), 2);
    EXPECT_EQ(network.outputs(), 2);
    EXPECT_NO_THROW(requireNetwork(network));
    EXPECT_LT(rmsError(network, bowl), 0.04);
}

TEST(NetworkTraining, SameSeedLearnsTheSame)
{
    const Bowl bowl;
    NetworkOptions options = small();
    options.epochs = 2;
    const Network once = trainNetwork(bowl.inputs, bowl.targets, options);
    const Network again = trainNetwork(bowl.inputs, bowl.targets, options);
    options.seed = 4;
    const Network other = trainNetwork(bowl.inputs, bowl.targets, options);
    for (std::size_t k = 0; k < once.layers.size(); ++k) {
        EXPECT_EQ(once.layers[k].weight, again.layers[k].weight);
        EXPECT_EQ(once.layers[k].bias, again.layers[k].bias);
        EXPECT_NE(once.layers[k].weight, other.layers[k].weight);
    }
}

TEST(NetworkTraining, OutliersMoveItLittle)
{
    const Bowl clean;
    Bowl spoilt;
    for (Eigen::Index n = 0; n < 20; ++n) spoilt.targets(0, 50 * n + 7) = 30.0F;
    const Network network = trainNetwork(spoilt.inputs, spoilt.targets, small());
    EXPECT_LT(rmsError(network, clean), 0.3);
}

TEST(NetworkTraining, TargetsWithoutWeightDoNotCount)
{
    const Bowl clean;
    Bowl spoilt;
    Eigen::MatrixXf weights = Eigen::MatrixXf::Ones(2, 1024);
    for (Eigen::Index n = 0; n < 1024; n += 3) {
        spoilt.targets(0, n) = -3.0F;
        weights(0, n) = 0.0F;
    }
    EXPECT_GT(rmsError(trainNetwork(spoilt.inputs, spoilt.targets, small()), clean), 0.12);
    EXPECT_LT(rmsError(trainNetwork(spoilt.inputs, spoilt.targets, small(), {}, weights), clean),
              0.06);
    EXPECT_EQ(trainNetwork(clean.inputs, clean.targets, small(), {}, Eigen::MatrixXf::Ones(2, 1024))
                  .layers[0]
                  .weight,
              trainNetwork(clean.inputs, clean.targets, small()).layers[0].weight);
    weights(1, 1) = 1.5F;
    EXPECT_THROW(trainNetwork(clean.inputs, clean.targets, small(), {}, weights),
                 std::invalid_argument);
}

TEST(NetworkTraining, RefusesWhatItCannotLearnFrom)
{
    Bowl bowl;
    NetworkOptions options = small();
    EXPECT_THROW(trainNetwork(bowl.inputs, bowl.targets.leftCols(900), options),
                 std::invalid_argument);
    EXPECT_THROW(trainNetwork(bowl.inputs.leftCols(63), bowl.targets.leftCols(63), options),
                 std::invalid_argument);
    options.batch = 0;
    EXPECT_THROW(trainNetwork(bowl.inputs, bowl.targets, options), std::invalid_argument);
    bowl.targets(0, 0) = NAN;
    EXPECT_THROW(trainNetwork(bowl.inputs, bowl.targets, small()), std::invalid_argument);
}

TEST(NetworkTraining, APollEndsIt)
{
    const Bowl bowl;
    int calls = 0;
    const Poll stop = [&calls] {
        if (++calls == 5) throw std::runtime_error("enough");
    };
    EXPECT_THROW(trainNetwork(bowl.inputs, bowl.targets, small(), stop), std::runtime_error);
    EXPECT_EQ(calls, 5);
}

TEST(NetworkTraining, LayersThatDoNotFitAreRefused)
{
    Network network{{{Eigen::MatrixXf::Ones(3, 2), Eigen::VectorXf::Zero(3)},
                     {Eigen::MatrixXf::Ones(1, 3), Eigen::VectorXf::Zero(1)}}};
    EXPECT_NO_THROW(requireNetwork(network));
    EXPECT_THROW(network.output(Eigen::VectorXf::Zero(3)), std::invalid_argument);
    network.layers[1].weight.resize(1, 4);
    EXPECT_THROW(requireNetwork(network), std::invalid_argument);
    network.layers[1].weight = Eigen::MatrixXf::Constant(1, 3, INFINITY);
    EXPECT_THROW(requireNetwork(network), std::invalid_argument);
    EXPECT_THROW(requireNetwork({}), std::invalid_argument);
}
