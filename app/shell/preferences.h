#pragma once

#include <QByteArray>
#include <QString>
#include <functional>
#include <numbers>
#include <string_view>
#include <vector>

#include "core/atem/probe_policy.h"
#include "core/base/result.h"
#include "core/infer/estimate/quality.h"
#include "core/robot/attitude.h"
#include "widgets/base/palette.h"

namespace terratact {

/// What the terrain page makes large.
enum class Layout : std::uint8_t { Drive, Probe, Review };

/// What an operator has chosen and finds again at the next start.  Plain values.
struct Preferences {
    ThemeName theme = ThemeName::Day;
    int fontScale = 100;  ///< [%] kSmallestFont … kLargestFont
    QString language;     ///< "en", "cs" or "de"; empty: the system's
    Layout layout = Layout::Probe;
    bool sound = true;            ///< alarms may be heard
    double obstacleLimit = 0.10;  ///< [m] a higher step is an obstacle (hasStep())
    Method method = Method::Local;
    Quality quality = Quality::Balanced;
    int estimateSeconds = 0;  ///< [s] after which sampling ends with what there is; 0: no limit
    double forceThreshold = Settings{}.forceThreshold;  ///< [N]
    ProbePolicy probes = ProbePolicy::Variance;
    double probeAbove = Settings{}.probeAbove;  ///< [m]
    double rollLimit = Settings{}.rollLimit;    ///< [rad]
    double hazardRate =
        Settings{}.hazardRate;  ///< per bin that nothing has felt, core/infer/estimate/hazards.h
    double asymmetryLimit = Settings{}.asymmetryLimit;                          ///< [rad]
    double tiltAmber = AttitudeLimits{}.amber, tiltRed = AttitudeLimits{}.red;  ///< [rad]
    QString model, robot;                 ///< files; empty: the shipped ones
    QStringList dbc;                      ///< files, at most kMaxDbcFiles
    bool record = true;                   ///< what happens at the console
    int keepDays = 0, keepGigabytes = 0;  ///< of recordings; 0: nothing is ever deleted
    bool mayDelete = false;               ///< recordings beyond them; else they are only told of
    QByteArray window;                    ///< QWidget::saveGeometry(); empty: none yet
    bool operator==(const Preferences&) const = default;
};

/// What a preference may be, in the file and on the page of the settings.
struct PreferenceRange {
    double least, most;
};
inline constexpr double kDegree = std::numbers::pi / 180.0;
inline constexpr double kPercent = 0.01;
inline constexpr PreferenceRange kObstacleRange{0.02, 0.60};                      ///< [m]
inline constexpr PreferenceRange kForceRange{0.1, 50.0};                          ///< [N]
inline constexpr PreferenceRange kProbeAboveRange{0.01, 0.50};                    ///< [m]
inline constexpr PreferenceRange kHazardRateRange{0.001, 0.5};                    ///< per bin
inline constexpr PreferenceRange kRollRange{1.0 * kDegree, 45.0 * kDegree};       ///< [rad]
inline constexpr PreferenceRange kAsymmetryRange{1.0 * kDegree, 90.0 * kDegree};  ///< [rad]
inline constexpr PreferenceRange kTiltRange{5.0 * kDegree, 80.0 * kDegree};       ///< [rad]
inline constexpr int kSmallestFont = 80, kLargestFont = 200;                      ///< [%]
inline constexpr int kMaxEstimateSeconds = 25;  ///< an exploration waits for 30 s
inline constexpr int kMaxDays = 10'000, kMaxGigabytes = 100'000;
inline constexpr qsizetype kMaxDbcFiles = 32;
inline constexpr int kPreferencesSchema = 1;

/// The methods an operator chooses from; PAFAc is what PAFc becomes once the arm has measured.
std::vector<Method> offeredMethods();

/// The settings with what the preferences say about method, quality and limits.
Settings withPreferences(Settings settings, const Preferences& preferences);

/// terratact/console.ini in the user's configuration folder (XDG base directory specification).
QString preferencesPath();

/// A sentence in the language of when it is asked for: what language that is to be stands in the file.
using LateSentence = std::function<QString()>;

struct LoadedPreferences {
    Preferences preferences;
    std::vector<LateSentence> troubles;  ///< one for each thing that was not taken as it stood
    QString path;  ///< where to save; empty: nowhere, the file there is not ours to replace
};

/// Reads a file of preferences; never fails.  A value that is not valid is replaced by its default, a file that
/// cannot be understood is set aside as PATH.bad, and one of a newer schema is left alone: a sentence each.
/// An empty path (safe mode) gives the defaults, and no path to save to.
LoadedPreferences loadPreferences(const QString& path);

/// Replaces the file, whole or not at all.  Returns why it could not, in one sentence; empty: it is saved.
/// Does nothing for an empty path.
QString savePreferences(const QString& path, const Preferences& preferences);

/// Every preference that differs, under its key in the file, for the record of a session: "method: local → pafc;
/// sound: true → false".  Where the window is, is none of it.
QString changesOf(const Preferences& before, const Preferences& now);

// What is said when a preferred file could not be used.
LateSentence robotNotUsed(const Error& why);
LateSentence modelNotUsed(const QString& path);

/// The names used in the file and on the command line: "day", "night-red", "high-contrast"; "drive", …
std::string_view name(ThemeName theme);
std::string_view name(Layout layout);

}  // namespace terratact
