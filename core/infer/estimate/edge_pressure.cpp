#include "core/infer/estimate/edge_pressure.h"

#include <algorithm>
#include <cmath>

namespace terratact {
namespace {

/// χ² that 2 of 100 cases exceed, for 1, 2, 3 and 4 degrees of freedom.
constexpr std::array kChiSquared{5.412, 7.824, 9.837, 11.668};

double variance(double force)
{
    const double share = kForceSdShare * std::max(force, 0.0);
    return share * share + kForceSdFloor * kForceSdFloor;
}

/// ∫ w du and ∫ w u du of a weight that is linear in u.
struct Moments {
    double constant = 0.0, linear = 0.0;
    void add(double begin, double end, double weightAtBegin, double weightAtEnd)
    {
        const double length = end - begin;
        constant += 0.5 * length * (weightAtBegin + weightAtEnd);
        linear += length
                * ((begin * weightAtBegin + end * weightAtEnd) / 3.0
                   + (begin * weightAtEnd + end * weightAtBegin) / 6.0);
    }
};

Moments momentsOf(const std::array<double, kForceElements>& share, std::size_t e)
{
    Moments moments;
    if (e == 0)
        moments.add(0.0, share[e], 1.0, 1.0);
    else
        moments.add(share[e - 1], share[e], 0.0, 1.0);
    if (e + 1 == share.size())
        moments.add(share[e], 1.0, 1.0, 1.0);
    else
        moments.add(share[e], share[e + 1], 1.0, 0.0);
    return moments;
}

}  // namespace

EdgePressure::EdgePressure(const RobotModel& robot, const Loads& force,
                           const std::array<bool, kForceElements>& loaded)
    : force_(force), loaded_(loaded), saturation_(robot.forceSaturation)
{
    for (std::size_t e = 0; e < force_.size(); ++e) {
        const Moments moments = momentsOf(robot.elementShare, e);
        constant_[e] = moments.constant;
        linear_[e] = moments.linear;
    }
    tipSinks_ = tipExceeds(fitWithout(kTip));
    const Fit all = fitWithout(kNone);
    a_ = all.a;
    b_ = all.b;
    even_ = all.count >= 3 && agrees(all);
}

/// Returns true if element 6 exceeds what a fit to the other elements predicts.
bool EdgePressure::tipExceeds(const Fit& others) const
{
    if (others.count < 2 || !loaded_[kTip] || !force_[kTip]) return false;
    const double expected = predicted(others, kTip);
    return *force_[kTip] > expected + kTipSinksSd * sdOf(others, kTip, expected);
}

bool EdgePressure::isFitted(std::size_t element) const
{
    if (element == kTip && tipSinks_) return false;
    return loaded_[element] && force_[element] && *force_[element] < saturation_;
}

EdgePressure::Fit EdgePressure::fitWithout(std::size_t element) const
{
    Fit fit;
    double cc = 0.0, cl = 0.0, ll = 0.0, cf = 0.0, lf = 0.0;
    for (std::size_t e = 0; e < force_.size(); ++e) {
        if (e == element || !isFitted(e)) continue;
        const double weight = 1.0 / variance(*force_[e]);
        cc += weight * constant_[e] * constant_[e];
        cl += weight * constant_[e] * linear_[e];
        ll += weight * linear_[e] * linear_[e];
        cf += weight * constant_[e] * *force_[e];
        lf += weight * linear_[e] * *force_[e];
        ++fit.count;
    }
    const double determinant = cc * ll - cl * cl;
    if (fit.count < 2 || !(determinant > 0.0)) return {};
    fit.a = (ll * cf - cl * lf) / determinant;
    fit.b = (cc * lf - cl * cf) / determinant;
    fit.varA = ll / determinant;
    fit.varB = cc / determinant;
    fit.covariance = -cl / determinant;
    return fit;
}

double EdgePressure::predicted(const Fit& fit, std::size_t element) const
{
    return constant_[element] * fit.a + linear_[element] * fit.b;
}

/// Returns the sd of an element's force about `expected`: its own noise and that of the fit.
double EdgePressure::sdOf(const Fit& fit, std::size_t element, double expected) const
{
    const double c = constant_[element], l = linear_[element];
    const double ofFit = c * c * fit.varA + 2.0 * c * l * fit.covariance + l * l * fit.varB;
    return std::sqrt(ofFit + variance(expected));
}

double EdgePressure::allowedSd(std::size_t element) const
{
    if (element == 0) return tipSinks_ ? kFirstElementOnSoftSd : kFirstElementSd;
    return element == kTip ? kLastElementSd : kOtherElementSd;
}

bool EdgePressure::agrees(const Fit& fit) const
{
    double chiSquared = 0.0;
    for (std::size_t e = 0; e < force_.size(); ++e) {
        const double expected = predicted(fit, e);
        const bool saturated = loaded_[e] && force_[e] && *force_[e] >= saturation_;
        const bool above = saturated && expected < *force_[e] && !(e == kTip && tipSinks_);
        if (!isFitted(e) && !above) continue;
        chiSquared += (*force_[e] - expected) * (*force_[e] - expected) / variance(expected);
    }
    return chiSquared < kChiSquared[static_cast<std::size_t>(fit.count - 3)];
}

bool EdgePressure::hasItsShare(std::size_t element) const
{
    if (!force_[element] || (element == kTip && tipSinks_)) return true;
    const Fit others = fitWithout(element);
    if (others.count < 2) return false;
    const double whole = predicted(others, element);
    if (element == 0 && whole > kMaxSaturation * saturation_) return false;
    const double expected = std::min(whole, saturation_);
    const double sd = sdOf(others, element, expected);
    return *force_[element] >= expected - allowedSd(element) * sd;
}

}  // namespace terratact
