// Tests that a new file gets a free name.
#include "app/shell/new_file.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

struct NewFiles : testing::Test {
    QString path(const std::string& name) const
    {
        return QString::fromStdString(directory.file(name));
    }
    void make(const std::string& name) const { std::ofstream(directory.file(name)) << "it"; }
    TemporaryDirectory directory;
};

TEST_F(NewFiles, keepAFreeName)
{
    EXPECT_EQ(newFile(path("terrain.png")), path("terrain.png"));
}

TEST_F(NewFiles, getTheFirstFreeNumber)
{
    make("terrain.png");
    EXPECT_EQ(newFile(path("terrain.png")), path("terrain-2.png"));
    make("terrain-2.png");
    EXPECT_EQ(newFile(path("terrain.png")), path("terrain-3.png"));
    make("a.b.csv");
    EXPECT_EQ(newFile(path("a.b.csv")), path("a.b-2.csv"));
    make("noEnding");
    EXPECT_EQ(newFile(path("noEnding")), path("noEnding-2"));
}

TEST_F(NewFiles, doNotFollowALinkThatLeadsNowhere)
{
    std::filesystem::create_symlink(directory.file("nowhere"), directory.file("terrain.png"));
    EXPECT_EQ(newFile(path("terrain.png")), path("terrain-2.png"));
}

}  // namespace
}  // namespace terratact
