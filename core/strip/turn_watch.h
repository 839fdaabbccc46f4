#pragma once

#include <deque>

namespace terratact {

/// Notices turns that are too tight for one strip of ground: the heading changes by more than `turn` [rad] within
/// `way` [m]. Headings are kept every `way` / 30, so the memory is bounded.
class TurnWatch {
public:
    TurnWatch(double turn, double way) : turn_(turn), way_(way) {}

    /// way: rolled since the start [m], never decreasing. heading: not wrapped [rad]. Returns true once the
    /// turn is too tight; it then forgets the headings before.
    bool add(double way, double heading);

private:
    struct Stretch {
        double begin = 0.0;                  ///< [m]
        double lowest = 0.0, highest = 0.0;  ///< [rad]
    };
    double turn_, way_;
    std::deque<Stretch> recent_;
};

}  // namespace terratact
