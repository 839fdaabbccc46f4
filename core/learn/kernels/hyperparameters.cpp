#include "core/learn/kernels/hyperparameters.h"

#include <stdexcept>
#include <string>

#include "core/learn/data/columns.h"

namespace terratact {
namespace {

std::size_t size(FeatureSet set)
{
    switch (set) {
    case FeatureSet::Pa: return 3;
    case FeatureSet::Paf: return kFeatures;
    }
    throw std::invalid_argument("no such FeatureSet");
}

}  // namespace

std::string_view name(FeatureSet set)
{
    return size(set) == kFeatures ? "paf" : "pa";
}

std::vector<std::string_view> featureNames(FeatureSet set)
{
    std::vector<std::string_view> names;
    for (const Column& column : featureColumns().first(size(set))) names.push_back(column.name);
    return names;
}

Eigen::VectorXd features(FeatureSet set, const Proprioception& s)
{
    if (const std::string_view missing = missingFeature(set, s); !missing.empty())
        throw std::invalid_argument("features: " + std::string(missing) + " is missing");
    const FeatureValues all = featureValues(s);
    Eigen::VectorXd x(static_cast<Eigen::Index>(size(set)));
    for (Eigen::Index i = 0; i < x.size(); ++i) x[i] = *all[static_cast<std::size_t>(i)];
    return x;
}

Eigen::VectorXd knownFeatures(const Proprioception& s)
{
    Eigen::VectorXd x(static_cast<Eigen::Index>(kFeatures));
    Eigen::Index d = 0;
    for (const std::optional<double>& value : featureValues(s)) x[d++] = value.value_or(0.0);
    return x;
}

std::string_view missingFeature(FeatureSet set, const Proprioception& s)
{
    const FeatureValues all = featureValues(s);
    for (std::size_t i = 0; i < size(set); ++i)
        if (!all[i]) return featureColumns()[i].name;
    return {};
}

}  // namespace terratact
