#pragma once

#include <string>
#include <vector>

#include "core/infer/estimate/variant.h"
#include "core/robot/measurement.h"

namespace terratact {

/// The features that the method would use and the scene lacks; none for `pa` and `pac`, which use pitch and flipper
/// angles alone.
MissingFeatures missingFor(Method method, const Proprioception& s);

/// The method that estimates a scene which lacks those features:
///   Joint, Local      themselves, without those features (core/learn/model/reduced_clearances.h)
///   Pafc, Pafac       themselves, with the conditionals of Pa: contacts of the forces that are there, ceilings and
///                     arm as ever
///   Clearance         Local
Method methodWithout(Method method, MissingFeatures missing);

/// What was not measured, and which method takes the place of `method` for it: sentences, none where nothing lacks.
std::vector<std::string> missingSentences(Method method, MissingFeatures missing);

}  // namespace terratact
