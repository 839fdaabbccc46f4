#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "core/base/poll.h"
#include "core/learn/net/network.h"

namespace terratact {

/// Effort and form of a network's training.
struct NetworkOptions {
    std::vector<Eigen::Index> hidden{256, 256};  ///< width of each hidden layer
    int epochs = 30;                             ///< passes over all rows
    Eigen::Index batch = 256;                    ///< rows per step
    double peakRate = 3e-3;                      ///< largest step size
    double weightDecay = 1e-2;                   ///< AdamW's decay per unit of step size
    double huber = 0.5;                          ///< error above which the loss is linear
    std::uint64_t seed = 1;                      ///< of the first weights and the order of the rows
};

/// Learns a network by AdamW on the mean over all outputs of weight times Huber loss:
///   loss(e) = e² / (2 h) for |e| < h, |e| − h / 2 above.
/// Weights and biases begin uniform within ± 1 / √inputs. Each pass visits the rows in a new order,
/// and drops the last ones that do not fill a batch. Over the first 30 % of the steps, the step size
/// rises from peakRate / 25 to peakRate. Then it falls to peakRate / 250 000. Both follow a cosine.
///   inputs: d × n; targets: o × n; standardised, one column per row of training.
///   weights: o × n, 0 … 1; without numbers: all are 1.
/// Single precision. The same data and seed give the same network on one machine. poll: called
/// before each step; what it throws is rethrown. Throws std::invalid_argument if the numbers of
/// columns differ, or if they fill no batch. It also throws for a number that is not finite, a weight out of range or a
/// non-positive option. Source: Loshchilov, Hutter, Decoupled weight decay regularization (ICLR 2019).
Network trainNetwork(const Eigen::MatrixXf& inputs, const Eigen::MatrixXf& targets,
                     const NetworkOptions& options, const Poll& poll = {},
                     const Eigen::MatrixXf& weights = {});

}  // namespace terratact
