#pragma once

#include <QByteArray>
#include <QString>
#include <optional>
#include <string_view>
#include <vector>

#include "app/display/units.h"
#include "app/link/gamepad/pad_mapping.h"
#include "core/atem/probe/probe_policy.h"
#include "core/base/degree.h"
#include "core/base/message.h"
#include "core/base/result.h"
#include "core/infer/estimate/quality_preset.h"
#include "core/limits.h"
#include "core/robot/attitude.h"
#include "core/terrain/step.h"
#include "widgets/base/palette.h"

namespace terratact {

/// Layouts of the terrain page, named after their largest part.
enum class Layout : std::uint8_t { Drive, Probe, Review };

/// Choices of the operator that are restored at the next start; plain values.
struct Preferences {
    ThemeName theme = ThemeName::Day;
    int fontScale = 100;  ///< [%] kSmallestFont … kLargestFont
    QString language;     ///< "en", "cs" or "de"; empty: the system's
    Units units;          ///< of shown lengths and angles
    Layout layout = Layout::Probe;
    bool sound = true;                  ///< alarms make sounds
    int contactSound = 50;              ///< [%] level of the ticks of contacts; 0: off
    double obstacleLimit = kStepLimit;  ///< [m] obstacle height (hasStep())
    Method method = Method::Trail;  ///< Local estimates where the way before a scene is not known
    QualityPreset preset = QualityPreset::Balanced;
    int estimateSeconds = 0;                            ///< [s] time limit of sampling; 0: no limit
    double forceThreshold = Settings{}.forceThreshold;  ///< [N]
    ProbePolicy probes = ProbePolicy::Variance;
    double probeAbove = Settings{}.probeAbove;  ///< [m]
    double rollLimit = Settings{}.rollLimit;    ///< [rad]
    /// Hazard rate per bin that is not felt, core/infer/estimate/hazards.h.
    double hazardRate = Settings{}.hazardRate;
    double asymmetryLimit = Settings{}.asymmetryLimit;                          ///< [rad]
    double tiltAmber = AttitudeLimits{}.amber, tiltRed = AttitudeLimits{}.red;  ///< [rad]
    QString model, robot;                 ///< files; empty: the shipped ones
    QStringList dbc;                      ///< at most kMaxDbcFiles files
    bool record = true;                   ///< records sessions
    int keepDays = 0, keepGigabytes = 0;  ///< retention of recordings; 0: no limit
    bool mayDelete = false;  ///< deletes recordings beyond the limits; otherwise only reports them
    PadSettings pad;         ///< the gamepad
    QStringList plotSets;   ///< saved sets of plots (app/pages/plots_state.h), at most kMaxPlotSets
    QString sessionFolder;  ///< folder of the browser of recordings; empty: the console's own
    QByteArray window;      ///< QWidget::saveGeometry(); empty: none yet
    AttitudeLimits tilt() const { return {tiltAmber, tiltRed}; }
    bool operator==(const Preferences&) const = default;
};

/// Range of a preference in the file and on the settings page.
struct PreferenceRange {
    double least, most;
};
inline constexpr double kPercent = 0.01;
inline constexpr PreferenceRange kObstacleRange{kLowestStepLimit, kHighestStepLimit};  ///< [m]
inline constexpr PreferenceRange kForceRange{0.1, 50.0};                               ///< [N]
inline constexpr PreferenceRange kProbeAboveRange{0.01, 0.50};                         ///< [m]
inline constexpr PreferenceRange kHazardRateRange{0.001, 0.5};                         ///< per bin
inline constexpr PreferenceRange kRollRange{1.0 * kDegree, 45.0 * kDegree};            ///< [rad]
inline constexpr PreferenceRange kAsymmetryRange{1.0 * kDegree, 90.0 * kDegree};       ///< [rad]
inline constexpr PreferenceRange kTiltRange{5.0 * kDegree, 80.0 * kDegree};            ///< [rad]
inline constexpr PreferenceRange kDeadZoneRange{kSmallestDeadZone, kLargestDeadZone};
inline constexpr PreferenceRange kPadSpeedRange{kSlowestPad, kFastestPad};  ///< [m/s]
inline constexpr int kSmallestFont = 80, kLargestFont = 200;                ///< [%]
inline constexpr int kMaxEstimateSeconds = 25;  ///< [s] below the 30 s timeout of an exploration
inline constexpr int kMaxDays = 10'000, kMaxGigabytes = 100'000;
inline constexpr qsizetype kMaxDbcFiles = 32;
inline constexpr qsizetype kMaxPlotSets = 32;
inline constexpr int kPreferencesSchema = 2;

/// Returns the methods that an operator can choose. PAFAc is not among them: PAFc becomes it once the arm has measured.
std::vector<Method> offeredMethods();

/// Returns the settings with the preferred method, quality and limits.
Settings withPreferences(Settings settings, const Preferences& preferences);

/// Returns terratact/console.ini in userFolder() of XDG_CONFIG_HOME and .config. Empty: there is no home folder.
QString preferencesPath();

struct LoadedPreferences {
    Preferences preferences;
    std::vector<Message> troubles;  ///< one for each value that was not accepted
    /// Where to save. Empty: never, because the file must not be replaced, or there is no folder for it.
    QString path;
};

/// Reads a preferences file; never fails. An invalid value becomes its default. An unreadable file is moved to
/// PATH.bad. A file with a newer schema is not touched. A file of schema 1 holds the method local whether it was
/// chosen or not: it becomes the default. Each case adds a sentence to `troubles`. An empty path (safe
/// mode) gives the defaults without a path to save to.
LoadedPreferences loadPreferences(const QString& path);

/// Replaces the file atomically. Returns the reason of a failure in one sentence; empty: saved. Does nothing for an
/// empty path.
std::optional<Message> savePreferences(const QString& path, const Preferences& preferences);

/// Returns every changed preference by its key in the file, for the session's record: "method: local → pafc; sound:
/// true → false". The window geometry, the plots and the browser's folder are
/// omitted.
QString changesOf(const Preferences& before, const Preferences& now);

// Sentences for a preferred file that could not be used.
Message robotNotUsed(const Error& why);
Message modelNotUsed(const QString& path);

/// Return the names used in the file and on the command line: "day", "night-red", "high-contrast"; "drive", …
std::string_view name(ThemeName theme);
std::string_view name(Layout layout);

}  // namespace terratact
