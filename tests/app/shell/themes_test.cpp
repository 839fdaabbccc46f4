// Tests the colours of each theme: contrast, and distinctness with colour vision deficiency.
#include <gtest/gtest.h>
#include <qwt_plot_curve.h>
#include <qwt_symbol.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "app/shell/preferences/preferences.h"
#include "tests/support/colour_contrast.h"
#include "tests/support/gui.h"
#include "widgets/base/palette.h"
#include "widgets/terrain/terrain_profile_view.h"

namespace terratact {
namespace {

constexpr std::array kThemes{ThemeName::Day, ThemeName::NightRed, ThemeName::HighContrast};

struct Colours {
    const char* name;
    QColor text, behind;
};

std::vector<Colours> textPairs(const Theme& t)
{
    std::vector<Colours> pairs{{"tip", t.text, t.tip},
                               {"header", t.headerText, t.header},
                               {"source", t.source, t.header},
                               {"source on a chosen page", t.source, t.chip.area},
                               {"chip off", t.chipOffText, t.chip.area},
                               {"prior only", t.warning, t.priorZone},
                               {"muted on the zone", t.muted, t.priorZone},
                               {"contact", t.contact, t.card}};
    const std::pair<const char*, QColor> inks[]{{"text", t.text}, {"muted", t.muted},
                                                {"good", t.good}, {"warning", t.warning},
                                                {"bad", t.bad},   {"accent", t.accent}};
    for (const auto& [name, ink] : inks) {
        pairs.push_back({name, ink, t.card});
        pairs.push_back({name, ink, t.window});
    }
    const std::pair<const char*, Fill> fills[]{
        {"button", t.button},      {"off", t.off},
        {"primary", t.primary},    {"stop", t.stop},
        {"stopped", t.stopped},    {"decide", t.decide},
        {"caution", t.caution},    {"chip", t.chip},
        {"chip good", t.chipGood}, {"chip warning", t.chipWarning},
        {"chip bad", t.chipBad},   {"chip accent", t.chipAccent},
        {"banner", t.banner},      {"done", t.done},
        {"clear", t.clear},        {"blocked", t.blocked},
        {"open", t.open},          {"felt", t.felt}};
    for (const auto& [name, fill] : fills) pairs.push_back({name, fill.text, fill.area});
    pairs.push_back({"progress not done", t.done.text, t.card});
    return pairs;
}

TEST(Themes, everyTextCanBeRead)
{
    for (const ThemeName name : kThemes) {
        const double least = name == ThemeName::HighContrast ? 7.0 : 4.5;
        for (const Colours& pair : textPairs(themeOf(name)))
            EXPECT_GE(gui::contrast(pair.text, pair.behind), least)
                << terratact::name(name) << ": " << pair.name;
    }
}

TEST(Themes, marksStandOutFromTheirGround)
{
    for (const ThemeName name : kThemes) {
        const Theme t = themeOf(name);
        for (const QColor& mark : {t.sampled, t.contact, t.arm, t.prior})
            EXPECT_GE(gui::contrast(mark, t.card), 2.4) << terratact::name(name);
        EXPECT_GE(gui::contrast(t.stop.area, t.header), 2.2) << terratact::name(name);
    }
}

/// Converts to CIELAB, D65.
gui::Rgb lab(const gui::Rgb& c)
{
    const auto f = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116.0; };
    const double x = f((0.4124 * c[0] + 0.3576 * c[1] + 0.1805 * c[2]) / 0.9505);
    const double y = f(0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2]);
    const double z = f((0.0193 * c[0] + 0.1192 * c[1] + 0.9505 * c[2]) / 1.089);
    return {116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)};
}

/// Simulates dichromatic vision, severity 1. Source: Machado, Oliveira and Fernandes, "A physiologically-based model
/// for simulation of color vision deficiency", IEEE TVCG 15 (2009).
constexpr std::array<std::array<std::array<double, 3>, 3>, 3> kDeficiencies{
    {{{{0.152286, 1.052583, -0.204868},
       {0.114503, 0.786281, 0.099216},
       {-0.003882, -0.048116, 1.051998}}},
     {{{0.367322, 0.860646, -0.227968},
       {0.280085, 0.672501, 0.047413},
       {-0.011820, 0.042940, 0.968881}}},
     {{{1.255528, -0.076749, -0.178779},
       {-0.078411, 0.930809, 0.147602},
       {0.004733, 0.691367, 0.303900}}}}};

double leastDifference(const std::array<QColor, 4>& colours)
{
    double least = 1e9;
    for (const auto& matrix : kDeficiencies) {
        std::array<gui::Rgb, 4> seen{};
        for (std::size_t i = 0; i < 4; ++i) {
            const gui::Rgb c = gui::linear(colours[i]);
            gui::Rgb s{};
            for (std::size_t row = 0; row < 3; ++row)
                s[row] = std::clamp(matrix[row][0] * c[0] + matrix[row][1] * c[1]
                                        + matrix[row][2] * c[2],
                                    0.0, 1.0);
            seen[i] = lab(s);
        }
        for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t j = 0; j < i; ++j)
                least = std::min(least, std::hypot(seen[i][0] - seen[j][0], seen[i][1] - seen[j][1],
                                                   seen[i][2] - seen[j][2]));
    }
    return least;
}

TEST(Themes, originsOfABinDifferInColourAndShape)
{
    // A ΔE*ab of 2.3 is just noticeable. The red theme has no hues, so only shapes distinguish there.
    for (const ThemeName name : {ThemeName::Day, ThemeName::HighContrast}) {
        const Theme t = themeOf(name);
        const double least = leastDifference({t.sampled, t.contact, t.arm, t.prior});
        EXPECT_GT(least, 4.0 * 2.3) << terratact::name(name);
    }
    const TerrainProfileView view;
    std::set<int> shapes;
    int curves = 0;
    for (const QwtPlotItem* item : view.itemList(QwtPlotItem::Rtti_PlotCurve)) {
        ++curves;
        shapes.insert(static_cast<const QwtPlotCurve*>(item)->symbol()->style());
    }
    EXPECT_EQ(curves, 5);
    EXPECT_EQ(shapes.size(), 5U);
}

}  // namespace
}  // namespace terratact
