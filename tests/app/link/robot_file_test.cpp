// Tests that a robot file is read once and hashed as it was read.
#include "app/link/robot_file.h"

#include <gtest/gtest.h>

#include "core/store/sha256.h"
#include "tests/support/refusal.h"
#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

TEST(RobotFile, hashAndModelAreThoseOfTheText)
{
    const std::string path = TERRATACT_SOURCE_DIR "/resources/robots/absolem.toml";
    const auto file = readRobotFile(path);
    ASSERT_TRUE(file) << file.error().text;
    EXPECT_EQ(file->path, path);
    EXPECT_EQ(file->text, contentOf(path));
    EXPECT_EQ(file->hash, *sha256OfFile(path));
    EXPECT_EQ(file->model.name, readRobotModel(path)->name);
}

TEST(RobotFile, errorsNameTheFile)
{
    const TemporaryDirectory directory;
    const std::string none = directory.file("none.toml");
    EXPECT_TRUE(refused(readRobotFile(none), none, {"cannot be opened"}));
    const std::string other = directory.write("other.toml", "wheels = 3\n");
    EXPECT_TRUE(refused(readRobotFile(other), other, {}));
    const std::string large = directory.write("large.toml", std::string((1U << 20U) + 1U, ' '));
    EXPECT_TRUE(refused(readRobotFile(large), large, {"larger"}));
}

}  // namespace
}  // namespace terratact
