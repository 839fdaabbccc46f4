#include "widgets/control/arming_control.h"

#include <gtest/gtest.h>

#include <QPushButton>
#include <vector>

namespace terratact {
namespace {

TEST(Arming, aKeyThatCannotArmSaysWhy)
{
    ArmingControl control;
    control.show();
    std::vector<std::string> said;
    int wanted = 0;
    QObject::connect(&control, &ArmingControl::impossible,
                     [&](const Message& missing) { said.push_back(missing.english()); });
    QObject::connect(&control, &ArmingControl::armingWanted, [&] { ++wanted; });
    const Precondition met{Precondition::Level::Met, Message::verbatim("telemetry is live")};
    const Precondition missing{Precondition::Level::Missing, Message::verbatim("link: 0.3 s good")};

    control.setState({}, {met, missing});
    control.pressKey();
    EXPECT_EQ(said, std::vector<std::string>{"link: 0.3 s good"});
    EXPECT_EQ(wanted, 0);

    control.setState({}, {met});
    control.pressKey();
    EXPECT_EQ(said.size(), 1U);
    EXPECT_EQ(wanted, 1);

    control.setListening("a replay");
    control.pressKey();
    EXPECT_EQ(said.size(), 1U) << "the button says it already";
    EXPECT_EQ(wanted, 1);
}

}  // namespace
}  // namespace terratact
