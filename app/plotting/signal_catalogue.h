#pragma once

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "app/link/dbc_book.h"
#include "app/plotting/plot_signal.h"
#include "core/wire/can_frame.h"

namespace terratact {

/// The signals that can be plotted. Those of telemetry, bus and estimate are always listed, those of other devices'
/// frames once such a frame was received.
class SignalCatalogue {
public:
    static constexpr std::size_t kMaxDescribed = 256;  ///< bound on described kinds of frames

    /// Uses these DBC descriptions; null: none. Frames must come again.
    void describe(std::shared_ptr<const DbcBook> book);
    /// Adds the signals of a frame outside the protocol. Returns true if they are new.
    bool add(const CanFrame& frame);

    std::vector<PlotSignal> all() const;
    /// Returns the default set: pitch, roll and the flippers' forces.
    static std::vector<std::vector<std::string>> usualRows();

private:
    std::shared_ptr<const DbcBook> book_;
    std::map<std::pair<bool, std::uint32_t>, std::vector<PlotSignal>>
        payload_;  // empty: not described
    std::size_t described_ = 0;
};

/// Key of the load: frames per second on the bus.
std::string frameRateKey();

}  // namespace terratact
