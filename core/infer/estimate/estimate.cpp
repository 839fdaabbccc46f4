#include "core/infer/estimate/estimate.h"

#include "core/base/named.h"
#include <string_view>

namespace terratact {
namespace {

constexpr auto kOriginNames = namesOf<Origin>("sampled", "contact", "arm");
constexpr auto kEndingNames = namesOf<Ending>("converged", "sweeps", "time", "not sampled");

}  // namespace

std::string_view name(Origin origin)
{
    return nameIn(kOriginNames, origin);
}

std::string_view name(Ending ending)
{
    return nameIn(kEndingNames, ending);
}

}  // namespace terratact
