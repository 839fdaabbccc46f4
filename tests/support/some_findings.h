#pragma once

#include <gtest/gtest.h>

#include "app/modelling/findings.h"

/// Findings of an evaluation of ten scenes.
namespace terratact {

inline constexpr std::size_t kFindingScenes = 10;

inline BinError someBinError(std::size_t scene, const std::string& label)
{
    const double x = 0.1 * static_cast<double>(scene) + 1.0 / 3.0;
    BinError e{.scene = scene, .label = label, .bin = static_cast<int>(scene), .error = -x};
    e.scores = {
        .crps = x, .pit = 0.25, .in50 = true, .in80 = false, .in95 = true, .width = 2.0 * x};
    e.origin = scene % 2 == 0 ? Origin::Arm : Origin::Contact;
    e.novelty = x;
    return e;
}

/// Returns the findings of one part's scenes.
inline Findings someFindings(Shard shard)
{
    Findings f;
    f.origin = {{"command", "terratact evaluate"}, {"scenes' SHA-256", "scenes"}};
    f.options = {.methods = {Method::Local},
                 .seed = ~std::uint64_t{0},
                 .stepLimit = 0.1,
                 .sdLimit = 0.06,
                 .classes = true};
    f.shard = shard;
    f.total = kFindingScenes;
    const std::size_t begin = shard.begin(kFindingScenes), end = shard.end(kFindingScenes);
    for (std::size_t k = begin; k < end; ++k)
        f.scenes.push_back({"run, \"" + std::to_string(k / 3) + "\"",
                            0.1 * static_cast<double>(k),
                            {static_cast<int>(k), 10},
                            "kind"});
    ProbeRun probes{"local", "sd", {}};
    for (const char* label : {"local", "flat"}) {
        f.runs.push_back({label, end - begin, end - begin - 1, 2, 1, 1, 0.5});
        for (std::size_t k = begin; k < end; ++k) {
            if (k % 4 == 3) continue;
            f.errors.push_back(someBinError(k, label));
            f.steps.push_back({k, label, StepPlace::Ahead, 1.0 / 3.0, k % 2 == 0});
        }
    }
    for (std::size_t k = begin; k < end; ++k)
        probes.trials.push_back({{0.1, 0.2}, {0.05, 1.0 / static_cast<double>(k + 1)}, 2, true});
    f.probes = {probes};
    return f;
}

inline void expectSame(const Findings& a, const Findings& b)
{
    EXPECT_EQ(a.origin, b.origin);
    EXPECT_EQ(a.options, b.options);
    EXPECT_EQ(a.shard, b.shard);
    EXPECT_EQ(a.total, b.total);
    EXPECT_EQ(a.scenes, b.scenes);
    EXPECT_EQ(a.errors, b.errors);
    ASSERT_EQ(a.steps.size(), b.steps.size());
    for (std::size_t k = 0; k < a.steps.size(); ++k) {
        EXPECT_EQ(a.steps[k].scene, b.steps[k].scene);
        EXPECT_EQ(a.steps[k].label, b.steps[k].label);
        EXPECT_EQ(a.steps[k].place, b.steps[k].place);
        EXPECT_EQ(a.steps[k].probability, b.steps[k].probability);
        EXPECT_EQ(a.steps[k].observed, b.steps[k].observed);
    }
    ASSERT_EQ(a.probes.size(), b.probes.size());
    for (std::size_t k = 0; k < a.probes.size(); ++k) {
        const auto &p = a.probes[k].trials, &q = b.probes[k].trials;
        ASSERT_EQ(p.size(), q.size());
        for (std::size_t t = 0; t < p.size(); ++t)
            EXPECT_TRUE(p[t].before == q[t].before && p[t].after == q[t].after
                        && p[t].probes == q[t].probes && p[t].settled == q[t].settled);
    }
}

}  // namespace terratact
