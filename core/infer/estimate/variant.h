#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "core/learn/kernels/precision.h"

namespace terratact {

/// The paper's four methods (section 5) and four methods over clearances. The latter estimate
/// under the robot how far the ground lies below the body (core/learn/model/clearance.h).
///   Pa        pitch and flipper angles
///   Pac       Pa, samples constrained by the robot's body
///   Pafc      Pac with flipper forces and currents; contact bins are fixed
///   Pafac     Pafc, and the arm measures the most uncertain bin
///   Clearance Gibbs sampling like Pafc; the state of a bin under the robot is its log clearance
///   Joint     closed form: one Gaussian process per bin on s, one Gaussian for the errors of all bins
///   Local     closed form: Joint with the errors of the most similar training scenes
///   Trail     closed form: networks on s and on the way before the scene (core/trail/trail_model.h);
///             Local for a scene without a history
enum class Method : std::uint8_t { Pa, Pac, Pafc, Pafac, Clearance, Joint, Local, Trail };

inline constexpr std::array kMethods{Method::Pa,    Method::Pac,       Method::Pafc,
                                     Method::Pafac, Method::Clearance, Method::Joint,
                                     Method::Local, Method::Trail};
/// Methods that need one scene alone.
inline constexpr std::array kSceneMethods{Method::Pa,    Method::Pac,       Method::Pafc,
                                          Method::Pafac, Method::Clearance, Method::Joint,
                                          Method::Local};

/// Treatment of a sample above the body's ceiling.
///   Truncate  drawn from the Gaussian cut off above the ceiling (section 4.3)
///   Clamp     drawn freely, then set to the ceiling (section 5): a point mass on the ceiling
///   None      drawn freely
enum class CeilingRule : std::uint8_t { Truncate, Clamp, None };

/// Force elements that fix a bin.
///   Isolated  exactly one element, or one group of neighbours, above the threshold (section 4.2)
///   Any       every element above the threshold (section 5)
///   None none; forces act through s alone
enum class ContactRule : std::uint8_t { Isolated, Any, None };

/// Order in which a sweep draws the unknown bins.
///   Forward  rear to front
///   Reverse  front to rear
///   Random   a new random order every sweep, the same for all chains
enum class ScanOrder : std::uint8_t { Forward, Reverse, Random };

constexpr bool usesForces(Method m)
{
    return m != Method::Pa && m != Method::Pac;
}
/// Returns true for the paper's four methods.
constexpr bool isOfPaper(Method m)
{
    return m == Method::Pa || m == Method::Pac || m == Method::Pafc || m == Method::Pafac;
}
/// Returns true for a method that samples heights and cuts them off at the ceiling.
constexpr bool usesCeiling(Method m)
{
    return m == Method::Pac || m == Method::Pafc || m == Method::Pafac;
}
/// Returns true for a method without Markov chains (core/infer/closed_form.h).
constexpr bool isClosedForm(Method m)
{
    return m == Method::Joint || m == Method::Local || m == Method::Trail;
}
/// Returns true for a method that includes a probe by the arm.
constexpr bool usesArm(Method m)
{
    return m == Method::Pafac;
}

/// Return the names of command line and files: "pa", "local", "truncate", "isolated", "forward",
/// "single", …
std::string_view name(Method method);
std::string_view name(CeilingRule rule);
std::string_view name(ContactRule rule);
std::string_view name(ScanOrder scan);
std::string_view name(Precision precision);
std::optional<Method> methodFromName(std::string_view text);
/// Returns the same for kSceneMethods alone.
std::optional<Method> sceneMethodFromName(std::string_view text);
std::optional<CeilingRule> ceilingRuleFromName(std::string_view text);
std::optional<ContactRule> contactRuleFromName(std::string_view text);
std::optional<ScanOrder> scanOrderFromName(std::string_view text);
std::optional<Precision> precisionFromName(std::string_view text);

}  // namespace terratact
