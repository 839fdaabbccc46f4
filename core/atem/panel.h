#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "core/base/message.h"

namespace terratact {

// Operator panel of buttons and lamps. Every contact has a safe side: open, which acts at once.
// Closed is debounced: it counts after the contact was undisturbed for PanelLimits::settle. STOP is normally closed:
// pressing it, a broken wire and an unplugged panel all read as open.

enum class PanelContact : std::uint8_t { Atem, Approve, Refuse, Stop };
inline constexpr std::size_t kPanelContacts = 4;
inline constexpr std::array<PanelContact, kPanelContacts> kAllPanelContacts{
    PanelContact::Atem, PanelContact::Approve, PanelContact::Refuse, PanelContact::Stop};
inline constexpr std::array<PanelContact, 3> kPanelButtons{
    PanelContact::Atem, PanelContact::Approve, PanelContact::Refuse};

std::string_view name(PanelContact contact);  ///< "atem", "approve", "refuse", "stop"

/// One value per contact.
template <class T>
struct PerContact {
    std::array<T, kPanelContacts> values{};

    T& operator[](PanelContact c) { return values[static_cast<std::size_t>(c)]; }
    const T& operator[](PanelContact c) const { return values[static_cast<std::size_t>(c)]; }
    bool operator==(const PerContact&) const = default;
};

/// History of a button's contact. Only Pressed has an effect on the robot.
///
///   Starting ──open──▶ Released ──closed──▶ Pressed ──10 min──▶ Stuck
///       └──closed──▶ HeldAtStart            all of them ──open──▶ Released
enum class ButtonPhase : std::uint8_t {
    Starting,     ///< not seen open since the panel started
    Released,     ///< seen open: the next closing is a press
    Pressed,      ///< the operator presses it
    HeldAtStart,  ///< fault: closed when the panel started; not pressed until seen open
    Stuck,        ///< fault: closed for longer than a press takes; not pressed until seen open
};

struct ContactState {
    bool closed = false;                        ///< as last read
    double since = 0.0;                         ///< time of the last change or disturbance [s]
    bool trusted = false;                       ///< closed, and undisturbed for PanelLimits::settle
    ButtonPhase phase = ButtonPhase::Starting;  ///< for buttons; STOP has none
    double pressedAt = 0.0;                     ///< [s] when Pressed began
    bool operator==(const ContactState&) const = default;
};

struct PanelState {
    bool present = false;      ///< the contacts could be read at `time`
    bool stop = true;          ///< asserted: STOP is or was just open, or cannot be read
    double time = 0.0;         ///< time of the last tick [s]
    PerContact<bool> pressed;  ///< buttons that were pressed in this tick
    PerContact<ContactState> contacts;

    /// Returns true while the button is pressed; the first edge ends it. False for STOP.
    bool held(PanelContact button) const;
    bool operator==(const PanelState&) const = default;
};

/// One reading of the panel.
struct PanelInput {
    double now = 0.0;  ///< any monotonic clock [s], when `closed` was read
    /// Levels of the contacts, read after the edges; empty if the panel cannot be read.
    std::optional<PerContact<bool>> closed;
    /// True if an edge occurred since the last reading, or may have occurred. Edges can get lost,
    /// so only the levels show how a burst ended.
    PerContact<bool> disturbed;
};

struct PanelLimits {
    double settle = 0.03;  ///< [s] a contact must be undisturbed before it counts
    double stuck = 600.0;  ///< [s] longest press
};

/// Computes one tick, without a clock. Throws std::invalid_argument unless in.now is finite.
PanelState nextPanel(const PanelState& state, const PanelInput& in, const PanelLimits& limits = {});

/// Returns one sentence about a button's fault; empty if there is none.
Message buttonTrouble(PanelContact button, ButtonPhase phase);

/// Lamps and buzzer of the panel. A lamp is on or off; the caller makes it blink.
struct LampState {
    bool link = false;     ///< the robot's telemetry is fresh
    bool armed = false;    ///< the robot may move on this console's command
    bool probing = false;  ///< an exploration runs: flippers or arm may move automatically
    bool buzzer = false;   ///< on: the operator must look at the console now
    bool operator==(const LampState&) const = default;
};
inline constexpr std::size_t kPanelOutputs = 4;
inline constexpr std::array<std::string_view, kPanelOutputs> kPanelOutputNames{
    "link_lamp", "armed_lamp", "probing_lamp", "buzzer"};

/// Returns the values in the order of kPanelOutputNames.
std::array<bool, kPanelOutputs> outputsOf(const LampState& lamps);

/// Lamp test at start-up: each lamp in turn, then the buzzer briefly, then all dark. elapsed: [s]
/// since the start. Empty before and after the test of 1.3 s.
std::optional<LampState> lampTest(double elapsed);

}  // namespace terratact
