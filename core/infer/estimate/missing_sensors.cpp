#include "core/infer/estimate/missing_sensors.h"

#include <fmt/format.h>

namespace terratact {

namespace {

bool allForces(MissingFeatures missing)
{
    return (missing >> kFirstForceFeature).count() == std::size_t{kForceElements};
}

void addForces(std::vector<std::string>& sentences, MissingFeatures missing)
{
    if (allForces(missing)) {
        sentences.emplace_back("no force was measured: the bands are wider");
        return;
    }
    for (std::size_t e = 0; e < std::size_t{kForceElements}; ++e)
        if (missing[kFirstForceFeature + e])
            sentences.push_back(fmt::format(
                "the force of element {} was not measured: the bands are wider", e + 1));
}

void addCurrents(std::vector<std::string>& sentences, MissingFeatures missing)
{
    const bool front = missing[kFrontCurrentFeature], rear = missing[kRearCurrentFeature];
    if (front && rear)
        sentences.emplace_back("no flipper current was measured: the bands are wider");
    else if (front)
        sentences.emplace_back("the front flippers' current was not measured: the bands are wider");
    else if (rear)
        sentences.emplace_back("the rear flippers' current was not measured: the bands are wider");
}

}  // namespace

MissingFeatures missingFor(Method method, const Proprioception& s)
{
    return usesForces(method) ? missingFeatures(s) : MissingFeatures{};
}

Method methodWithout(Method method, MissingFeatures missing)
{
    return method == Method::Clearance && missing.any() ? Method::Local : method;
}

std::vector<std::string> missingSentences(Method method, MissingFeatures missing)
{
    std::vector<std::string> sentences;
    addCurrents(sentences, missing);
    addForces(sentences, missing);
    if (missing.none()) return sentences;
    if (method == Method::Clearance)
        sentences.emplace_back("method clearance needs every current and force: local estimates");
    if (isOfPaper(method))
        sentences.emplace_back("the processes use pitch and flipper angles alone");
    return sentences;
}

}  // namespace terratact
