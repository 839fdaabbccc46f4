#pragma once

#include <array>
#include <optional>

#include "core/robot/measurement.h"
#include "core/robot/robot_model.h"

namespace terratact {

/// Noise of a force element: the sd of a force f is √((kForceSdShare f)² + kForceSdFloor²) [N]. It is the noise of
/// core/sim/sensor_noise.h.
inline constexpr double kForceSdShare = 0.10;
inline constexpr double kForceSdFloor = 0.3;

/// An element that reads so many sd less than the others predict does not rest on even ground. Element 1 also
/// carries the stretch between the pivot and itself, where no element is: a gap there shows in it alone.
inline constexpr double kFirstElementSd = 0.85;
inline constexpr double kOtherElementSd = 3.0;

/// A saturated element 1 shows nothing where the others predict more than this multiple of saturation.
inline constexpr double kMaxSaturation = 2.0;

/// The pressure along the lower edge of the front flippers, as far as six elements tell it.
/// A flipper is stiff, and its skin is equally soft along the edge. On even ground the pressure is therefore linear:
///   p(u) = a + b u,   u = 0 at the pivot end of the edge, 1 at the tip.
/// An element takes the load of the edge as a beam on supports shares it: element e feels ∫ w_e(u) p(u) du, and w_e falls
/// from 1 at its own share to 0 at its neighbours'. Elements 1 and 6 take all that lies beyond them. a and b are the
/// weighted least squares of the loaded elements below saturation.
class EdgePressure {
public:
    using Loads = std::array<std::optional<double>, kForceElements>;  ///< [N]

    /// loaded: the elements that carry load. An element without a force is never part of the fit.
    EdgePressure(const RobotModel& robot, const Loads& force,
                 const std::array<bool, kForceElements>& loaded);

    /// Whether the loads can be those of even ground: three or more are fitted, and their χ² stays below the value
    /// that even ground exceeds in 2 of 100 cases. A saturated element adds to χ² where the fit predicts less.
    bool isEven() const { return even_; }

    /// Whether the element carries what a fit to the other loaded elements predicts, within the noise of both
    /// (kFirstElementSd, kOtherElementSd). A prediction above saturation counts as saturation, for element 1 up to
    /// kMaxSaturation.
    /// true without a force; false where fewer than two others are loaded.
    bool hasItsShare(std::size_t element) const;

    /// p(u) [N]: the load of the whole edge if it were p(u) everywhere. 0 where fewer than two are fitted.
    double at(double u) const { return a_ + b_ * u; }

private:
    struct Fit {
        double a = 0.0, b = 0.0;
        double varA = 0.0, varB = 0.0, covariance = 0.0;
        int count = 0;
    };
    static constexpr std::size_t kNone = kForceElements;

    Fit fitWithout(std::size_t element) const;
    double predicted(const Fit& fit, std::size_t element) const;
    bool agrees(const Fit& fit) const;
    bool isFitted(std::size_t element) const;

    Loads force_;
    std::array<bool, kForceElements> loaded_;
    std::array<double, kForceElements> constant_{}, linear_{};  ///< ∫ w_e du, ∫ w_e u du
    double saturation_;
    double a_ = 0.0, b_ = 0.0;
    bool even_ = false;
};

}  // namespace terratact
