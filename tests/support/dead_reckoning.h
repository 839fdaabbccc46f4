#pragma once

#include <initializer_list>
#include <utility>

#include "core/strip/dead_reckoning.h"
#include "tests/support/absolem.h"

namespace terratact {

/// Dead reckoning of Absolem over pairs of way [m] and pitch [rad]. The first pair is where it begins.
inline DeadReckoning reckoned(std::initializer_list<std::pair<double, double>> way)
{
    DeadReckoning reckoning(absolem(), way.begin()->first, way.begin()->second);
    for (const auto& [travelled, pitch] : way) reckoning.add(travelled, pitch);
    return reckoning;
}

}  // namespace terratact
