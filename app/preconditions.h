#pragma once

#include <QCoreApplication>
#include <QString>

#include "app/estimation.h"
#include "core/infer/settings.h"
#include "core/robot/measurement.h"
#include "widgets/atem_panel.h"

namespace terratact {

/// What has to be so before an exploration may begin, in the operator's words.
class Preconditions {
    Q_DECLARE_TR_FUNCTIONS(Preconditions)
public:
    static Precondition telemetry(bool alive, bool logEnded);
    static Precondition stop(bool latched, bool releasing);  ///< releasing: not yet confirmed
    static Precondition arming(const QString& whyNot);       ///< empty: the robot is armed
    static Precondition model(const ModelInUse& model);
};

/// The method takes the ground as the same left and right.  Where roll or flippers speak against that, the operator
/// may take the doubt upon himself, until there is none any more.
class PlanarGround {
    Q_DECLARE_TR_FUNCTIONS(PlanarGround)
public:
    /// Met, Doubtful or Overridden, by the limits of the settings.
    Precondition judge(const Measurement& measurement, const Settings& settings) const;

    void overrideDoubt() { overridden_ = true; }
    void endOverride() { overridden_ = false; }
    bool isOverridden() const { return overridden_; }

private:
    bool overridden_ = false;
};

}  // namespace terratact
