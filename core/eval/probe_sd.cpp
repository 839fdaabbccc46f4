#include "core/eval/probe_sd.h"

#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>
#include <map>
#include <string_view>
#include <vector>

namespace terratact {
namespace {

struct Place {
    double sum = 0.0;
    std::size_t n = 0;
};

SdEstimate sdEstimate(double squares, std::size_t freedom)
{
    if (freedom == 0) return {};
    const auto nu = static_cast<double>(freedom);
    const boost::math::chi_squared chi(nu);
    return {std::sqrt(squares / nu), std::sqrt(squares / boost::math::quantile(chi, 0.975)),
            std::sqrt(squares / boost::math::quantile(chi, 0.025)), freedom};
}

SdEstimate repeatability(std::span<const ProbeReading> readings,
                         std::map<std::string_view, Place>& places)
{
    for (const ProbeReading& r : readings) {
        places[r.place].sum += r.height;
        ++places[r.place].n;
    }
    double squares = 0.0;
    for (const ProbeReading& r : readings) {
        const Place& place = places[r.place];
        squares += std::pow(r.height - place.sum / static_cast<double>(place.n), 2.0);
    }
    return sdEstimate(squares, readings.size() - places.size());
}

}  // namespace

ProbeAccuracy probeAccuracy(std::span<const ProbeReading> readings)
{
    ProbeAccuracy accuracy;
    std::map<std::string_view, Place> places;
    accuracy.repeated = repeatability(readings, places);
    accuracy.readings = readings.size();
    accuracy.places = places.size();
    std::vector<double> residuals;
    for (const ProbeReading& r : readings)
        if (r.truth) residuals.push_back(*r.truth - r.height);
    accuracy.fromTruth = residualStatistics(residuals);
    return accuracy;
}

double readingSd(const ProbeAccuracy& accuracy)
{
    return accuracy.fromTruth.n > 1 ? accuracy.fromTruth.sd : accuracy.repeated.sd;
}

}  // namespace terratact
