#include "core/learn/model/reduced_clearances.h"

#include <algorithm>
#include <functional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "core/learn/model/clearance_training.h"

namespace terratact {

namespace {

constexpr std::size_t kKeptWhole = 800;  ///< a regime with fewer rows keeps all rows

/// Returns the model's hyperparameters with length scales between these bounds. A feature that the
/// missing ones made redundant has a length scale of hundreds, and must have an effect again.
Hyperparameters withoutNeedless(const Hyperparameters& known)
{
    constexpr double kMinLength = 0.5, kMaxTotalLength = 6.0;
    Hyperparameters hyper = known;
    hyper.lengthScale = known.lengthScale.cwiseMax(kMinLength).cwiseMin(kMaxTotalLength);
    return hyper;
}

/// Returns the rows in order: every n-th row, and all rows of a bin's regime with few rows.
std::vector<int> chosenRows(const SurfaceData& model)
{
    const std::size_t rows = model.clearance.coveredBins.size();
    const std::size_t every = std::max<std::size_t>(1, rows / std::size_t{kReducedRows});
    std::vector<bool> chosen(rows, false);
    for (std::size_t u = 0; u < rows; u += every) chosen[u] = true;
    for (int bin = 0; bin < kBins; ++bin)
        for (const bool covered : {false, true}) {
            const std::vector<int> own = rowsOf(model, bin, covered);
            if (own.size() > kKeptWhole) continue;
            for (const int u : own) chosen[static_cast<std::size_t>(u)] = true;
        }
    if (holdsSides(model))  // both sides of a scene
        for (std::size_t u = 0; u + 1 < rows; u += 2)
            chosen[u] = chosen[u + 1] = chosen[u] || chosen[u + 1];
    std::vector<int> result;
    for (std::size_t u = 0; u < rows; ++u)
        if (chosen[u]) result.push_back(static_cast<int>(u));
    return result;
}

SurfaceData thinned(const SurfaceData& model)
{
    const ClearanceData& all = model.clearance;
    const std::vector<int> rows = chosenRows(model);
    SurfaceData some;
    some.heights = model.heights(rows, Eigen::all);
    if (model.heightSd.rows() > 0) some.heightSd = model.heightSd(rows, Eigen::all);
    some.features = model.features(rows, Eigen::all);
    some.clearance.featureMean = all.featureMean;
    some.clearance.featureSd = all.featureSd;
    some.clearance.open = all.open;
    some.clearance.covered = all.covered;
    for (const int u : rows)
        some.clearance.coveredBins.push_back(all.coveredBins[static_cast<std::size_t>(u)]);
    for (const int u : rows)
        if (!model.unknownBins.empty())
            some.unknownBins.push_back(model.unknownBins[static_cast<std::size_t>(u)]);
    some.clearance.residuals = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(rows.size()), kBins);
    return some;
}

/// Returns the place of each row that thinned() keeps.
std::vector<int> chosenPlaces(const SurfaceData& model)
{
    const std::vector<int> all = placesOf(model);
    std::vector<int> places;
    for (const int u : chosenRows(model)) places.push_back(all[static_cast<std::size_t>(u)]);
    return places;
}

void requireReducible(const SurfaceData& model, AbsentFeatures missing)
{
    const std::size_t attitude = holdsSides(model) ? kFirstSideCurrent : kFrontCurrentFeature;
    for (std::size_t d = 0; d < attitude; ++d)
        if (missing[d]) throw std::invalid_argument("no estimate without pitch and flipper angles");
    if (missing.none()) throw std::invalid_argument("no feature is missing");
}

/// Forces that were not measured touch nothing, as in a scene.
void forget(Eigen::MatrixXd& features, AbsentFeatures missing)
{
    for (std::size_t d = 0; d < missing.size(); ++d)
        if (missing[d]) features.col(static_cast<Eigen::Index>(d)).setZero();
}

}  // namespace

ReducedClearances::ReducedClearances(const SurfaceData& model, RobotModel robot)
    : rows_(thinned(model)), places_(chosenPlaces(model)), robot_(std::move(robot))
{
}

std::shared_ptr<ReducedClearances::Entry> ReducedClearances::entry(AbsentFeatures missing) const
{
    const std::scoped_lock lock(mutex_);
    const auto found = std::find_if(entries_.begin(), entries_.end(), [missing](const auto& known) {
        return known->missing == missing;
    });
    if (found != entries_.end()) {
        entries_.splice(entries_.begin(), entries_, found);
    } else {
        entries_.push_front(std::make_shared<Entry>());
        entries_.front()->missing = missing;
        if (entries_.size() > kKept) entries_.pop_back();
    }
    return entries_.front();
}

std::shared_ptr<const ClearanceModel> ReducedClearances::without(AbsentFeatures missing,
                                                                 const ForEach& sideBySide,
                                                                 const Poll& poll) const
{
    requireReducible(rows_, missing);
    const std::shared_ptr<Entry> own = entry(missing);
    const PolledMutex::Lock lock(own->mutex, poll);
    if (!own->model) own->model = train(missing, sideBySide, poll);
    return own->model;
}

std::shared_ptr<const ClearanceModel>
ReducedClearances::train(AbsentFeatures missing, const ForEach& sideBySide, const Poll& poll) const
{
    SurfaceData model = rows_;
    forget(model.features, missing);
    const Eigen::MatrixXd ceilings = bodyCeilings(model.features, robot_, poll);
    std::vector<TrainedSurface> trained(2 * std::size_t{kBins});
    const std::function<void(int)> trainOne = [&](int job) {
        callPoll(poll);
        const bool covered = job < kBins;
        const int bin = job % kBins;
        const auto& known = covered ? rows_.clearance.covered : rows_.clearance.open;
        trained[static_cast<std::size_t>(job)] = refitSurface(
            model, ceilings, bin, covered,
            withoutNeedless(known[static_cast<std::size_t>(bin)].hyper), missing, poll, places_);
    };
    if (sideBySide)
        sideBySide(2 * kBins, trainOne);
    else
        for (int job = 0; job < 2 * kBins; ++job) trainOne(job);
    for (int job = 0; job < 2 * kBins; ++job)
        store(model, trained[static_cast<std::size_t>(job)], job % kBins, job < kBins);
    finishClearance(model, ceilings, robot_, poll, missing);
    return std::make_shared<const ClearanceModel>(model, missing, places_);
}

}  // namespace terratact
