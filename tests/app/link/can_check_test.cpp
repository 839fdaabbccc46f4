#include "app/link/can_check.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cerrno>

namespace terratact {
namespace {

using Level = CanFinding::Level;

// Output of ip 6.1.
constexpr const char* kWorking =
    "3: can0: <NOARP,UP,LOWER_UP,ECHO> mtu 16 qdisc pfifo_fast state UP mode DEFAULT group default "
    "qlen 10\n    link/can  promiscuity 0  allmulti 0 minmtu 0 maxmtu 0 \n"
    "    can state ERROR-ACTIVE (berr-counter tx 0 rx 0) restart-ms 0 \n"
    "\t  bitrate 500000 sample-point 0.750 \n\t  tq 250 prop-seg 2 phase-seg1 3 phase-seg2 2 sjw 1 "
    "brp 2\n";
constexpr const char* kFresh =
    "3: can0: <NOARP,ECHO> mtu 16 qdisc noop state DOWN mode DEFAULT group default qlen 10\n"
    "    link/can  promiscuity 0  allmulti 0 minmtu 0 maxmtu 0 \n"
    "    can state STOPPED (berr-counter tx 0 rx 0) restart-ms 0 \n"
    "\t  mcp251x: tseg1 3..16 tseg2 2..8 sjw 1..4 brp 1..64 brp_inc 1\n\t  clock 8000000 \n";

struct Checking : testing::Test {
    CanInterfaceFacts facts{.name = "can0",
                            .present = true,
                            .isCan = true,
                            .isVirtual = false,
                            .up = true,
                            .sendQueue = 10,
                            .receiveLimit = 4L << 20,
                            .mayForce = false,
                            .others = {"can0"}};
    int socketError = 0;
    CanController controller = controllerFrom(kWorking);

    std::vector<CanFinding> of(Level level) const
    {
        std::vector<CanFinding> found;
        for (const CanFinding& finding : findingsOf(facts, socketError, controller))
            if (finding.level == level) found.push_back(finding);
        return found;
    }
    /// Returns the only finding that is not Fine.
    CanFinding finding(Level level) const
    {
        const auto found = of(level);
        const auto other = of(level == Level::Problem ? Level::Warning : Level::Problem);
        EXPECT_EQ(found.size(), 1U);
        EXPECT_TRUE(other.empty());
        return found.empty() ? CanFinding{} : found.front();
    }
};

TEST_F(Checking, findsNothingWrongWhereNothingIs)
{
    EXPECT_TRUE(of(Level::Problem).empty());
    EXPECT_TRUE(of(Level::Warning).empty());
    EXPECT_EQ(of(Level::Fine).size(), 5U);
    facts.isVirtual = true;
    facts.sendQueue = 1000;
    controller = {};
    EXPECT_TRUE(of(Level::Problem).empty());
    EXPECT_TRUE(of(Level::Warning).empty());
}

TEST_F(Checking, distinguishesMissingCanFromMissingRights)
{
    socketError = EAFNOSUPPORT;
    EXPECT_NE(finding(Level::Problem).cure.english().find("modprobe can_raw"), std::string::npos);
    socketError = EPERM;
    EXPECT_NE(finding(Level::Problem).what.english().find("this user may not"), std::string::npos);
    socketError = EMFILE;
    EXPECT_NE(finding(Level::Problem).what.english().find("Too many open files"),
              std::string::npos);
}

TEST_F(Checking, listsTheExistingInterfaces)
{
    facts.present = false;
    facts.others = {"can1", "vcan0"};
    EXPECT_EQ(finding(Level::Problem).what.english(),
              "there is no interface can0, but can1, vcan0");
    EXPECT_EQ(finding(Level::Problem).cure.english(), "terratact can check can1");
    facts.others.clear();
    EXPECT_NE(finding(Level::Problem).what.english().find("nor any CAN interface"),
              std::string::npos);
    facts.present = true;
    facts.isCan = false;
    EXPECT_EQ(finding(Level::Problem).what.english(), "can0 is no CAN interface");
}

TEST_F(Checking, asksForABitRateAndForBeingUp)
{
    controller = controllerFrom(kFresh);
    facts.up = false;
    const auto problems = of(Level::Problem);
    ASSERT_EQ(problems.size(), 2U);
    EXPECT_NE(problems[0].cure.english().find("sudo ip link set can0 type can bitrate 500000"),
              std::string::npos);
    EXPECT_EQ(problems[1].cure.english(), "sudo ip link set can0 up");
    controller = controllerFrom(kWorking);
    EXPECT_EQ(finding(Level::Problem).cure.english(), "sudo ip link set can0 up");
}

TEST_F(Checking, reportsBusOffAndManyErrors)
{
    controller.state = "BUS-OFF";
    EXPECT_EQ(finding(Level::Problem).cure.english(),
              "sudo ip link set can0 down; sudo ip link set can0 up");
    controller.state = "ERROR-PASSIVE";
    EXPECT_NE(finding(Level::Warning).what.english().find("ERROR-PASSIVE"), std::string::npos);
    controller = {};
    EXPECT_NE(finding(Level::Warning).what.english().find("not known"), std::string::npos);
}

TEST_F(Checking, warnsOfBuffers)
{
    facts.receiveLimit = 212'992;
    EXPECT_EQ(finding(Level::Warning).cure.english(), "sudo sysctl -w net.core.rmem_max=4194304");
    facts.mayForce = true;
    EXPECT_TRUE(of(Level::Warning).empty());
    facts.sendQueue = 1000;
    EXPECT_EQ(finding(Level::Warning).cure.english(), "sudo ip link set can0 txqueuelen 10");
}

TEST(AControllersDetails, areReadFromTheOutputOfIp)
{
    EXPECT_EQ(controllerFrom(kWorking), (CanController{"ERROR-ACTIVE", 500'000}));
    EXPECT_EQ(controllerFrom(kFresh), (CanController{"STOPPED", std::nullopt}));
    EXPECT_EQ(
        controllerFrom("    can <FD> state ERROR-PASSIVE restart-ms 0\n\t bitrate 1000000 \n"),
        (CanController{"ERROR-PASSIVE", 1'000'000}));
    EXPECT_EQ(controllerFrom(""), CanController{});
    EXPECT_EQ(controllerFrom(" can state"), CanController{});
    EXPECT_EQ(controllerFrom(" bitrate many"), CanController{});
}

}  // namespace
}  // namespace terratact
