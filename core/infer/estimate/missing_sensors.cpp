#include "core/infer/estimate/missing_sensors.h"

namespace terratact {

namespace {

bool allForces(MissingFeatures missing)
{
    return (missing >> kFirstForceFeature).count() == std::size_t{kForceElements};
}

void addForces(std::vector<Message>& sentences, MissingFeatures missing)
{
    if (allForces(missing)) {
        sentences.emplace_back(TR_NOOP("core", "no force was measured: the bands are wider"));
        return;
    }
    for (std::size_t e = 0; e < std::size_t{kForceElements}; ++e)
        if (missing[kFirstForceFeature + e])
            sentences.emplace_back(
                TR_NOOP("core", "the force of element %1 was not measured: the bands are wider"),
                e + 1);
}

void addCurrents(std::vector<Message>& sentences, MissingFeatures missing)
{
    const bool front = missing[kFrontCurrentFeature], rear = missing[kRearCurrentFeature];
    if (front && rear)
        sentences.emplace_back(
            TR_NOOP("core", "no flipper current was measured: the bands are wider"));
    else if (front)
        sentences.emplace_back(
            TR_NOOP("core", "the front flippers' current was not measured: the bands are wider"));
    else if (rear)
        sentences.emplace_back(
            TR_NOOP("core", "the rear flippers' current was not measured: the bands are wider"));
}

}  // namespace

MissingFeatures missingFor(Method method, const Proprioception& s)
{
    return usesForces(method) ? missingFeatures(s) : MissingFeatures{};
}

Method methodWithout(Method method, MissingFeatures missing)
{
    const bool isPlain = method == Method::Clearance || method == Method::Trail;
    return isPlain && missing.any() ? Method::Local : method;
}

std::vector<Message> missingSentences(Method method, MissingFeatures missing, bool usesArm)
{
    std::vector<Message> sentences;
    addCurrents(sentences, missing);
    addForces(sentences, missing);
    if (missing.none()) return sentences;
    if (method == Method::Clearance)
        sentences.emplace_back(
            TR_NOOP("core", "method clearance needs every current and force: local estimates"));
    if (method == Method::Trail)
        sentences.emplace_back(
            usesArm
                ? TR_NOOP("core", "the memory of the way needs every current and force: only the "
                                  "arm's earlier readings are used")
                : TR_NOOP("core", "the memory of the way needs every current and force: this scene "
                                  "alone counts"));
    if (isOfPaper(method))
        sentences.emplace_back(TR_NOOP("core", "the processes use pitch and flipper angles alone"));
    return sentences;
}

std::vector<Message> oneSidedSentences(MissingFeatures own, MissingFeatures other)
{
    if (allForces(other)) return {};
    if (allForces(own))
        return {TR_NOOP("core", "no force was measured: the other side's forces count for both")};
    std::vector<Message> sentences;
    for (std::size_t e = 0; e < std::size_t{kForceElements}; ++e)
        if (own[kFirstForceFeature + e] && !other[kFirstForceFeature + e])
            sentences.emplace_back(TR_NOOP("core", "the force of element %1 was not measured: the "
                                                   "other side's counts for both"),
                                   e + 1);
    return sentences;
}

}  // namespace terratact
