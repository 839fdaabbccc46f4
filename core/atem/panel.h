#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace terratact {

// What the operator's panel of buttons and lamps means.  Every contact is read the same way: open is the
// safe side and acts at once, closed is believed only after it has been undisturbed for a while.  STOP is
// normally closed, so pressing it, a broken wire and an unplugged panel are all the same: open.

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

/// What a button's contact has been through.  Only Pressed means anything to the robot.
///
///   Starting ──open──▶ Released ──closed──▶ Pressed ──10 min──▶ Stuck
///       └──closed──▶ HeldAtStart            all of them ──open──▶ Released
enum class ButtonPhase : std::uint8_t {
    Starting,     ///< not yet seen open since the panel came up
    Released,     ///< seen open: the next closing is a press
    Pressed,      ///< by somebody
    HeldAtStart,  ///< fault: closed when the panel came up; counts as not pressed until seen open
    Stuck,        ///< fault: closed for longer than anybody presses; the same
};

struct ContactState {
    bool closed = false;   ///< as last read
    double since = 0.0;    ///< [s] when it was last seen to change or to be disturbed
    bool trusted = false;  ///< closed, and undisturbed for PanelLimits::settle
    ButtonPhase phase = ButtonPhase::Starting;  ///< of a button; STOP has none
    double pressedAt = 0.0;                     ///< [s] when Pressed began
    bool operator==(const ContactState&) const = default;
};

struct PanelState {
    bool present = false;      ///< the contacts could be read at `time`
    bool stop = true;          ///< asserted: STOP is open, was open a moment ago, or cannot be read
    double time = 0.0;         ///< [s] of the last tick
    PerContact<bool> pressed;  ///< buttons pressed anew: in this tick only
    PerContact<ContactState> contacts;

    /// The button is pressed now; ends with the first edge.  False for STOP.
    bool held(PanelContact button) const;
    bool operator==(const PanelState&) const = default;
};

/// One look at the panel.
struct PanelInput {
    double now = 0.0;  ///< [s] any monotonic clock, when `closed` was read
    /// The levels, read after the edges; nothing where the panel cannot be read.
    std::optional<PerContact<bool>> closed;
    /// There was an edge since the look before, or there may have been.  What a burst ended in the levels
    /// say, because edges get lost; that there was one is all that an edge says.
    PerContact<bool> disturbed;
};

struct PanelLimits {
    double settle = 0.03;  ///< [s] a contact must be undisturbed before it is believed
    double stuck = 600.0;  ///< [s] of one press
};

/// One tick, no clock.  Throws std::invalid_argument unless in.now is finite.
PanelState nextPanel(const PanelState& state, const PanelInput& in, const PanelLimits& limits = {});

/// What is wrong with a button, in one sentence; empty where nothing is.
std::string buttonTrouble(PanelContact button, ButtonPhase phase);

/// What the panel shows.  A lamp is lit or not; whoever wants it to blink asks so.
struct LampState {
    bool link = false;     ///< the robot's telemetry is fresh
    bool armed = false;    ///< the robot may move on this console's command
    bool probing = false;  ///< an exploration runs: flippers or arm may move by themselves
    bool buzzer = false;   ///< sounds: the operator must look at the console now
    bool operator==(const LampState&) const = default;
};
inline constexpr std::size_t kPanelOutputs = 4;
inline constexpr std::array<std::string_view, kPanelOutputs> kPanelOutputNames{
    "link_lamp", "armed_lamp", "probing_lamp", "buzzer"};

/// In the order of kPanelOutputNames.
std::array<bool, kPanelOutputs> outputsOf(const LampState& lamps);

/// Shows at start-up that every lamp works: one after the other, the buzzer last and briefly, then all
/// dark.  elapsed: [s] since the start; nothing once the test is over (1.3 s) and before it.
std::optional<LampState> lampTest(double elapsed);

}  // namespace terratact
