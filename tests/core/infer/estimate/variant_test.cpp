#include "core/infer/estimate/variant.h"

#include <gtest/gtest.h>

#include "core/infer/estimate/estimate.h"

namespace terratact {
namespace {

TEST(Variant, isFoundByItsName)
{
    for (const Method m : kMethods) EXPECT_EQ(methodFromName(name(m)), m);
    for (const Method m : kSceneMethods) EXPECT_EQ(sceneMethodFromName(name(m)), m);
    EXPECT_FALSE(sceneMethodFromName("trail")) << "one scene alone has no way";
    for (const CeilingRule r : {CeilingRule::Truncate, CeilingRule::Clamp, CeilingRule::None})
        EXPECT_EQ(ceilingRuleFromName(name(r)), r);
    for (const ContactRule r : {ContactRule::Isolated, ContactRule::Any})
        EXPECT_EQ(contactRuleFromName(name(r)), r);
    for (const ScanOrder o : {ScanOrder::Forward, ScanOrder::Reverse, ScanOrder::Random})
        EXPECT_EQ(scanOrderFromName(name(o)), o);
}

TEST(Variant, hasTheNamesOfTheCommandLine)
{
    EXPECT_EQ(name(Method::Pa), "pa");
    EXPECT_EQ(name(Method::Pac), "pac");
    EXPECT_EQ(name(Method::Pafc), "pafc");
    EXPECT_EQ(name(Method::Pafac), "pafac");
    EXPECT_EQ(name(CeilingRule::Truncate), "truncate");
    EXPECT_EQ(name(CeilingRule::Clamp), "clamp");
    EXPECT_EQ(name(CeilingRule::None), "none");
    EXPECT_EQ(name(ContactRule::Isolated), "isolated");
    EXPECT_EQ(name(ContactRule::Any), "any");
    EXPECT_EQ(name(ScanOrder::Forward), "forward");
    EXPECT_EQ(name(ScanOrder::Reverse), "reverse");
    EXPECT_EQ(name(ScanOrder::Random), "random");
}

TEST(Variant, isNotFoundByAnotherName)
{
    for (const char* text : {"", "PA", "paf", "pafc ", "isolated"})
        EXPECT_FALSE(methodFromName(text)) << text;
    EXPECT_FALSE(ceilingRuleFromName("pa"));
    EXPECT_FALSE(contactRuleFromName("truncate"));
    EXPECT_FALSE(scanOrderFromName("backward"));
}

TEST(Origin, hasTheNamesOfTheEstimatesFile)
{
    EXPECT_EQ(name(Origin::Sampled), "sampled");
    EXPECT_EQ(name(Origin::Contact), "contact");
    EXPECT_EQ(name(Origin::Arm), "arm");
}

}  // namespace
}  // namespace terratact
