#include "core/atem/contact_cue.h"

#include <algorithm>
#include <cmath>

namespace terratact {
namespace {

constexpr double kSemitonesPerElement = 3.0;

}  // namespace

std::optional<ContactTone> contactTone(const FlipperContacts& state)
{
    const std::optional<ElementContact> contact = state.strongest();
    if (!contact) return std::nullopt;
    const double force = std::clamp(contact->force, kSlowestForce, kFastestForce);
    const double share = std::log(force / kSlowestForce) / std::log(kFastestForce / kSlowestForce);
    return ContactTone{.pitch =
                           kPivotPitch * std::exp2(kSemitonesPerElement * contact->element / 12.0),
                       .period = kSlowestTick + share * (kFastestTick - kSlowestTick)};
}

std::optional<double> ContactCue::poll(const FlipperContacts& state, bool moves, double now)
{
    const std::optional<ContactTone> tone = contactTone(state);
    if (!tone) {
        last_.reset();
        pitch_.reset();
        return std::nullopt;
    }
    const double since = last_ ? now - *last_ : kSlowestTick;
    const bool isNew = !last_ || (pitch_ != tone->pitch && since >= kFastestTick);
    if (!isNew && !(moves && since >= tone->period)) return std::nullopt;
    last_ = now;
    pitch_ = tone->pitch;
    return tone->pitch;
}

}  // namespace terratact
