#pragma once

#include <optional>

#include "core/sim/rest/skin_contact.h"

namespace terratact {

/// Returns how deep p lies inside a part; empty if it is outside.
template <class Part>
std::optional<Penetration> hitOf(const Part& part, Vec2 p)
{
    Penetration found;
    if (!part.penetration(p, found)) return std::nullopt;
    return found;
}

}  // namespace terratact
