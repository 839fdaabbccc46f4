#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "app/link/dbc_book.h"
#include "app/plotting/plot_signal.h"
#include "core/wire/can_frame.h"
#include "core/wire/frame_layout.h"
#include "core/wire/frame_validator.h"

namespace terratact {

/// Returns the signals of the robot's protocol: "Attitude.Pitch", in SI units.
std::vector<PlotSignal> protocolSignals();

/// Returns the signals of a frame of another device; empty if no file describes it. Their ids hold the frame's
/// identifier, because files may describe equal devices at different ones: "123 GasSensor.Oxygen".
std::vector<PlotSignal> payloadSignals(const CanFrame& frame, const DescribedFrame& described);

/// Decodes chosen signals of judged frames.
class FrameSignals {
public:
    /// Value of a chosen signal; `signal`: index of its key in choose().
    struct Value {
        std::size_t signal = 0;
        double value = 0.0;
    };

    /// Decodes the signals of these keys from now on; keys of other origins are ignored.
    void choose(const std::vector<std::string>& keys);
    /// Uses these DBC descriptions from now on; null: none.
    void describe(std::shared_ptr<const DbcBook> book);
    bool isIdle() const { return chosen_.empty(); }  ///< no signal of a frame is chosen

    /// Appends the chosen values of a frame to `values`. A frame that failed its checks has none.
    void decode(const CanFrame& frame, const JudgedFrame& judged, std::vector<Value>& values);

private:
    struct Wanted {
        std::size_t place = 0;   ///< of the signal in its frame
        std::size_t signal = 0;  ///< index of its key
    };
    struct Described {
        std::shared_ptr<const DescribedFrame> frame;
        std::vector<Wanted> wanted;  ///< empty: no signal of the frame is chosen
    };
    const Described& describedBy(const CanFrame& frame);

    std::unordered_map<std::string, std::size_t> chosen_;  // key to index
    std::vector<std::vector<Wanted>> known_ = std::vector<std::vector<Wanted>>(kFrameKinds);
    std::shared_ptr<const DbcBook> book_;
    std::unordered_map<std::uint64_t, Described> foreign_;  // by frame, at most kMaxForeign
    std::vector<std::optional<std::uint64_t>> bits_;        // of one frame
    static constexpr std::size_t kMaxForeign = 1024;
};

}  // namespace terratact
