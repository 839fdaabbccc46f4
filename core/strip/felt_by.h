#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "core/infer/estimate/estimate.h"

namespace terratact {

/// Evidence for a height along the way, the strongest first.
enum class FeltBy : std::uint8_t {
    Arm,         ///< the arm touched it
    Contact,     ///< the front flippers' force elements pressed on all of it
    Track,       ///< the tracks pressed on it
    InPart,      ///< the robot pressed on one stretch of it
    Bounded,     ///< the robot was above it and did not press
    NotFelt,     ///< no part of the robot covered all of it
    Unrecorded,  ///< the recording is older than this field
};
inline constexpr std::array kFeltBy{FeltBy::Arm,       FeltBy::Contact, FeltBy::Track,
                                    FeltBy::InPart,    FeltBy::Bounded, FeltBy::NotFelt,
                                    FeltBy::Unrecorded};

/// Returns "arm", "contact", "track", "in part", "bounded", "not felt" or "not recorded".
std::string_view name(FeltBy felt);

/// Returns true if the arm, a flipper or a track touched all of it.
constexpr bool isFelt(FeltBy felt)
{
    return felt <= FeltBy::Track;
}

/// Returns how an estimate's bin was felt (core/infer/estimate/touch.h). bin: 0 … 10.
FeltBy feltBy(const TerrainEstimate& estimate, int bin);

/// Returns how a stretch was felt that lies in two bins: InPart if one alone was felt, else the weaker.
FeltBy across(FeltBy a, FeltBy b);

}  // namespace terratact
