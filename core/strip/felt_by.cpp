#include "core/strip/felt_by.h"

#include <algorithm>
#include <cmath>

#include "core/base/named.h"
#include "core/terrain/ground_lines.h"

namespace terratact {
namespace {

constexpr auto kFeltByNames =
    namesOf<FeltBy>("arm", "contact", "track", "in part", "bounded", "not felt", "not recorded");

}  // namespace

std::string_view name(FeltBy felt)
{
    return nameIn(kFeltByNames, felt);
}

FeltBy feltBy(const TerrainEstimate& estimate, int bin)
{
    const auto i = static_cast<std::size_t>(bin);
    if (estimate.origin[i] == Origin::Arm) return FeltBy::Arm;
    switch (estimate.touch[i]) {
    case Touch::Felt: return bin >= kFirstFlipperBin ? FeltBy::Contact : FeltBy::Track;
    case Touch::FeltInPart: return FeltBy::InPart;
    case Touch::Remembered:  // the strip holds what the earlier estimate said
        return std::isfinite(estimate.ceiling[i]) ? FeltBy::Bounded : FeltBy::NotFelt;
    case Touch::Bounded: return FeltBy::Bounded;
    case Touch::NotFelt: return FeltBy::NotFelt;
    case Touch::Unrecorded: break;
    }
    return FeltBy::Unrecorded;
}

FeltBy across(FeltBy a, FeltBy b)
{
    if (a == FeltBy::Unrecorded || b == FeltBy::Unrecorded) return FeltBy::Unrecorded;
    return isFelt(a) == isFelt(b) ? std::max(a, b) : FeltBy::InPart;
}

}  // namespace terratact
