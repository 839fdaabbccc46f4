// Tests translated messages.
#include "app/display/translated.h"

#include <gtest/gtest.h>

#include "app/display/format.h"
#include "app/shell/language.h"
#include "core/infer/verdict/verdict.h"
#include "core/learn/data/scene_file.h"
#include "core/robot/robot_model.h"
#include "core/store/csv_reader.h"
#include "core/store/file_read.h"

namespace terratact {
namespace {

TEST(Languages, fileErrorsAreTranslatedAroundTheirNames)
{
    const auto scenes = [](std::string header) {
        return readScenes(*CsvReader::over("scenes.csv", header + "\n1\n")).error().message;
    };
    const Message messages[]{
        robotModelFrom("/home/no 2/robot.toml", "name = 3\n").error().message,
        robotModelFrom("robot.toml", "wheels = 3\n").error().message,
        scenes("colour"),
        scenes("h_9_m"),
        fileError("mine.ttm", TR_NOOP("core", "is empty")).message,
    };
    for (const char* language : {"cs", "de"}) {
        if (installLanguage(*qApp, language) != QLatin1String(language))
            GTEST_SKIP() << "built without translations";
        for (const Message& message : messages) {
            const std::string sentence = message.english();
            const QString translated = terratact::translated(message);
            EXPECT_NE(translated.toStdString(), sentence) << language;
            for (const char* word : {" is ", " not ", "expected", "since", "line "})
                EXPECT_FALSE(translated.contains(QLatin1String(word))) << translated.toStdString();
            for (const char* name : {"/home/no 2/robot.toml", "'h_9_m'", "colour", "mine.ttm"})
                EXPECT_EQ(translated.contains(QLatin1String(name)),
                          sentence.find(name) != std::string::npos)
                    << translated.toStdString();
        }
    }
    installLanguage(*qApp, "en");
}

}  // namespace
}  // namespace terratact
