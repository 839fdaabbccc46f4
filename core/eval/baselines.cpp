#include "core/eval/baselines.h"

#include <Eigen/QR>
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <random>
#include <stdexcept>
#include <utility>

#include "core/learn/gp/gaussian_process.h"
#include "core/learn/model/surface_rows.h"
#include "core/learn/model/training.h"
#include "core/robot/kinematics.h"
#include "core/terrain/body_ceiling.h"

namespace terratact {
namespace {

constexpr Eigen::Index kMinRows = 30;
constexpr Eigen::Index kNeighbours = 20;
constexpr Eigen::Index kSearchRows = 400;
constexpr Eigen::Index kPredictRows = 1000;
constexpr double kMinSd = 0.001;                   // [m]
constexpr double kNormalQ90 = 1.2815515655446004;  // Φ⁻¹(0.9)

Heights atLeast(const Heights& sd)
{
    Heights result = sd;
    for (double& x : result) x = std::max(x, kMinSd);
    return result;
}

/// Returns the heights of the tracks' lower edge at the bins' centres.
Heights trackPlane(const RobotModel& robot, double pitch)
{
    const Pose pose = poseInDem(robot, pitch, 0.0, 0.0);
    const Vec2 below = toWorld(pose, {0.0, robot.trackZ - robot.trackRadius});
    Heights heights{};
    for (int i = 0; i < kBins; ++i)
        heights[static_cast<std::size_t>(i)] = below.z + std::tan(pitch) * (binCentre(i) - below.x);
    return heights;
}

class Flat final : public Baseline {
public:
    Flat(const RobotModel& robot, const ModelData& model) : robot_(robot)
    {
        const auto n = static_cast<double>(model.heights.rows());
        Heights squares{};
        for (Eigen::Index u = 0; u < model.heights.rows(); ++u) {
            const Heights plane = trackPlane(robot_, model.features(u, 0));
            for (std::size_t i = 0; i < kBins; ++i)
                squares[i] +=
                    std::pow(model.heights(u, static_cast<Eigen::Index>(i)) - plane[i], 2);
        }
        for (std::size_t i = 0; i < kBins; ++i) sd_[i] = std::sqrt(squares[i] / n);
        sd_ = atLeast(sd_);
    }
    std::string_view name() const override { return "flat"; }
    FeatureSet needs() const override { return FeatureSet::Pa; }
    BandForecast forecast(const Proprioception& s) const override
    {
        return {trackPlane(robot_, s.pitch), sd_};
    }

private:
    RobotModel robot_;
    Heights sd_{};
};

class Linear final : public Baseline {
public:
    explicit Linear(const ModelData& model)
    {
        Eigen::MatrixXd A(model.features.rows(), model.features.cols() + 1);
        A << Eigen::VectorXd::Ones(A.rows()), model.features;
        const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(A);
        weights_ = qr.solve(model.heights);
        const Eigen::MatrixXd residuals = model.heights - A * weights_;
        const auto freedom = static_cast<double>(std::max<Eigen::Index>(1, A.rows() - qr.rank()));
        for (std::size_t i = 0; i < kBins; ++i)
            sd_[i] = std::sqrt(residuals.col(static_cast<Eigen::Index>(i)).squaredNorm() / freedom);
        sd_ = atLeast(sd_);
    }
    std::string_view name() const override { return "linear"; }
    BandForecast forecast(const Proprioception& s) const override
    {
        const Eigen::VectorXd x = features(needs(), s);
        BandForecast result{.height = {}, .sd = sd_};
        Eigen::Map<Eigen::VectorXd>(result.height.data(), kBins) =
            weights_.row(0).transpose() + weights_.bottomRows(x.size()).transpose() * x;
        return result;
    }

private:
    Eigen::MatrixXd weights_;  // (1 + f) × 11
    Heights sd_{};
};

/// Standardises features; features that never vary become 0.
class Scaling {
public:
    explicit Scaling(const Eigen::MatrixXd& X) : mean_(X.colwise().mean())
    {
        const auto n = static_cast<double>(X.rows());
        const Eigen::VectorXd sd =
            ((X.rowwise() - mean_.transpose()).array().square().colwise().sum() / n).sqrt();
        factor_ = (sd.array() > 1e-12).select(1.0 / sd.array().max(1e-12), 0.0);
    }
    Eigen::VectorXd operator()(const Eigen::VectorXd& x) const
    {
        return (x - mean_).cwiseProduct(factor_);
    }
    Eigen::MatrixXd rows(const Eigen::MatrixXd& X) const
    {
        return (X.rowwise() - mean_.transpose()).array().rowwise() * factor_.transpose().array();
    }

private:
    Eigen::VectorXd mean_, factor_;
};

class Nearest final : public Baseline {
public:
    explicit Nearest(const ModelData& model)
        : scaling_(model.features), X_(scaling_.rows(model.features)), heights_(model.heights)
    {
    }
    std::string_view name() const override { return "nearest"; }
    BandForecast forecast(const Proprioception& s) const override
    {
        const std::vector<Eigen::Index> rows = nearestRows(scaling_(features(needs(), s)));
        BandForecast result;
        for (std::size_t i = 0; i < kBins; ++i) {
            const auto column = heights_.col(static_cast<Eigen::Index>(i));
            result.height[i] = column[rows.front()];
            const Eigen::ArrayXd others = column(rows).array() - result.height[i];
            result.sd[i] = std::sqrt(others.square().sum() / static_cast<double>(rows.size() - 1));
        }
        result.sd = atLeast(result.sd);
        return result;
    }

private:
    std::vector<Eigen::Index> nearestRows(const Eigen::VectorXd& x) const
    {
        const Eigen::VectorXd distance = (X_.rowwise() - x.transpose()).rowwise().squaredNorm();
        std::vector<Eigen::Index> rows(static_cast<std::size_t>(X_.rows()));
        std::iota(rows.begin(), rows.end(), Eigen::Index{0});
        const auto wanted = rows.begin() + std::min(kNeighbours + 1, X_.rows());
        std::partial_sort(rows.begin(), wanted, rows.end(), [&](Eigen::Index a, Eigen::Index b) {
            return std::pair(distance[a], a) < std::pair(distance[b], b);
        });
        rows.erase(wanted, rows.end());
        return rows;
    }

