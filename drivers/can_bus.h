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

/// A frame and how it came here.
struct BusFrame {
    CanFrame frame;
    double time =
        0.0;  ///< [s] steady clock; when the kernel received it, or a replay was due to bring it
    double wallTime = 0.0;  ///< [s] since 1970, the kernel's stamp: for logs, never for deadlines
    bool echo = false;      ///< sent by this very bus object: it has left
    bool local = false;     ///< sent by a process of this computer (an echo is, too)
};

enum class BusState : std::uint8_t {
    Up,
    Stalled,       ///< what was sent does not leave: nobody acknowledges, or the bus is full
    ErrorWarning,  ///< works, with errors
    ErrorPassive,  ///< works, with many errors
    BusOff,        ///< the controller has given up
    Down,          ///< the interface is there, but down
    Absent,        ///< there is no such interface (any more)
    Ended,         ///< a recording of which all has been handed out
};

inline constexpr std::array kBusStates{
    BusState::Up,     BusState::Stalled, BusState::ErrorWarning, BusState::ErrorPassive,
    BusState::BusOff, BusState::Down,    BusState::Absent,       BusState::Ended};

/// The command that mends it; empty where none does.
std::string cureOf(BusState state, const std::string& bus);

/// In one sentence for people: which bus, what is the matter, and the command that mends it.
std::string describe(BusState state, const std::string& bus);

/// Since the bus was opened.
struct BusCounters {
    std::uint64_t received = 0;  ///< frames handed out, echoes and error frames among them
    std::uint64_t dropped = 0;   ///< frames that the kernel had no room for; never handed out
    std::uint64_t errorFrames = 0;
    std::uint64_t forgedErrors = 0;  ///< of these, the ones that a process of this computer made up
    std::uint64_t malformed = 0;     ///< what was no frame at all and is not handed out
    std::uint64_t sent = 0;          ///< frames handed to the kernel
    std::uint64_t confirmed = 0;     ///< of these, frames whose echo was seen
    std::uint64_t notSent = 0;       ///< frames that send() refused
    std::uint64_t reopened = 0;      ///< times the interface was found again
};

/// Throws std::invalid_argument for what is no classic data or remote frame.
void requireSendable(const CanFrame& frame);

/// Moves frames and gives them no meaning.  receive() belongs to one thread; the rest may be called from any.
class CanBus {
public:
    virtual ~CanBus() = default;

    virtual std::string name() const = 0;  ///< "can0"

    /// Fills `frames` from its beginning and says how many; waits at most `patience` for the first.  A
    /// bus that is down or gone is a state(), not an Error: it waits, and looks for it again.  Echoes and
    /// error frames are handed out, too; it is here that a bus learns of them, so it wants to be called
    /// all the time.  Throws std::invalid_argument where there is no room for one frame.
    virtual Result<std::size_t> receive(std::span<BusFrame> frames,
                                        std::chrono::milliseconds patience) = 0;

    /// Hands one frame to the kernel, or says why not.  Never waits and never tries again by itself.
    /// Throws std::invalid_argument for what is no classic data or remote frame.
    virtual Status send(const CanFrame& frame) = 0;

    virtual BusState state() const = 0;
    virtual BusCounters counters() const = 0;
};

}  // namespace terratact
