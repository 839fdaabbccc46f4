#include "core/infer/estimate/estimate.h"

#include <stdexcept>
#include <string_view>

namespace terratact {

std::string_view name(Origin origin)
{
    switch (origin) {
    case Origin::Sampled: return "sampled";
    case Origin::Contact: return "contact";
    case Origin::Arm: return "arm";
    }
    throw std::invalid_argument("name: no such Origin");
}

std::string_view name(Ending ending)
{
    switch (ending) {
    case Ending::Converged: return "converged";
    case Ending::Sweeps: return "sweeps";
    case Ending::Time: return "time";
    case Ending::NotSampled: return "not sampled";
    }
    throw std::invalid_argument("name: no such Ending");
}

}  // namespace terratact