    Scaling scaling_;
    Eigen::MatrixXd X_, heights_;
};

/// Returns at most `most` of `total` rows, evenly chosen.
std::vector<Eigen::Index> evenRows(Eigen::Index total, Eigen::Index most)
{
    const Eigen::Index count = std::min(total, most);
    std::vector<Eigen::Index> rows(static_cast<std::size_t>(count));
    Eigen::Index k = 0;
    for (Eigen::Index& row : rows) row = k++ * total / count;
    return rows;
}

class GpOnS final : public Baseline {
public:
    GpOnS(const ModelData& model, const ForEach& forEach) : scaling_(model.features)
    {
        const Eigen::MatrixXd X = scaling_.rows(model.features);
        forEach(kBins, [&](int bin) {
            gp_[static_cast<std::size_t>(bin)] = fit(X, model.heights.col(bin));
        });
    }
    std::string_view name() const override { return "gp-s"; }
    BandForecast forecast(const Proprioception& s) const override
    {
        const Eigen::VectorXd x = scaling_(features(needs(), s));
        BandForecast result;
        for (std::size_t i = 0; i < kBins; ++i) {
            const Normal height = gp_[i]->predict(x);
            result.height[i] = height.mean;
            result.sd[i] = std::sqrt(std::max(height.variance, 0.0));
        }
        result.sd = atLeast(result.sd);
        return result;
    }

private:
    static std::unique_ptr<GaussianProcess> fit(const Eigen::MatrixXd& X, const Eigen::VectorXd& h)
    {
        const double mean = h.mean();
        const Eigen::VectorXd y = h.array() - mean;
        const double sd =
            std::max(std::sqrt(y.squaredNorm() / static_cast<double>(y.size())), 1e-3);
        const auto few = evenRows(X.rows(), kSearchRows);
        TrainingOptions options;
        options.subset = static_cast<int>(kSearchRows);
        options.fullEvaluations = 40;
        const TrainedBin trained =
            maximiseLikelihood(X(few, Eigen::all), y(few), searchStart(X.cols(), sd), options);
        const auto rows = evenRows(X.rows(), kPredictRows);
        return std::make_unique<GaussianProcess>(X(rows, Eigen::all), y(rows), trained.hyper, mean);
    }

    Scaling scaling_;
    std::array<std::unique_ptr<GaussianProcess>, kBins> gp_;
};

/// Returns the rows whose heights are all known.
ModelData withoutHoles(const ModelData& model)
{
    const std::vector<int> rows = completeRows(model);
    ModelData complete;
    complete.heights = model.heights(rows, Eigen::all);
    complete.features = model.features(rows, Eigen::all);
    return complete;
}

}  // namespace

std::vector<std::unique_ptr<Baseline>> fitBaselines(const RobotModel& robot, const ModelData& model,
                                                    const ForEach& forEach)
{
    if (model.features.rows() != model.heights.rows())
        throw std::invalid_argument("fitBaselines: as many features as heights");
    if (!model.unknownBins.empty()) return fitBaselines(robot, withoutHoles(model), forEach);
    if (model.heights.rows() < kMinRows)
        throw std::invalid_argument("fitBaselines: at least 30 training rows");
    std::vector<std::unique_ptr<Baseline>> baselines;
    baselines.push_back(std::make_unique<Flat>(robot, model));
    baselines.push_back(std::make_unique<Linear>(model));
    baselines.push_back(std::make_unique<Nearest>(model));
    baselines.push_back(std::make_unique<GpOnS>(model, forEach));
    return baselines;
}

TerrainEstimate baselineEstimate(const Baseline& baseline, const RobotModel& robot,
                                 const Proprioception& s, std::uint64_t seed, int draws)
{
    const BandForecast band = baseline.forecast(s);
    TerrainEstimate estimate;
    estimate.height = estimate.mean = band.height;
    estimate.sd = band.sd;
    estimate.ceiling = bodyCeiling(robot, s.pitch, s.front, s.rear);
    for (std::size_t i = 0; i < kBins; ++i) {
        estimate.q10[i] = band.height[i] - kNormalQ90 * band.sd[i];
        estimate.q90[i] = band.height[i] + kNormalQ90 * band.sd[i];
    }
    estimate.rhat.fill(1.0);
    estimate.ess.fill(draws);
    std::mt19937_64 rng(seed);
    std::normal_distribution<double> normal;
    estimate.draws.resize(static_cast<std::size_t>(draws));
    for (Heights& h : estimate.draws)
        for (std::size_t i = 0; i < kBins; ++i) h[i] = band.height[i] + band.sd[i] * normal(rng);
    return estimate;
}

}  // namespace terratact
