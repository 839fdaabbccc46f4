#pragma once

#include <array>
#include <optional>

#include "core/robot/measurement.h"
#include "core/robot/robot_model.h"

namespace terratact {

/// Noise of a force element: a force f has an sd of √((kForceSdShare f)² + kForceSdFloor²) [N].
/// core/sim/sensor_noise.h simulates the same noise.
inline constexpr double kForceSdShare = 0.10;
inline constexpr double kForceSdFloor = 0.3;

/// An element that reads this many sd less than the others predict does not rest on even ground.
/// Element 1 also carries the stretch between the pivot and itself. A gap in that stretch shows in
/// element 1 alone. A fall behind the last bin that the flippers cover takes load from element 6
/// alone.
inline constexpr double kFirstElementSd = 0.85;
inline constexpr double kFirstElementOnSoftSd = 0.0;  ///< where the tip sinks in
inline constexpr double kLastElementSd = 1.5;
inline constexpr double kOtherElementSd = 3.0;

/// The tip sinks in where element 6 reads this many sd more than the others predict.
inline constexpr double kTipSinksSd = 1.0;

/// A saturated element 1 is ignored where the others predict more than this multiple of saturation.
inline constexpr double kMaxSaturation = 2.0;

/// Pressure along the lower edge of the front flippers, fitted to six force elements. A flipper is
/// stiff, and its skin is equally soft along the edge. On even ground the pressure is therefore
/// linear:
///   p(u) = a + b u,   u = 0 at the pivot end of the edge, 1 at the tip.
/// The elements share the load like the supports of a beam: element e reads ∫ w_e(u) p(u) du. w_e
/// is 1 at its own place and falls linearly to 0 at its neighbours' places. Elements 1 and 6 carry
/// all load beyond them. a and b are the weighted least squares over the loaded elements below
/// saturation. On soft ground the tip's circle sinks in, too, and adds to element 6. An element 6
/// that exceeds the others' prediction by kTipSinksSd is therefore not part of the fit.
class EdgePressure {
public:
    using Loads = std::array<std::optional<double>, kForceElements>;  ///< [N]

    /// loaded: true for each element that carries load. An element without a force is never part of
    /// the fit.
    EdgePressure(const RobotModel& robot, const Loads& force,
                 const std::array<bool, kForceElements>& loaded);

    /// Returns true if the loads can come from even ground. Three or more elements must be fitted.
    /// Their χ² must stay below the value that even ground exceeds in 2 of 100 cases. A saturated
    /// element adds to χ² where the fit predicts less.
    bool isEven() const { return even_; }

    /// Returns true if the element carries what a fit to the other loaded elements predicts. The
    /// tolerance is the noise of both, times the constants above. A prediction above saturation
    /// counts as saturation, for element 1 up to kMaxSaturation. Returns true for an element
    /// without a force, and for element 6 where the tip sinks in. Returns false where fewer than
    /// two others are loaded.
    bool hasItsShare(std::size_t element) const;

    /// Returns p(u) [N], the load of the whole edge if the pressure were p(u) everywhere. 0 if
    /// fewer than two elements are fitted.
    double at(double u) const { return a_ + b_ * u; }

private:
    struct Fit {
        double a = 0.0, b = 0.0;
        double varA = 0.0, varB = 0.0, covariance = 0.0;
        int count = 0;
    };
    static constexpr std::size_t kNone = kForceElements;
    static constexpr std::size_t kTip = kForceElements - 1;

    Fit fitWithout(std::size_t element) const;
    bool tipExceeds(const Fit& others) const;
    double predicted(const Fit& fit, std::size_t element) const;
    double sdOf(const Fit& fit, std::size_t element, double expected) const;
    double allowedSd(std::size_t element) const;
    bool agrees(const Fit& fit) const;
    bool isFitted(std::size_t element) const;

    Loads force_;
    std::array<bool, kForceElements> loaded_;
    std::array<double, kForceElements> constant_{}, linear_{};  ///< ∫ w_e du, ∫ w_e u du
    double saturation_;
    double a_ = 0.0, b_ = 0.0;
    bool tipSinks_ = false;
    bool even_ = false;
};

}  // namespace terratact
