#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/learn/data/drive_copies.h"
#include "core/learn/model/residual_sample.h"
#include "core/learn/net/network.h"
#include "core/terrain/bins.h"

namespace terratact {

/// Mean and sd of a bin's surface coordinate (core/learn/model/clearance.h) in one regime. The sd is 0
/// if training had too few scenes of it.
struct TrailScale {
    double mean = 0.0, sd = 0.0;
    bool operator==(const TrailScale&) const = default;
};

/// Scenes of drives that no network learnt from. Their errors are those of new drives. One column
/// per scene: 11 rows of one plane, 22 of both sides, left above right.
struct TrailErrors {
    Eigen::MatrixXf predicted;  ///< mean of the networks, in sd of TrailScale
    /// Truth minus that mean, in expected sizes of the scene's errors (TrailNetworks::size).
    Eigen::MatrixXf residual;
    std::vector<std::array<unsigned, 2>> covered;  ///< covered bins; of one plane: both equal
    std::vector<int> drive;                        ///< number of the scene's drive, from 0
};

/// Networks that predict the eleven bins of one plane or of one side, and their errors.
struct TrailNetworks {
    Eigen::VectorXd inputMean, inputSd;
    std::array<TrailScale, kBins> open, covered;
    std::vector<Network> networks;  ///< of different seeds; their mean counts
    /// One linear layer: log of the expected size of each bin's error e, the geometric mean of
    /// |e| + 0.1 [sd of TrailScale]. Its inputs are log(s + kMinSpread) of the bins, where s is the sd
    /// of the networks, and their standardised inputs.
    Network size;
    TrailErrors errors;
    /// Training drives, those of the errors, too; empty: unknown.
    std::vector<DriveMarks> drives;

    bool isEmpty() const { return networks.empty(); }
    /// Returns true if training held the regime of every bin. mask: covered bins.
    bool knows(unsigned mask) const;
};

/// What a model file of the method `trail` holds.
struct TrailData {
    TrailNetworks plane, side;
    std::string command;  ///< that trained it
    std::uint64_t seed = 0;
    std::string planeHash, sideHash;  ///< SHA-256 of the drives, hex; empty: not trained
};

/// Lower bound of the sd by the networks' disagreement, in sd of TrailScale.
inline constexpr double kMinSpread = 1e-3;

/// Number of scenes whose errors form those of a scene. They are of as many drives as possible, because
/// the errors of one drive are nearly one error.
inline constexpr int kTrailNeighbours = 60;

/// Surface coordinates, and the errors of similar scenes around their own mean. One plane has 11 rows. Both sides have
/// 22, left above right. That mean does not correct the prediction: on generated drives, the correction makes larger
/// errors.
struct TrailPrediction {
    Eigen::VectorXd mean;
    ResidualSample errors;
};

/// The networks, ready to predict. Immutable; may be shared between threads.
class TrailModel {
public:
    /// Throws std::invalid_argument for parts that do not fit each other.
    explicit TrailModel(TrailData data);

    bool hasPlane() const { return !data_.plane.isEmpty(); }
    bool hasSides() const { return !data_.side.isEmpty(); }
    bool knowsPlane(unsigned covered) const { return data_.plane.knows(covered); }
    bool knowsSides(const std::array<unsigned, 2>& covered) const
    {
        return data_.side.knows(covered[0]) && data_.side.knows(covered[1]);
    }

    /// Predict from planeInputs(), and from sideInputs() of the left and the right side
    /// (trail_inputs.h). covered: bins of the plane, or of both sides. The errors are those of the
    /// kTrailNeighbours scenes with the nearest predictions:
    ///   D² = Σ (p − p')² + kOtherRegime · bins in another regime
    /// with the weights of residualWeights(). They are scaled to the expected size of this scene's errors.
    /// Each drive gives one scene. If there are fewer drives than scenes wanted, each gives the least
    /// number that suffices. A drive of two tracks and its mirror image count as two. Throw
    /// std::invalid_argument if the inputs do not fit, or without such networks. Throw RefusedInput if
    /// the output is not finite.
    TrailPrediction plane(const Eigen::VectorXd& inputs, unsigned covered) const;
    TrailPrediction sides(const std::array<Eigen::VectorXd, 2>& inputs,
                          const std::array<unsigned, 2>& covered) const;

    const TrailData& data() const { return data_; }

    static constexpr double kOtherRegime = 4.0;

private:
    TrailData data_;
};

/// Output of the networks for one column of inputs, in sd of TrailScale.
struct TrailOutput {
    Eigen::VectorXf mean;
    Eigen::VectorXf sizeInputs;  ///< of TrailNetworks::size
};
TrailOutput outputOf(const TrailNetworks& networks, const Eigen::VectorXd& inputs);

/// Returns the expected size of each bin's error in sd of TrailScale, from e⁻³ to e³.
Eigen::VectorXf errorSize(const TrailNetworks& networks, const TrailOutput& output);

/// Throws std::invalid_argument unless all parts fit each other and are finite. inputs: expected
/// number; sides: 1 for a plane, 2 for both sides.
void requireTrailNetworks(const TrailNetworks& networks, Eigen::Index inputs, Eigen::Index sides);

}  // namespace terratact
