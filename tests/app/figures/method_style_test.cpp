// Tests that figures distinguish methods.
#include "app/figures/method_style.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "tests/support/picture.h"
#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

TEST(MethodStyles, everyMethodHasItsOwnColourAndName)
{
    std::set<unsigned> colours;
    std::set<std::string> names;
    for (int i = 0; i <= static_cast<int>(Method::Trail); ++i) {
        const MethodStyle style = styleOf(static_cast<Method>(i));
        EXPECT_TRUE(colours.insert(style.colour.rgb).second) << style.words;
        EXPECT_TRUE(names.insert(style.words).second) << style.words;
        EXPECT_FALSE(style.hollow);
    }
}

TEST(MethodStyles, aVariantHasTheColourOfItsMethod)
{
    const MethodStyle plain = styleOf("pafc"), variant = styleOf("pafc/full");
    EXPECT_EQ(variant.colour.rgb, plain.colour.rgb);
    EXPECT_EQ(variant.words, plain.words + "/full");
    EXPECT_NE(variant.shape, plain.shape);
}

TEST(MethodStyles, baselinesAreHollow)
{
    for (const char* label : {"flat", "linear", "nearest", "anything"}) {
        EXPECT_TRUE(styleOf(label).hollow) << label;
        EXPECT_EQ(styleOf(label).words, label);
    }
    EXPECT_NE(styleOf("flat").colour.rgb, styleOf("linear").colour.rgb);
}

TEST(MethodStyles, aHollowMarkerHasAColouredRimOnly)
{
    const TemporaryDirectory directory;
    const auto coloured = [&](bool hollow) {
        MethodStyle style{.colour = {0xb01e4f}, .shape = Shape::Square, .size = 30.0, .words = {}};
        style.hollow = hollow;
        const std::string path = directory.file("marker.png");
        EXPECT_TRUE(writePicture(path, 60, 60, [&](Canvas& canvas) {
            drawMarker(canvas, style, {30.0, 30.0}, 1.0);
        }));
        return readPng(path).count(0xb01e4f);
    };
    EXPECT_GT(coloured(true), 0);
    EXPECT_LT(3 * coloured(true), coloured(false));
}

}  // namespace
}  // namespace terratact
