#include "core/infer/estimate/provenance.h"
#include "core/base/named.h"

namespace terratact {
namespace {

constexpr auto kProvenanceNames =
    namesOf<Provenance>("arm", "contact", "constrained", "sampled", "prior only");

}  // namespace

Provenance provenance(const TerrainEstimate& estimate, int bin)
{
    const auto i = static_cast<std::size_t>(bin);
    switch (estimate.origin[i]) {
    case Origin::Contact: return Provenance::Contact;
    case Origin::Arm: return Provenance::Arm;
    case Origin::Sampled: break;
    }
    if (estimate.priorOnly(bin)) return Provenance::PriorOnly;
    return estimate.ceiling[i] - estimate.q90[i] < kTouching ? Provenance::Constrained
                                                             : Provenance::Sampled;
}

std::string_view name(Provenance provenance)
{
    return nameIn(kProvenanceNames, provenance);
}

BarPattern barPattern(Provenance provenance)
{
    constexpr double kThin = 2.0, kWide = 5.0;  // [px]
    switch (provenance) {
    case Provenance::Arm: return {kWide};
    case Provenance::Contact: return {kThin};
    case Provenance::Constrained: return {kThin, {3.0, 1.5, 1.0, 1.5}};
    case Provenance::Sampled: return {kThin, {6.0, 2.0}};
    case Provenance::PriorOnly: return {kThin, {1.0, 1.0}};
    }
    return {};
}

MarkFill markFill(const TerrainEstimate& estimate, int bin)
{
    if (provenance(estimate, bin) == Provenance::PriorOnly) return MarkFill::Open;
    switch (estimate.touch[static_cast<std::size_t>(bin)]) {
    case Touch::FeltInPart: return MarkFill::LowerHalf;
    case Touch::Bounded:
    case Touch::NotFelt: return MarkFill::Open;
    case Touch::Felt:
    case Touch::Remembered:
    case Touch::Unrecorded: break;
    }
    return MarkFill::Full;
}

}  // namespace terratact
