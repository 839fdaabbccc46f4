#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "core/base/result.h"
#include "core/wire/can_frame.h"

namespace terratact {

/// A frame and how it arrived.
struct BusFrame {
    CanFrame frame;
    /// Steady clock [s]: when the kernel received it, or when a replay was due to deliver it.
    double time = 0.0;
    double wallTime = 0.0;  ///< kernel's stamp in [s] since 1970: for logs, never for deadlines
    bool echo = false;      ///< sent by this bus object: it has left
    bool local = false;     ///< sent by a process of this computer, as an echo is too
};

enum class BusState : std::uint8_t {
    Up,
    Stalled,       ///< sent frames do not leave: no node acknowledges, or the bus is full
    ErrorWarning,  ///< works, with errors
    ErrorPassive,  ///< works, with many errors
    BusOff,        ///< the controller has switched itself off
    Down,          ///< the interface exists but is down
    Absent,        ///< the interface does not exist, or no longer
    Ended,         ///< all frames of a recording were delivered
};

inline constexpr std::array kBusStates{
    BusState::Up,     BusState::Stalled, BusState::ErrorWarning, BusState::ErrorPassive,
    BusState::BusOff, BusState::Down,    BusState::Absent,       BusState::Ended};

/// Name of the bus between this program and its own simulated robot; describe() translates it.
inline constexpr const char* kInternalBus = "internal bus";

/// Returns the command that repairs the state; empty if there is none.
std::string cureOf(BusState state, const std::string& bus);

/// Returns one sentence for people: the bus, the fault, and the command that repairs it.
Message describe(BusState state, const std::string& bus);

/// Counters since the bus was opened.
struct BusCounters {
    std::uint64_t received = 0;  ///< delivered frames, with echoes and error frames
    std::uint64_t dropped = 0;   ///< frames that the kernel had no room for; never delivered
    std::uint64_t errorFrames = 0;
    std::uint64_t forgedErrors = 0;  ///< error frames that a process of this computer sent
    std::uint64_t malformed = 0;     ///< data that was no frame and was not delivered
    std::uint64_t sent = 0;          ///< frames passed to the kernel
    std::uint64_t confirmed = 0;     ///< sent frames whose echo was seen
    std::uint64_t notSent = 0;       ///< frames that send() refused
    std::uint64_t reopened = 0;      ///< number of times that the interface was found again
};

/// Throws std::invalid_argument unless the frame is a classic data or remote frame.
void requireSendable(const CanFrame& frame);

/// Moves frames without knowing their meaning. One thread calls receive(); any thread may call the
/// rest.
class CanBus {
public:
    virtual ~CanBus() = default;

    virtual std::string name() const = 0;  ///< "can0"

    /// Fills `frames` from its beginning and returns the number; waits at most `patience` for the
    /// first. A bus that is down or absent is a state() and no Error: it waits and looks for it
    /// again. Echoes and error frames are delivered too. The bus learns of them only here, so it
    /// must be called all the time. Throws std::invalid_argument if there is no room for one frame.
    virtual Result<std::size_t> receive(std::span<BusFrame> frames,
                                        std::chrono::milliseconds patience) = 0;

    /// Passes one frame to the kernel, or returns why not. It never waits and never retries. Throws
    /// std::invalid_argument unless the frame is a classic data or remote frame.
    virtual Status send(const CanFrame& frame) = 0;

    virtual BusState state() const = 0;
    virtual BusCounters counters() const = 0;
};

}  // namespace terratact
