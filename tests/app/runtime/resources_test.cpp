// Tests that shipped files are found beside the program.
#include "app/runtime/resources.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace terratact {
namespace {

TEST(Resources, lieBesideTheFolderOfTheProgram)
{
    const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe");
    const std::filesystem::path path = resourcePath("robots/absolem.toml");
    EXPECT_TRUE(path.is_absolute());
    EXPECT_EQ(path.lexically_relative(program.parent_path()).string(),
              "../share/terratact/robots/absolem.toml");
}

}  // namespace
}  // namespace terratact
