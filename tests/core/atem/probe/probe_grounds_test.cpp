#include "core/atem/probe/probe_grounds.h"

#include <gtest/gtest.h>

#include <functional>
#include <set>

namespace terratact {
namespace {

ProbeGrounds grounds()
{
    ProbeGrounds g;
    g.scene.time = 12.5;
    g.scene.pitch = 0.1;
    g.scene.force = {0, 1, 2, 3, 4, 5};
    g.readings = {{.bin = 9, .height = -0.1, .sd = 0.03}};
    g.model = "b345e46a";
    g.bin = 10;
    return g;
}

TEST(ProbeGrounds, haveTheSameFingerprintWhenTheyAreTheSame)
{
    EXPECT_EQ(fingerprint(grounds()), fingerprint(grounds()));
    EXPECT_EQ(fingerprint(grounds()).size(), 64U);
}

TEST(ProbeGrounds, haveAnotherFingerprintWhateverChanges)
{
    using Change = std::function<void(ProbeGrounds&)>;
    const Change changes[] = {
        [](ProbeGrounds&) {},
        [](ProbeGrounds& g) { g.bin = 9; },
        [](ProbeGrounds& g) { g.side = ProbeSide::Left; },
        [](ProbeGrounds& g) { g.side = ProbeSide::Right; },
        [](ProbeGrounds& g) { g.readings[0].side = ProbeSide::Left; },
        [](ProbeGrounds& g) { g.model = "other"; },
        [](ProbeGrounds& g) { g.readings.clear(); },
        [](ProbeGrounds& g) { g.readings.push_back(g.readings.front()); },
        [](ProbeGrounds& g) { g.readings[0].bin = 8; },
        [](ProbeGrounds& g) { g.readings[0].height += 1e-12; },
        [](ProbeGrounds& g) { g.readings[0].sd = 0.02; },
        [](ProbeGrounds& g) { g.scene.time += 0.05; },
        [](ProbeGrounds& g) { g.scene.pitch += 1e-12; },
        [](ProbeGrounds& g) { g.scene.roll = 0.1; },
        [](ProbeGrounds& g) { g.scene.frontLeft = 0.1; },
        [](ProbeGrounds& g) { g.scene.frontRight = 0.1; },
        [](ProbeGrounds& g) { g.scene.rearLeft = 0.1; },
        [](ProbeGrounds& g) { g.scene.rearRight = 0.1; },
        [](ProbeGrounds& g) { g.scene.frontLeftCurrent = 0.1; },
        [](ProbeGrounds& g) { g.scene.frontRightCurrent = 0.1; },
        [](ProbeGrounds& g) { g.scene.rearLeftCurrent = 0.1; },
        [](ProbeGrounds& g) { g.scene.rearRightCurrent = 0.1; },
        [](ProbeGrounds& g) { g.scene.missing.set(kFrontCurrentFeature); },
        [](ProbeGrounds& g) { g.scene.missingMotors.set(0); },
        [](ProbeGrounds& g) { g.scene.missingMotors.set(kFrontCurrentFeature); },
        [](ProbeGrounds& g) { g.scene.force[5] = 5.1; },
        [](ProbeGrounds& g) { g.scene.sides.left[0] = 0.0; },
        [](ProbeGrounds& g) { g.scene.sides.left[0] = 0.1; },
        [](ProbeGrounds& g) { g.scene.sides.right[0] = 0.1; },
        [](ProbeGrounds& g) { g.scene.sides.left[5] = 0.1; },
        [](ProbeGrounds& g) { g.scene.rearSides.left[0] = 0.1; },
        [](ProbeGrounds& g) { g.scene.rearSides.right[5] = 0.1; },
        [](ProbeGrounds& g) { g.scene.differential = 0.0; },
        [](ProbeGrounds& g) { g.scene.differential = 0.1; },
        [](ProbeGrounds& g) { g.scene.activity = RobotActivity::Pressed; },
        [](ProbeGrounds& g) { g.scene.refusal = Refusal::Busy; },
        [](ProbeGrounds& g) { g.scene.arm = ArmReading{}; },
        [](ProbeGrounds& g) { g.scene.travelled = 0.0; },
        [](ProbeGrounds& g) { g.scene.travelled = 0.1; },
        [](ProbeGrounds& g) { g.scene.turned = 0.0; },
        [](ProbeGrounds& g) { g.scene.turned = 0.1; },
        [](ProbeGrounds& g) { g.settings.method = Method::Pafc; },
        [](ProbeGrounds& g) { g.settings.draws = 999; },
        [](ProbeGrounds& g) { g.settings.stopEarly = false; },
        [](ProbeGrounds& g) { g.settings.seed = 2; },
        [](ProbeGrounds& g) { g.settings.contactSd = 0.03; },
        [](ProbeGrounds& g) { g.settings.forceThreshold = 3; },
        [](ProbeGrounds& g) { g.settings.precision = Precision::Double; },
        [](ProbeGrounds& g) { g.settings.inducing = 300; },
        [](ProbeGrounds& g) { g.settings.probeAbove = 0.05; },
        [](ProbeGrounds& g) { g.settings.rollLimit = 0.2; },
        [](ProbeGrounds& g) { g.settings.asymmetryLimit = 0.2; },
        [](ProbeGrounds& g) { g.settings.chains = 8; },
        [](ProbeGrounds& g) { g.settings.burnIn = 8; },
        [](ProbeGrounds& g) { g.settings.scan = ScanOrder::Random; },
        [](ProbeGrounds& g) { g.settings.ceiling = CeilingRule::Clamp; },
        [](ProbeGrounds& g) { g.wanted.draws = 999; },
        [](ProbeGrounds& g) { g.wanted.ceiling = CeilingRule::Clamp; },
    };
    std::set<std::string> seen;
    for (const Change& change : changes) {
        ProbeGrounds changed = grounds();
        change(changed);
        EXPECT_TRUE(seen.insert(fingerprint(changed)).second) << "change " << seen.size();
    }
}

}  // namespace
}  // namespace terratact
