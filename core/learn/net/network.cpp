#include "core/learn/net/network.h"

#include <stdexcept>

namespace terratact {

Eigen::MatrixXf silu(const Eigen::MatrixXf& a)
{
    return (a.array() / (1.0F + (-a.array()).exp())).matrix();
}

Eigen::VectorXf Network::output(const Eigen::VectorXf& x) const
{
    if (x.size() != inputs()) throw std::invalid_argument("a network needs one number per input");
    Eigen::VectorXf state = x;
    for (std::size_t k = 0; k < layers.size(); ++k) {
        Eigen::VectorXf next = layers[k].weight * state + layers[k].bias;
        state = k + 1 < layers.size() ? Eigen::VectorXf(silu(next)) : next;
    }
    return state;
}

void requireNetwork(const Network& network)
{
    if (network.layers.empty()) throw std::invalid_argument("a network needs a layer");
    for (std::size_t k = 0; k < network.layers.size(); ++k) {
        const NetworkLayer& layer = network.layers[k];
        const bool fits = layer.weight.rows() == layer.bias.size() && layer.weight.size() > 0
                       && (k == 0 || layer.weight.cols() == network.layers[k - 1].weight.rows());
        if (!fits) throw std::invalid_argument("the layers of a network do not fit each other");
        if (!layer.weight.allFinite() || !layer.bias.allFinite())
            throw std::invalid_argument("a number of a network is not finite");
    }
}

}  // namespace terratact
