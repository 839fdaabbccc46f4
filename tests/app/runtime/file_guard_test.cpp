// Tests that no command overwrites what it reads, or writes two results to one file.
#include "app/runtime/file_guard.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <string>

#include "tests/support/refusal.h"
#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

struct FileGuard : testing::Test {
    TemporaryDirectory directory;
    std::string in = directory.write("in.csv", "data");
    std::string out = directory.file("out.csv");
};

TEST_F(FileGuard, acceptsDifferentFiles)
{
    EXPECT_TRUE(checkCommandFiles({{in}, {}, {out}, {}}));
}

TEST_F(FileGuard, refusesToWriteAnInputUnderAnyName)
{
    EXPECT_TRUE(refused(checkCommandFiles({{in}, {}, {in}, {}}), in,
                        {"is read by this command", "name another file"}));
    const std::string soft = directory.file("soft.csv"), hard = directory.file("hard.csv");
    std::filesystem::create_symlink(in, soft);
    std::filesystem::create_hard_link(in, hard);
    for (const std::string& link : {soft, hard})
        EXPECT_TRUE(refused(checkCommandFiles({{in}, {}, {link}, {}}), link,
                            {"is the same file as " + in}));
    EXPECT_EQ(contentOf(in), "data");
}

TEST_F(FileGuard, refusesToOverwriteACompanionOfAnInput)
{
    const std::string card = directory.write("in.card.toml", "");
    EXPECT_FALSE(checkCommandFiles({{in}, {card}, {card}, {}}));
    EXPECT_TRUE(checkCommandFiles({{in}, {card}, {}, {card}})) << "an update may write it";
}

TEST_F(FileGuard, refusesTwoOutputsInOneFile)
{
    const std::string detour = directory.file("sub/../out.csv");
    std::filesystem::create_directory(directory.file("sub"));
    EXPECT_TRUE(refused(checkCommandFiles({{}, {}, {out, detour}, {}}), detour,
                        {"is the same file as " + out, "both are written"}))
        << "neither exists yet";
}

TEST_F(FileGuard, refusesAWriteProtectedOutput)
{
    directory.write("out.csv", "kept");
    ::chmod(out.c_str(), 0444);
    EXPECT_FALSE(checkCommandFiles({{in}, {}, {out}, {}}));
}

TEST_F(FileGuard, onlyASessionHasTheNameOfOne)
{
    for (const char* const name : {"new.tts", "NEW.TTS"}) {
        const std::string session = directory.file(name);
        EXPECT_TRUE(refused(checkCommandFiles({{in}, {}, {session}, {}}), session,
                            {"ends in .tts, as sessions do, and is none"}));
        EXPECT_TRUE(checkCommandFiles({{in}, {}, {session}, {}, {session}}));
    }
}

TEST_F(FileGuard, aModelHasACardAndASessionHasNotes)
{
    const std::string model = TERRATACT_SOURCE_DIR "/resources/models/default.ttm";
    EXPECT_EQ(companionsOf(model),
              Paths{TERRATACT_SOURCE_DIR "/resources/models/default.card.toml"});
    const std::string session = TERRATACT_SOURCE_DIR "/resources/sessions/demo.tts";
    EXPECT_EQ(companionsOf(session), (Paths{session + ".notes.csv", session + "-wal"}));
    EXPECT_TRUE(companionsOf(in).empty());
}

}  // namespace
}  // namespace terratact
