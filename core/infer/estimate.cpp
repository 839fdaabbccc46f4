#include "core/infer/estimate.h"

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

}  // namespace terratact
