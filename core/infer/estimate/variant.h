#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "core/learn/kernels/precision.h"

namespace terratact {

/// The paper's four methods (domain: section 5 of the paper), and three over clearances: under the robot
/// they estimate how far below the body the ground lies, see core/learn/model/clearance.h.
///   Pa        pitch + flipper angles
///   Pac       the same, samples constrained by the robot's body
///   Pafc      + flipper forces (and currents), contact bins fixed, constrained
///   Pafac     Pafc + the arm measures the most uncertain bin
///   Clearance Gibbs sampling like Pafc, the state of a bin under the robot is its log clearance
///   Joint     closed form: one Gaussian process per bin on s, and one Gaussian for the errors of all bins
///   Local     closed form: the same, the errors are those of the training scenes most like this one
enum class Method : std::uint8_t { Pa, Pac, Pafc, Pafac, Clearance, Joint, Local };

inline constexpr std::array kMethods{Method::Pa,        Method::Pac,   Method::Pafc, Method::Pafac,
                                     Method::Clearance, Method::Joint, Method::Local};
inline constexpr std::array kPaperMethods{Method::Pa, Method::Pac, Method::Pafc, Method::Pafac};

/// How a sample above the body's ceiling is treated.
///   Truncate  drawn from the Gaussian cut off above the ceiling (section 4.3)
///   Clamp     drawn freely, then set to the ceiling (section 5): a point mass on the ceiling
///   None      drawn freely
enum class CeilingRule : std::uint8_t { Truncate, Clamp, None };

/// Which force elements fix a bin.
///   Isolated  exactly one element, or one group of neighbours, above the threshold (section 4.2)
///   Any       every element above the threshold (section 5)
///   None      none: forces speak through s alone
enum class ContactRule : std::uint8_t { Isolated, Any, None };

/// In which order a sweep draws the unknown bins.
///   Forward  rear to front
///   Reverse  front to rear
///   Random   a new random order every sweep, the same for all chains
enum class ScanOrder : std::uint8_t { Forward, Reverse, Random };

constexpr bool usesForces(Method m)
{
    return m != Method::Pa && m != Method::Pac;
}
/// One of the paper's four.
constexpr bool isOfPaper(Method m)
{
    return m == Method::Pa || m == Method::Pac || m == Method::Pafc || m == Method::Pafac;
}
/// Samples heights and cuts them off at the ceiling.
constexpr bool usesCeiling(Method m)
{
    return m == Method::Pac || m == Method::Pafc || m == Method::Pafac;
}
/// Needs no chain: see core/infer/closed_form.h.
constexpr bool isClosedForm(Method m)
{
    return m == Method::Joint || m == Method::Local;
}
/// A probe is part of the method.
constexpr bool usesArm(Method m)
{
    return m == Method::Pafac;
}

/// The names used on the command line and in files: "pa", "local", "truncate", "isolated", "forward", "single", …
std::string_view name(Method method);
std::string_view name(CeilingRule rule);
std::string_view name(ContactRule rule);
std::string_view name(ScanOrder scan);
std::string_view name(Precision precision);
std::optional<Method> methodFromName(std::string_view text);
std::optional<CeilingRule> ceilingRuleFromName(std::string_view text);
std::optional<ContactRule> contactRuleFromName(std::string_view text);
std::optional<ScanOrder> scanOrderFromName(std::string_view text);
std::optional<Precision> precisionFromName(std::string_view text);

}  // namespace terratact
