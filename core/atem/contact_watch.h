#pragma once

#include <array>
#include <optional>

#include "core/robot/two_tracks.h"

namespace terratact {

/// A force element of a flipper that touches the ground.
struct ElementContact {
    Flipper flipper = Flipper::FrontLeft;
    int element = 0;     ///< 0 (pivot) … 5 (tip)
    double force = 0.0;  ///< [N]
    bool operator==(const ElementContact&) const = default;
};

/// Contacts of all flippers in one line of telemetry.
struct FlipperContacts {
    struct Element {
        std::optional<double> force{};  ///< [N]; empty: not measured, not finite, broken, absent
        bool touches = false;
        bool operator==(const Element&) const = default;
    };
    using Elements = std::array<Element, kForceElements>;
    PerFlipper<Elements> flippers{};
    /// False if only the mean of both front flippers is known; it then stands for each of them.
    bool sidesKnown = true;
    bool operator==(const FlipperContacts&) const = default;

    bool knows(Flipper flipper) const;  ///< true if an element of the flipper is measured
    /// Returns the contact of a flipper with the largest force; empty: it does not touch the ground.
    std::optional<ElementContact> strongest(Flipper flipper) const;
    /// Returns the strongest contact of all flippers.
    std::optional<ElementContact> strongest() const;
    bool touches() const { return strongest().has_value(); }
};

/// Finds contacts along telemetry, with hysteresis. A contact of an element begins above the
/// threshold, as in reconstructContacts(). It ends below
///   max(threshold / 2, threshold − kLoadThreshold).
/// kLoadThreshold (core/infer/estimate/touch.h) is three standard deviations of an element's noise.
/// Noise therefore does not end a contact. The watch has no clock.
class ContactWatch {
public:
    /// threshold: [N]. Throws std::invalid_argument unless it is finite and ≥ 0.
    explicit ContactWatch(double threshold) { setThreshold(threshold); }
    void setThreshold(double threshold);

    /// Reads the next line of telemetry. A line later than kMaxSilence after the one before resets
    /// the hysteresis: it has no contact below the threshold.
    const FlipperContacts& add(const Measurement& line);
    const FlipperContacts& state() const { return state_; }
    void clear();  ///< there is no fresh telemetry

private:
    double begins_ = 0.0, ends_ = 0.0;  ///< [N]
    std::optional<double> time_;        ///< of the last line [s]
    FlipperContacts state_;
};

}  // namespace terratact
