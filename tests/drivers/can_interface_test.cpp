#include "drivers/can_interface.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

namespace fs = std::filesystem;

struct Interfaces : testing::Test {
    TemporaryDirectory folder;
    std::string root = folder.file("root");

    void write(const std::string& path, const std::string& content) const
    {
        fs::create_directories(fs::path(root + path).parent_path());
        std::ofstream(root + path) << content << '\n';
    }
    void SetUp() override
    {
        write("/sys/class/net/can0/type", "280");
        write("/sys/class/net/can0/flags", "0x40080");
        write("/sys/class/net/can0/tx_queue_len", "10");
        write("/sys/class/net/can0/device/vendor", "");
        write("/sys/class/net/vcan0/type", "280");
        write("/sys/class/net/vcan0/flags", "0x400c1");
        write("/sys/class/net/lo/type", "772");
        write("/sys/class/net/lo/flags", "0x9");
        write("/proc/sys/net/core/rmem_max", "212992");
        write("/proc/self/status", "Name:\tx\nCapEff:\t0000000000001000");
    }
};

TEST_F(Interfaces, areDescribedByTheFilesOfTheKernel)
{
    EXPECT_EQ(inspectInterface("can0", root), (CanInterfaceFacts{.name = "can0",
                                                                 .present = true,
                                                                 .isCan = true,
                                                                 .isVirtual = false,
                                                                 .up = false,
                                                                 .sendQueue = 10,
                                                                 .receiveLimit = 212'992,
                                                                 .mayForce = true,
                                                                 .others = {"can0", "vcan0"}}));
    const CanInterfaceFacts vcan = inspectInterface("vcan0", root);
    EXPECT_TRUE(vcan.up && vcan.isVirtual && vcan.isCan);
    EXPECT_FALSE(vcan.sendQueue);
    const CanInterfaceFacts lo = inspectInterface("lo", root);
    EXPECT_TRUE(lo.present);
    EXPECT_FALSE(lo.isCan);
}

TEST_F(Interfaces, mayBeAbsentOrImpossible)
{
    EXPECT_FALSE(inspectInterface("can1", root).present);
    for (const char* name :
         {"", ".", "..", "can0/../can0", "can0;ls", "a-name-of-16-byte", "can 0"})
        EXPECT_FALSE(inspectInterface(name, root).present) << name;
    const CanInterfaceFacts nothing = inspectInterface("can0", folder.file("none"));
    EXPECT_EQ(nothing, (CanInterfaceFacts{
                           .name = "can0", .sendQueue = {}, .receiveLimit = {}, .others = {}}));
}

TEST_F(Interfaces, survivesFilesThatHoldSomethingElse)
{
    write("/sys/class/net/can0/type", "two");
    write("/proc/sys/net/core/rmem_max", "");
    write("/proc/self/status", "CapEff:");
    const CanInterfaceFacts facts = inspectInterface("can0", root);
    EXPECT_TRUE(facts.present);
    EXPECT_FALSE(facts.isCan);
    EXPECT_FALSE(facts.receiveLimit);
    EXPECT_FALSE(facts.mayForce);
}

TEST(ALinksDetails, areEmptyForAnInvalidName)
{
    EXPECT_EQ(linkDetails("lo; echo can state"), "");
    EXPECT_EQ(linkDetails("terratact-none"), "");
}

}  // namespace
}  // namespace terratact
