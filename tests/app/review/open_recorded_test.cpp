// Tests how the kind of a file is recognized.
#include "app/review/open_recorded.h"

#include <gtest/gtest.h>

#include "app/shell/open_file.h"
#include "core/store/file_write.h"
#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

TEST(KindOfFile, isRecognizedByItsContent)
{
    TemporaryDirectory directory;
    const std::string session = directory.file("a.log");
    {
        auto writer = someSession(session, 200);
        ASSERT_TRUE(writer);
        ASSERT_TRUE(writer->seal());
    }
    EXPECT_EQ(kindOfFile(QString::fromStdString(session)), FileKind::Session);
    const std::string scenes = directory.file("a.tts");
    ASSERT_TRUE(writeFileAtomically(scenes, "run,t_s,pitch_rad,front_rad\n"));
    EXPECT_EQ(kindOfFile(QString::fromStdString(scenes)), FileKind::Scenes);
    const std::string log = directory.file("b.tts");
    ASSERT_TRUE(writeFileAtomically(log, "(1.0) can0 100#00\n"));
    EXPECT_EQ(kindOfFile(QString::fromStdString(log)), FileKind::Log);
    EXPECT_EQ(kindOfFile("/nowhere/x"), FileKind::Log);
}

}  // namespace
}  // namespace terratact
