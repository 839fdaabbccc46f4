#pragma once

#include <QString>
#include <optional>
#include <vector>

namespace terratact {

/// One signal as the operator reads it.
struct SignalRow {
    enum class Standing {
        Fresh,
        /// An older value of a frame that is sent on occasion: grey, still readable.
        Said,
        Stale,  ///< too old: reads "--"
    };
    QString frame;  ///< "022 Attitude"; empty: same frame as the row above
    QString name, value, unit;
    Standing standing = Standing::Stale;
    std::optional<double> rate;  ///< [Hz] rate of the frame
    std::optional<double> age;   ///< [s]
    QString least, most;
    std::vector<float> history;     ///< newest last; NaN: a gap
    QString meaning, frameMeaning;  ///< plain text for the tip; empty: unknown
    bool operator==(const SignalRow&) const = default;
};

}  // namespace terratact
