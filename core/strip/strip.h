#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <vector>

#include "core/infer/estimate/two_track_estimate.h"
#include "core/robot/measurement.h"
#include "core/robot/robot_model.h"
#include "core/robot/watch/sensor_suspicion.h"
#include "core/strip/scene_scores.h"
#include "core/strip/strip_section.h"
#include "core/strip/strip_way.h"

namespace terratact {

/// Limits of a strip. Its memory is bounded by the columns and sources: below 1 MB.
struct StripLimits {
    WayLimits way{};
    std::size_t columns = 1500;  ///< in all sections: 150 m of ground; the oldest are dropped
    std::size_t sources = 1500;  ///< estimates above this number are kept while a bin is theirs
    bool corrects = true;  ///< the ground that scenes share corrects the odometry (strip_match.h)
};

/// An estimate that the strip holds bins of.
struct StripSource {
    std::int64_t number = 0;    ///< counts from 1
    std::int64_t estimate = 0;  ///< the caller's id
    double time = 0.0;          ///< time of the scene [s], on the source's clock
    bool onePlane = false;
    std::int64_t segment = 0;
    WayPose at{};  ///< pose of the scene
    /// The nearer feltHorizon() of the two sides, forward from the IMU at the scene [m]; empty: a side has none.
    std::optional<double> feltTo{};
};

/// A bin of the strip as seen from the robot.
struct SeenBin {
    double x = 0.0;   ///< [m] its centre, forward from the IMU
    HeightBand band;  ///< [m] DEM frame of the robot, with the uncertainty of the way since
    FeltBy felt = FeltBy::Unrecorded;
    double time = 0.0;  ///< time of the scene [s]
    double way = 0.0;   ///< way rolled since the scene [m]
    bool operator==(const SeenBin&) const = default;
};

/// The present section as seen from the robot, rear to front.
struct SeenStrip {
    std::array<std::vector<SeenBin>, 2> side{};  ///< left, right
    bool onePlane = true;                        ///< every estimate of the section was of one plane
    std::optional<double> way{};                 ///< way rolled since the newest estimate [m]
    /// The newest estimate felt the ground up to here, forward from the IMU [m], on both sides (feltHorizon()).
    std::optional<double> feltTo{};
    bool isEmpty() const { return side[0].empty() && side[1].empty(); }
    bool operator==(const SeenStrip&) const = default;
};

/// A bin of a section before a break.
struct EarlierBin {
    double x = 0.0;                 ///< [m] its centre, in the section's frame
    double height = 0.0, sd = 0.0;  ///< [m] in the section's frame, as when it was felt
    FeltBy felt = FeltBy::Unrecorded;
    bool operator==(const EarlierBin&) const = default;
};

/// A section before a break, rear to front, in its own frame (StripSection). Its place relative to the robot and to
/// other sections is unknown.
struct EarlierSection {
    std::array<std::vector<EarlierBin>, 2> side{};  ///< left, right
    bool onePlane = true;                      ///< every estimate of the section was of one plane
    SectionStart next = SectionStart::Turned;  ///< break that ended the section
    bool operator==(const EarlierSection&) const = default;
};

/// A touch of ground for which the strip predicted a height.
struct StripTouch {
    ScoredBy by = ScoredBy::Contact;
    std::size_t side = 0;             ///< 0: left, or both of one plane; 1: right
    double x = 0.0;                   ///< [m] centre of the strip's bin, forward from the IMU
    HeightBand predicted;             ///< [m] DEM frame of the scene
    double felt = 0.0, feltSd = 0.0;  ///< [m] height of the touch
};

/// Ground felt along the driven path: bins of 0.1 m in an odometry frame, left and right. Every finished estimate is
/// entered at the pose of its scene. The ground that it shares with the strip first corrects the odometry since the
/// scene before (strip_match.h). `fusion` makes one band of two estimates of a bin. Errors of successive estimates
/// are correlated, so their agreement adds no evidence. If the two contradict each other by more than
/// kContradiction sd, the newer one is kept. A bin keeps the moment at which it was felt. Seen from the robot, its sd
/// grows with the way since then. A break begins a new section: ground is not joined across it. A new touch of known
/// ground scores the strip's prediction (ledger()).
class Strip {
public:
    static constexpr double kContradiction = 3.0;
    static constexpr std::size_t kEarlier = 8;  ///< most sections of earlier()

