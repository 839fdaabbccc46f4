#include "core/atem/contact_watch.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/infer/estimate/touch.h"

namespace terratact {
namespace {

constexpr std::array kEachFlipper{Flipper::FrontLeft, Flipper::FrontRight, Flipper::RearLeft,
                                  Flipper::RearRight};

/// Returns the mean forces of both front flippers.
std::array<std::optional<double>, kForceElements> meanForces(const Measurement& line)
{
    return proprioception(line).force;
}

/// Returns true if the line follows the time [s] closely.
bool follows(const Measurement& line, const std::optional<double>& time)
{
    return time && line.time >= *time && line.time - *time <= kMaxSilence;
}

}  // namespace

bool FlipperContacts::knows(Flipper flipper) const
{
    const Elements& elements = flippers[indexOf(flipper)];
    return std::any_of(elements.begin(), elements.end(),
                       [](const Element& e) { return e.force.has_value(); });
}

std::optional<ElementContact> FlipperContacts::strongest(Flipper flipper) const
{
    std::optional<ElementContact> found;
    const Elements& elements = flippers[indexOf(flipper)];
    for (int e = 0; e < kForceElements; ++e) {
        const Element& element = elements[static_cast<std::size_t>(e)];
        if (element.touches && (!found || *element.force > found->force))
            found = ElementContact{flipper, e, *element.force};
    }
    return found;
}

std::optional<ElementContact> FlipperContacts::strongest() const
{
    std::optional<ElementContact> found;
    for (const Flipper flipper : kEachFlipper)
        if (const auto contact = strongest(flipper);
            contact && (!found || contact->force > found->force))
            found = contact;
    return found;
}

void ContactWatch::setThreshold(double threshold)
{
    if (!(threshold >= 0.0) || !std::isfinite(threshold))
        throw std::invalid_argument("the force threshold must be finite, and 0 N or more");
    begins_ = threshold;
    ends_ = std::max(threshold / 2.0, threshold - kLoadThreshold);
}

const FlipperContacts& ContactWatch::add(const Measurement& line)
{
    const bool continues = follows(line, time_);
    time_ = line.time;
    auto forces = twoTrackReadings(line).forces;
    const auto knows = [](const auto& elements) {
        return std::any_of(elements.begin(), elements.end(), [](const auto& f) { return !!f; });
    };
    state_.sidesKnown = knows(forces[0]) || knows(forces[1]);
    if (!state_.sidesKnown) forces[0] = forces[1] = meanForces(line);
    for (std::size_t f = 0; f < kFlippers; ++f)
        for (std::size_t e = 0; e < forces[f].size(); ++e) {
            FlipperContacts::Element& element = state_.flippers[f][e];
            const bool holds = continues && element.touches;
            element.force.reset();
            if (forces[f][e] && std::isfinite(*forces[f][e])) element.force = forces[f][e];
            element.touches = element.force && *element.force > (holds ? ends_ : begins_);
        }
    return state_;
}

void ContactWatch::clear()
{
    time_.reset();
    state_ = {};
}

}  // namespace terratact
