#pragma once

#include <string>
#include <vector>

#include "core/base/message.h"
#include "core/infer/estimate/variant.h"
#include "core/robot/measurement.h"

namespace terratact {

/// Returns the features that the method uses and the scene lacks. None for `pa` and `pac`, which
/// use pitch and flipper angles only.
MissingFeatures missingFor(Method method, const Proprioception& s);

/// Returns the method that estimates a scene without those features:
///   Joint, Local  the same method, without those features (core/learn/model/reduced_clearances.h)
///   Pafc, Pafac   the same method with Pa's conditionals, the remaining contacts, ceilings, arm
///   Clearance, Trail  Local; in place of Trail it keeps the arm's earlier readings
Method methodWithout(Method method, MissingFeatures missing);

/// Returns one sentence for what was not measured, and one if another method replaces `method`;
/// empty if nothing is missing. usesArm: of usesEarlierArm() (core/infer/trail_form.h).
std::vector<Message> missingSentences(Method method, MissingFeatures missing, bool usesArm);

/// Returns the sentences for the forces that one side lacks and the other side has. An estimate of
/// one plane takes the other side's for both. own, other: missing features of the sides.
std::vector<Message> oneSidedSentences(MissingFeatures own, MissingFeatures other);

}  // namespace terratact
