#pragma once

#include <Eigen/Core>
#include <array>
#include <map>
#include <vector>

#include "core/base/poll.h"
#include "core/learn/model/model.h"
#include "core/learn/model/residual_sample.h"
#include "core/learn/model/surface_rows.h"
#include "core/terrain/bins.h"

namespace terratact {

/// Surface processes of a model, ready to predict. Immutable; may be shared between threads.
class ClearanceModel {
public:
    /// model: rows of one plane or of sides (SurfaceData). without: features of s that the processes
    /// were trained without (reduced_clearances.h); their values have no effect. places: place of
    /// each training row; empty: computed from the model's rows (placesOf). Throws
    /// std::invalid_argument if the model's clearance part is missing or its sizes disagree.
    explicit ClearanceModel(const SurfaceData& model, AbsentFeatures without = {},
                            std::vector<int> places = {});

    AbsentFeatures without() const { return without_; }

    /// Returns the mean surface coordinate of every bin. features: FeatureSet::Paf or one side's, raw.
    Heights predict(const Eigen::VectorXd& features, unsigned covered) const;

    /// Returns the residuals of the kNeighbours nearest training scenes in s with the same bins
    /// covered. Each place gives one at most:
    ///   D² = Σ_d (x_d − x'_d)² w_d²,  w_d² = mean over the processes of 1 / ℓ_d²
    /// with the weights of residualWeights(). If too few scenes have the same bins covered,
    /// other scenes follow. A bin may have another regime there, or an unknown height. It
    /// then takes the residual of the nearest scenes that have it in the right regime. A bin
    /// that no training scene has in this regime gets normal quantiles times its residual
    /// sd.
    ResidualSample localResiduals(const Eigen::VectorXd& features, unsigned covered) const;

    /// Returns the second moments of the residuals, each pair over the scenes in which both bins
    /// are in this regime: 11 × 11, positive definite. Each place has the weight of one scene.
    /// Scenes with unknown heights do not count.
    Eigen::MatrixXd residualCovariance(unsigned covered) const;

    /// Covered bins of both sides: left, right.
    using SideBins = std::array<unsigned, 2>;

    /// Returns the residuals of both sides, as localResiduals() does. They are from the kNeighbours
    /// training scenes nearest to the left side's features. A scene and its mirror image count as
    /// two scenes of one place. D weighs own and other side alike. Errors of both sides
    /// correlate; these vectors keep that. right: the model of the right side, which may lack other
    /// features of the same training rows.
    ResidualSample sideResiduals(const ClearanceModel& right, const Eigen::VectorXd& leftFeatures,
                                 const SideBins& covered) const;

    /// Returns residualCovariance() of both sides: 22 × 22, left above right.
    Eigen::MatrixXd sideCovariance(const ClearanceModel& right, const SideBins& covered) const;

    /// Returns the novelty: D to the 10th nearest training scene, over the distance that 1 % of the
    /// training scenes exceed.
    double novelty(const Eigen::VectorXd& features) const;

    double contactBias() const { return contactBias_; }
    double contactSd() const { return contactSd_; }

    /// Returns w_d, and the distance of a model's noveltyScale; used by training. If features are
    /// left out, a process counts in w_d by its rows. A few rows may give an unusual length scale.
    /// Of sides, w_d² is the mean of own and other side, and noveltyScale looks at 3000 rows.
    static Eigen::VectorXd metric(const SurfaceData& model, AbsentFeatures without = {});
    static double noveltyScale(const SurfaceData& model, const Poll& poll = {},
                               AbsentFeatures without = {});

private:
    struct Process {
        double mean = 0.0, residualSd = 0.0, signal2 = 0.0;
        Eigen::MatrixXd inducing;   ///< d × m
        Eigen::VectorXd perLength;  ///< d: 1 / ℓ
        Eigen::VectorXd weights;    ///< m
    };
    /// Sums over the scenes that cover the same bins.
    struct ResidualProducts {
        Eigen::Matrix<double, kBins, kBins> sum = Eigen::Matrix<double, kBins, kBins>::Zero();
        double count = 0.0;
    };
    /// The same of both sides, left above right.
    struct SideProducts {
        Eigen::Matrix<double, 2 * kBins, 2 * kBins> sum =
            Eigen::Matrix<double, 2 * kBins, 2 * kBins>::Zero();
        double count = 0.0;
    };
    /// By the covered bins of both sides, those of the right side shifted by kBins bits.
    using ProductsOfSides = std::map<unsigned, SideProducts>;
    ProductsOfSides productsWith(const ClearanceModel& right) const;
    static Process prepare(const SurfaceProcess& data, const Eigen::MatrixXd& X,
                           const std::vector<int>& rows);
    const Process& process(int bin, bool covered) const;
    Eigen::VectorXd standardised(const Eigen::VectorXd& features) const;
    Eigen::VectorXd squaredDistances(const Eigen::VectorXd& features) const;
    template <class Differs>
    std::vector<int> nearest(const Eigen::VectorXd& squaredDistance, Differs differs) const;
    void borrow(ResidualSample& sample, Eigen::Index first, const std::vector<int>& rows,
                const Eigen::VectorXd& distance, unsigned covered) const;
    void borrowBin(ResidualSample& sample, Eigen::Index first, const std::vector<int>& rows,
                   const Eigen::VectorXd& distance, int bin, bool covered) const;
    void requireSidesOf(const ClearanceModel& right) const;
    bool isComplete(int row) const;  ///< all heights of the row are known

    AbsentFeatures without_;
    Eigen::VectorXd featureMean_, featureSd_, metric_;
    Eigen::MatrixXd scenes_;  ///< d × U: standardised features times the metric
    std::array<Process, kBins> open_, covered_;
    std::vector<unsigned> coveredBins_, unknownBins_;
    std::vector<int> places_;
    Eigen::MatrixXd residuals_;                      ///< 11 × U
    std::map<unsigned, ResidualProducts> products_;  ///< indexed by the covered bins
    ProductsOfSides ownSides_;  ///< productsWith(*this) of a model of two tracks
    double noveltyScale_ = 1.0;
    double contactBias_ = 0.0, contactSd_ = 0.0;
};

}  // namespace terratact
