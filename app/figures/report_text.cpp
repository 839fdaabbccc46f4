#include "app/figures/report_text.h"

#include <fmt/format.h>

#include <numbers>

namespace terratact {
namespace {

double inDegrees(double radians)
{
    return radians * 180.0 / std::numbers::pi;
}

/// Returns what a verdict of one profile adds to its answer: why it is not CLEAR, or withheld.
std::string reasonsText(const Verdict& v)
{
    std::string text;
    if (v.shortfall != Shortfall::None) text.append("; ").append(describe(v.shortfall).english);
    if (!v.unfelt.empty()) text += "; " + describeUnfelt(v);
    for (const WithholdReason reason : v.withheldFor)
        text.append("; ").append(describe(reason).english);
    return text;
}

}  // namespace

std::string settingsText(const Settings& s)
{
    return fmt::format(
        "method {}, ceiling {}, contacts {}, contact above {} N, contact sd {} m, at "
        "most {} draws{}, {} chains, burn-in {}, scan {}, precision {}, inducing {}, "
        "seed {}, probe above {} m",
        name(s.method), name(s.ceiling), name(s.contacts), s.forceThreshold, s.contactSd, s.draws,
        s.stopEarly ? "" : " (all)", s.chains, s.burnIn, name(s.scan), name(s.precision),
        s.inducing, s.seed, s.probeAbove);
}

std::string readingsText(const EstimateRow& row)
{
    std::string text;
    for (const ArmReading& r : row.readings)
        text += fmt::format("{}{:+.3f} m at {:+.1f} m{} (sd {:.0f} mm)", text.empty() ? "" : ", ",
                            r.height, binCentre(r.bin),
                            r.side == ProbeSide::Middle ? "" : fmt::format(" {}", name(r.side)),
                            1000.0 * r.sd);
    return text.empty() ? "none" : text;
}

std::string stepText(const Verdict& v, double limit)
{
    return fmt::format("{}: a step ahead of more than {:.2f} m has probability {:.0f} %",
                       describeStepVerdict(v), limit, 100.0 * v.step.p)
         + reasonsText(v);
}

std::string crossSlopeText(const CrossSlope& slope)
{
    return fmt::format("{:+.1f}° (left higher) at {:+.1f} m; more than {:.1f}° to a side has "
                       "probability {:.0f} %",
                       inDegrees(slope.steepest), binCentre(slope.bin), inDegrees(slope.limit),
                       100.0 * slope.beyond.p);
}

}  // namespace terratact
