#pragma once

#include <Eigen/Core>
#include <vector>

namespace terratact {

/// One layer: a = weight · x + bias.
struct NetworkLayer {
    Eigen::MatrixXf weight;  ///< outputs × inputs
    Eigen::VectorXf bias;    ///< outputs
};

/// Returns a / (1 + e⁻ᵃ), element by element: the activation between two layers (SiLU). Source:
/// Elfwing, Uchibe, Doya, Neural Networks 107 (2018).
Eigen::MatrixXf silu(const Eigen::MatrixXf& a);

/// Fully connected network. The output of each layer but the last passes through silu().
struct Network {
    std::vector<NetworkLayer> layers;

    Eigen::Index inputs() const { return layers.front().weight.cols(); }
    Eigen::Index outputs() const { return layers.back().weight.rows(); }

    /// Returns the output. x: inputs(). Throws std::invalid_argument if the size differs.
    Eigen::VectorXf output(const Eigen::VectorXf& x) const;
};

/// Throws std::invalid_argument unless there is a layer, the layers fit each other, and every number
/// is finite.
void requireNetwork(const Network& network);

}  // namespace terratact