    explicit Strip(const RobotModel& robot, const StripLimits& limits = {},
                   Fusion fusion = Fusion::FeltFirst);

    /// Adds the next line of telemetry. suspicions: of that line. While the odometry or the pitch is suspected, lines
    /// and scenes have no place: the section ends.
    void add(const Measurement& line, const std::vector<SensorSuspicion>& suspicions = {});
    /// Ends the section because telemetry was silent for too long by the caller's clock.
    void addSilence() { way_.end(SectionStart::TelemetryGap); }

    /// Marks the pose of a scene that will be estimated. It may be one of the last lines, while the robot stands.
    void beginScene(const Measurement& scene);
    /// Enters an estimate at the pose of the last scene. It replaces an earlier estimate of that scene. A scene without
    /// a place enters nothing. arm: all readings of the scene until now. Earlier predictions of the touched ground are
    /// scored first (ledger()).
    void enter(const TwoTrackEstimate& estimate, std::int64_t id,
               std::span<const ArmReading> arm = {});
    /// Takes out the estimate of the last scene, and what its contacts and passes scored.
    void removeLast();
    /// Begins a new section, because the operator cleared the ground or the model has changed.
    void endSection()
    {
        way_.end(SectionStart::Cleared);
        cleared_ = way_.segment();
    }

    /// Returns the sections, oldest first; each has a column.
    const std::deque<StripSection>& sections() const { return sections_; }
    /// Returns the source of a bin.
    const StripSource& source(const StripBin& bin) const;
    /// Returns the present section as seen from the newest line; empty after a break.
    SeenStrip seen() const;
    /// Returns the sections before the present one, newest first, at most kEarlier. After a break, the last section is
    /// one of them. Those before endSection() are left out.
    std::vector<EarlierSection> earlier() const;
    /// Returns a bin of a section as seen from a pose of its segment, without its place.
    HeightBand bandFrom(const StripBin& bin, const StripSection& section,
                        const WayPose& pose) const;
    /// Returns why nothing is seen: the last break, until an estimate is entered. Empty: something is seen.
    std::optional<SectionStart> whyNothing() const;
    /// Returns the touches of the last scene for which the strip predicts a height, before the
    /// scene's estimate is entered. Predictions are seen from the scene's pose by odometry alone.
    /// Neither that pose nor the band uses the scene.
    ///   Contact  height from the scene's readings alone (scene_contacts.h), with Settings::contactSd
    ///   Pass     bins on which the tracks stand, with the estimate's height and sd. An estimate by Trail also knows
    ///            earlier readings, so it is a less independent judge.
    std::vector<StripTouch> touchesOf(const TwoTrackEstimate& estimate) const;
    /// Returns how well bands held when their ground was touched again. Touches (touchesOf()) count
    /// by each scene's first estimate, the arm's readings against the band shown before.
    StripLedger ledger() const { return scores_.all(); }

private:
    /// A bin before the last scene's estimate was entered.
    struct Replaced {
        std::int64_t segment = 0;
        int column = 0;
        std::size_t side = 0;
        std::optional<StripBin> bin;
    };

    StripSection& sectionOfScene(const WayPose& pose);
    StripSection* sectionOf(std::int64_t segment);
    const StripSection* sectionOf(std::int64_t segment) const;
    PoseOffset offsetOf(const TwoTrackEstimate& estimate);
    std::optional<HeightBand> predictedBand(const StripSection& section, const WayPose& pose,
                                            int column, std::size_t side, bool onFlippers) const;
    Fusion ruleFor(FeltBy older, FeltBy newer) const;
    void place(StripSection& section, std::size_t side, const EnteredBin& entered,
               const WayPose& pose);
    void takeOut();
    void dropUnused();
    void dropOldest();
    EarlierSection earlierOf(const StripSection& section, SectionStart next) const;
    std::size_t columns() const;

    RobotModel robot_;
    StripLimits limits_;
    Fusion fusion_;
    StripWay way_;
    std::deque<StripSection> sections_;
    std::deque<StripSource> sources_;  ///< by number
    std::int64_t lastNumber_ = 0;
    std::int64_t cleared_ = 0;  ///< segment after the last endSection()
    bool isSceneEntered_ = false;
    std::vector<Replaced> replaced_;
    Measurement scene_;  ///< the last one
    SceneScores scores_;
};

}  // namespace terratact
