#include "core/learn/data/scene_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <stdexcept>

#include "core/store/sha256.h"
#include "tests/support/refusal.h"
#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

const std::string kHeader =
    "run,t_s,pitch_rad,front_rad,rear_rad,front_current_a,rear_current_a,force_1_n,force_2_n,force_"
    "3_n,"
    "force_4_n,force_5_n,force_6_n,h_-0.3_m,h_-0.2_m,h_-0.1_m,h_+0.0_m,h_+0.1_m,h_+0.2_m,h_+0.3_m,"
    "h_+0.4_m,h_+0.5_m,h_+0.6_m,h_+0.7_m\n";
const std::string kScene = "box-1,0.5,-0.125,0.3,0.1,1.5,0,1,2,3,4,5,6,-0.24,-0.24,-0.24,-0.24,-0."
                           "24,-0.24,-0.1,-0.05,0,0.04,0.04\n";

Scene sceneOf(const std::string& run, double time = 0.0)
{
    Scene scene;
    scene.run = run;
    scene.time = time;
    return scene;
}

std::vector<std::string> split(const std::string& line)
{
    std::vector<std::string> fields(1);
    for (const char c : line.substr(0, line.size() - 1)) {
        if (c == ',')
            fields.emplace_back();
        else
            fields.back() += c;
    }
    return fields;
}

std::string joined(const std::vector<std::string>& fields)
{
    std::string line;
    for (const std::string& field : fields) line += "," + field;
    return line.substr(1) + "\n";
}

/// kScene with one column changed.
std::string sceneWith(const std::string& column, const std::string& value)
{
    const std::vector<std::string> names = split(kHeader);
    std::vector<std::string> fields = split(kScene);
    fields.at(static_cast<std::size_t>(std::find(names.begin(), names.end(), column)
                                       - names.begin())) = value;
    return joined(fields);
}

struct SceneFileTest : testing::Test {
    Result<SceneFile> read(const std::string& content)
    {
        return readScenes(dir.write("scenes.csv", content));
    }
    testing::AssertionResult refuses(const std::string& content,
                                     std::initializer_list<std::string_view> parts)
    {
        return refused(read(content), dir.file("scenes.csv"), parts);
    }
    TemporaryDirectory dir;
};

class Randomly {
public:
    explicit Randomly(unsigned seed) : rng_(seed) {}
    double within(double least, double most)
    {
        if (rng_() % 8 == 0) return rng_() % 2 ? least : most;
        return std::uniform_real_distribution(least, most)(rng_);
    }
    std::optional<double> perhaps(double least, double most)
    {
        if (rng_() % 4 == 0) return std::nullopt;
        return within(least, most);
    }
    Scene scene()
    {
        constexpr double pi = 3.141592653589793;
        Scene scene = sceneOf("run " + std::to_string(rng_() % 100) + " čeřen", within(-1e9, 1e9));
        scene.s.pitch = within(-pi, pi);
        scene.s.front = within(-pi, pi);
        scene.s.rear = within(-pi, pi);
        scene.s.frontCurrent = perhaps(-100.0, 100.0);
        scene.s.rearCurrent = perhaps(-100.0, 100.0);
        for (auto& force : scene.s.force) force = perhaps(0.0, 1000.0);
        for (auto& height : scene.truth) height = perhaps(-5.0, 5.0);
        return scene;
    }
    std::mt19937_64& rng() { return rng_; }

private:
    std::mt19937_64 rng_;
};

TEST_F(SceneFileTest, everySceneSurvivesARoundTrip)
{
    Randomly randomly(20160204);
    std::vector<Scene> scenes(2000);
    for (Scene& scene : scenes) scene = randomly.scene();
    ASSERT_TRUE(writeScenes(dir.file("scenes.csv"), scenes));
    const Result<SceneFile> read = readScenes(dir.file("scenes.csv"));
    ASSERT_TRUE(read) << read.error().text;
    EXPECT_EQ(read->scenes, scenes);
    EXPECT_TRUE(read->notices.empty());
    EXPECT_EQ(dir.entries(), std::set<std::string>{"scenes.csv"});
}

TEST_F(SceneFileTest, everyColumnFillsTheFieldOfItsName)
{
    const Result<SceneFile> read = this->read(kHeader + kScene);
    ASSERT_TRUE(read) << read.error().text;
    Scene scene = sceneOf("box-1", 0.5);
    scene.s = {.pitch = -0.125, .front = 0.3, .rear = 0.1, .frontCurrent = 1.5, .rearCurrent = 0.0};
    scene.s.force = {1.0, 2.0, 3.0, 4.0, 5.0, 6.0};
    scene.truth = {-0.24, -0.24, -0.24, -0.24, -0.24, -0.24, -0.1, -0.05, 0.0, 0.04, 0.04};
    ASSERT_EQ(read->scenes.size(), 1U);
    EXPECT_EQ(read->scenes[0], scene);
    ASSERT_TRUE(writeScenes(dir.file("again.csv"), {scene}));
    EXPECT_EQ(contentOf(dir.file("again.csv")), kHeader + kScene);
}

TEST_F(SceneFileTest, columnsMayComeInAnyOrder)
{
    const Result<SceneFile> expected = read(kHeader + kScene);
    Randomly randomly(3);
    for (int i = 0; i < 50; ++i) {
        std::vector<std::size_t> order(24);
        for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
        std::shuffle(order.begin(), order.end(), randomly.rng());
        std::vector<std::string> header, scene;
        for (const std::size_t k : order) {
            header.push_back(split(kHeader).at(k));
            scene.push_back(split(kScene).at(k));
        }
        const Result<SceneFile> read = this->read(joined(header) + joined(scene));
        ASSERT_TRUE(read) << read.error().text;
        ASSERT_EQ(read->scenes, expected->scenes);
    }
}

TEST_F(SceneFileTest, takesWindowsLineEnds)
{
    const std::string lines = kHeader + kScene + kScene;
    std::string content;
    for (const char c : lines) {
        if (c == '\n') content += '\r';
        content += c;
    }
    const Result<SceneFile> windows = read(content);
    ASSERT_TRUE(windows) << windows.error().text;
    EXPECT_EQ(windows->scenes, read(kHeader + kScene + kScene)->scenes);
}

TEST_F(SceneFileTest, unknownColumnsAreKeptOutWithANotice)
{
    const Result<SceneFile> read = this->read("weather," + kHeader + "wet," + kScene);
    ASSERT_TRUE(read) << read.error().text;
    ASSERT_EQ(read->notices.size(), 1U);
    EXPECT_NE(read->notices[0].english().find("'weather'"), std::string::npos);
    EXPECT_EQ(read->scenes, this->read(kHeader + kScene)->scenes);
}

TEST_F(SceneFileTest, readsNamesInOtherCaseAndWithBlanksAndSaysSo)
{
    const std::string noBreak = "\xC2\xA0";
    std::string header = kHeader;
    header.replace(header.find("t_s"), 3, "\"" + noBreak + "T_S \"");
    header.replace(header.find("pitch_rad"), 9, noBreak + "pitch_rad" + noBreak);
    header.replace(header.find("h_+0.7_m"), 8, "H_+0.7_M");
    std::string scene = kScene;
    scene.replace(scene.find("0.5"), 3, noBreak + "0.5");
    const auto file = readScenes(dir.write("names.csv", header + scene));
    ASSERT_TRUE(file) << file.error().text;
    EXPECT_EQ(file->scenes.at(0).time, 0.5);
    EXPECT_EQ(file->scenes[0].s.pitch, -0.125);
    EXPECT_EQ(file->scenes[0].truth[10], 0.04);
    ASSERT_EQ(file->notices.size(), 3U);
    EXPECT_NE(file->notices[2].english().find("'H_+0.7_M' was read as h_+0.7_m"), std::string::npos)
        << file->notices[2].english();
}

TEST_F(SceneFileTest, refusesTwoNamesThatMeanOneColumn)
{
    std::string header = kHeader;
    header.replace(header.find("front_current_a"), 15, "Pitch_rad");
    const std::string path = dir.write("twice.csv", header + kScene);
    EXPECT_TRUE(refused(readScenes(path), path, {"line 1", "the column pitch_rad appears twice"}));
}

TEST_F(SceneFileTest, heightsMayBeMissing)
{
    const std::string header = kHeader.substr(0, kHeader.find(",h_")) + "\n";
    const Result<SceneFile> read = this->read(header + "r,0,0,0,0,,,,,,,,\n");
    ASSERT_TRUE(read) << read.error().text;
    EXPECT_EQ(read->scenes.at(0), sceneOf("r"));
}

TEST_F(SceneFileTest, leavesOutScenesOfWhichNoHeightIsKnown)
{
    const std::string unknown(19, ',');
    const std::string blind = "r,0,0,0,0" + unknown + "\n";
    const std::string oneHeight = "r,1,0,0,0" + unknown + "0.1\n";
    const auto known =
        readScenesWithTruth(dir.write("scenes.csv", kHeader + blind + oneHeight + blind));
    ASSERT_TRUE(known) << known.error().text;
    ASSERT_EQ(known->scenes.size(), 1U);
    EXPECT_EQ(known->scenes[0].time, 1.0);
    ASSERT_EQ(known->notices.size(), 1U);
    EXPECT_EQ(known->notices[0].english(), "2 scenes without any known height left out");
    const auto all = readScenesWithTruth(dir.write("scenes.csv", kHeader + oneHeight));
    ASSERT_TRUE(all) << all.error().text;
    EXPECT_TRUE(all->notices.empty());
    EXPECT_TRUE(refused(readScenesWithTruth(dir.write("scenes.csv", kHeader + blind)),
                        dir.file("scenes.csv"), {"no scene has a known height"}));
}

TEST_F(SceneFileTest, anEmptyFieldIsUnknownWhereThatIsAllowed)
{
    for (const char* nothing : {"nan", "NA"})
        EXPECT_EQ(read(kHeader + sceneWith("force_6_n", nothing))->scenes,
                  read(kHeader + sceneWith("force_6_n", ""))->scenes);
    EXPECT_TRUE(refuses(kHeader + sceneWith("pitch_rad", "nan"), {"pitch_rad is not measured"}));
    for (const std::string& name : split(kHeader)) {
        const bool allowed = name.starts_with("h_") || name.starts_with("force")
                          || name.find("current") != std::string::npos;
        const Result<SceneFile> read = this->read(kHeader + sceneWith(name, ""));
        EXPECT_EQ(static_cast<bool>(read), allowed) << name;
        if (!allowed)
            EXPECT_TRUE(
                refuses(kHeader + kScene + sceneWith(name, ""), {"line 3", name, "is empty"}));
        else
            EXPECT_NE(read->scenes, this->read(kHeader + kScene)->scenes) << name;
    }
}

TEST_F(SceneFileTest, refusesMissingDuplicateAndMisspeltColumns)
{
    for (const std::string& name : split(kHeader.substr(0, kHeader.find(",h_")) + "\n")) {
        std::string header = kHeader;
        header.replace(header.find(name), name.size(), "other");
        EXPECT_TRUE(refuses(header + kScene, {"line 1", name + " is missing", "'other'"}));
    }
    for (const std::string& name : split(kHeader))
        EXPECT_TRUE(refuses(joined({name, kHeader}) + kScene, {"line 1", name, "twice"}));
    for (const char* name : {"h_0.3_m", "h_+0.8_m", "h_-0.3", "h_0", "h_+0.3_cm"})
        EXPECT_TRUE(refuses(joined({name, kHeader}), {"line 1", name, "height column"}));
    EXPECT_TRUE(refuses(kScene + kScene, {"line 1", "expected the names of the columns"}));
}

TEST_F(SceneFileTest, refusesWhatIsNotAFiniteNumber)
{
    for (const std::string& name : split(kHeader)) {
        if (name == "run") continue;
        for (const char* value : {"-inf", "Infinity"})
            EXPECT_TRUE(
                refuses(kHeader + kScene + sceneWith(name, value), {"line 3", name, "not finite"}));
        for (const char* value : {"x", "1e999", "0.1.2", "1;2", "0x10", "-"})
            EXPECT_TRUE(refuses(kHeader + kScene + sceneWith(name, value),
                                {"line 3", name, "not a number"}));
    }
}

TEST_F(SceneFileTest, refusesMagnitudesOfOtherUnits)
{
    struct Case {
        const char *column, *inside, *outside, *doubt;
    };
    const Case cases[] = {
        {"pitch_rad", "3.14", "3.15", "degrees"},
        {"front_rad", "-3.14", "-45", "degrees"},
        {"rear_rad", "3.141592653589793", "3.1415927", "degrees"},
        {"front_current_a", "100", "100.5", "mA"},
        {"rear_current_a", "-100", "-1500", "mA"},
        {"force_1_n", "0", "-0.001", "bias"},
        {"force_6_n", "1000", "1000.5", "raw"},
        {"h_-0.3_m", "-5", "-5.01", "mm"},
        {"h_+0.0_m", "5", "240", "mm"},
    };
    for (const Case& c : cases) {
        EXPECT_TRUE(read(kHeader + sceneWith(c.column, c.inside))) << c.column;
        EXPECT_TRUE(refuses(kHeader + kScene + sceneWith(c.column, c.outside),
                            {"line 3", c.column, c.outside, "beyond", c.doubt}));
    }
}

TEST_F(SceneFileTest, refusesTheWrongNumberOfFields)
{
    EXPECT_TRUE(refuses(kHeader + kScene + "x," + kScene, {"line 3", "25 fields", "24"}));
    EXPECT_TRUE(refuses(kHeader + kScene.substr(0, kScene.rfind(',')) + "\n",
                        {"line 2", "23 fields", "24"}));
}

TEST_F(SceneFileTest, refusesAHeaderOfManyColumns)
{
    EXPECT_TRUE(refuses(std::string(200, ',') + "\n", {"line 1", "more than 200 columns"}));
    EXPECT_TRUE(refuses(std::string(1000000, ',') + "\n", {"line 1", "more than 100000 fields"}));
}

TEST_F(SceneFileTest, boundsTheNumberOfScenes)
{
    std::string content = kHeader.substr(0, kHeader.find(",h_-0.3_m")) + "\n";
    for (std::size_t i = 0; i < kMaxScenes; ++i) content += "r,0,0,0,0,,,,,,,,\n";
    const auto most = readScenes(*CsvReader::over("text", content));
    ASSERT_TRUE(most) << most.error().text;
    EXPECT_EQ(most->scenes.size(), kMaxScenes);
    const auto more = readScenes(*CsvReader::over("text", content + "r,0,0,0,0,,,,,,,,\n"));
    EXPECT_TRUE(refused(more, "text", {"line 200002", "one scene more than the 200000"}));
    std::vector<Scene> scenes = most->scenes;
    scenes.push_back(scenes.back());
    EXPECT_THROW(static_cast<void>(scenesText(scenes)), std::invalid_argument);
}

TEST_F(SceneFileTest, refusesTornAndEmptyFiles)
{
    EXPECT_TRUE(refuses("", {"is empty"}));
    EXPECT_TRUE(refuses(kHeader, {"line 1", "no scene"}));
    const std::string whole = kHeader + kScene + kScene;
    const std::size_t lastLine = kHeader.size() + kScene.size();
    const std::size_t lastField = whole.rfind(',') + 1;
    for (std::size_t size = lastLine + 1; size < lastField; ++size)
        ASSERT_TRUE(refuses(whole.substr(0, size), {"line 3", "torn"})) << size;
}

TEST_F(SceneFileTest, readsALastLineWithoutItsEndWithANotice)
{
    const std::string whole = kHeader + kScene + kScene;
    const Result<SceneFile> read = this->read(whole.substr(0, whole.size() - 1));
    ASSERT_TRUE(read) << read.error().text;
    EXPECT_EQ(read->scenes, this->read(whole)->scenes);
    ASSERT_EQ(read->notices.size(), 1U);
    EXPECT_NE(read->notices[0].english().find("no line end"), std::string::npos);
}

TEST_F(SceneFileTest, readsWhatSpreadsheetsAndStatisticsProgramsWrite)
{
    const Result<SceneFile> expected = read(kHeader + kScene);
    const auto with = [](char separator, char point, const std::string& line) {
        std::string text;
        for (const char c : line) text += c == ',' ? separator : c == '.' ? point : c;
        return text;
    };
    std::string named = kHeader, units, quoted;
    for (const std::string& name : split(kHeader)) {
        quoted += (quoted.empty() ? "\"" : ",\"") + name + "\"";
        const std::size_t last = name.rfind('_');
        if (name != "run") units += "," + name.substr(last + 1);
    }
    for (const std::string& text :
         {quoted + "\n" + kScene, kHeader + units + "\n" + kScene, kHeader + "\n" + kScene + "\n\n",
          kHeader + kScene + std::string(23, ',') + "\n",
          with(';', '.', kHeader) + with(';', '.', kScene),
          with('\t', '.', kHeader) + with('\t', ',', kScene),
          "sep=;\n" + with(';', '.', kHeader) + with(';', ',', kScene)}) {
        const Result<SceneFile> read = this->read(text);
        ASSERT_TRUE(read) << read.error().text;
        EXPECT_EQ(read->scenes, expected->scenes) << text;
        EXPECT_TRUE(read->notices.empty()) << read->notices[0].english();
    }
}

TEST_F(SceneFileTest, givesTheHashOfTheBytesThatItRead)
{
    const std::string path = dir.write("scenes.csv", kHeader + kScene);
    EXPECT_EQ(readScenes(path)->hash, *sha256OfFile(path));
}

TEST_F(SceneFileTest, refusesARunWithoutAName)
{
    EXPECT_TRUE(refuses(kHeader + sceneWith("run", ""), {"line 2", "run is empty"}));
    EXPECT_TRUE(refuses(kHeader
                            + sceneWith("run", "a\x1b"
                                               "b"),
                        {"line 2", "not a name"}));
    EXPECT_TRUE(refuses(kHeader + sceneWith("run", "\"a, b\""), {"line 2", "not a name"}));
}

TEST_F(SceneFileTest, everyFileOfBytesIsReadOrRefusedInOneLine)
{
    Randomly randomly(7);
    const std::string whole = kHeader + kScene + kScene;
    for (int i = 0; i < 500; ++i) {
        std::string content = whole;
        for (int changes = 0; changes < 3; ++changes)
            content[randomly.rng()() % content.size()] = static_cast<char>(randomly.rng()());
        const Result<SceneFile> read = this->read(content);
        ASSERT_TRUE(read || refused(read, dir.file("scenes.csv"), {}));
    }
}

TEST_F(SceneFileTest, writesNothingThatItWouldNotRead)
{
    const Scene good = sceneOf("r");
    const auto throwsFor = [&](const Scene& scene) {
        EXPECT_THROW(static_cast<void>(writeScenes(dir.file("out.csv"), {good, scene})),
                     std::invalid_argument);
        EXPECT_FALSE(std::filesystem::exists(dir.file("out.csv")));
    };
    for (const char* run : {"", "a,b", "a\nb", "\"a\""}) throwsFor(sceneOf(run));
    throwsFor(sceneOf(std::string(4097, 'r')));
    Scene scene = good;
    scene.s.pitch = std::numeric_limits<double>::quiet_NaN();
    throwsFor(scene);
    scene = good;
    scene.s.force[2] = -1.0;
    throwsFor(scene);
    scene = good;
    scene.truth[10] = 5.5;
    throwsFor(scene);
    scene = good;
    scene.time = std::numeric_limits<double>::infinity();
    throwsFor(scene);
}

TEST_F(SceneFileTest, namesTheFileThatItCouldNotWrite)
{
    const std::string path = dir.file("none/out.csv");
    EXPECT_TRUE(refused(writeScenes(path, {sceneOf("r")}), path, {"cannot be written"}));
}

TEST_F(SceneFileTest, keepsTheSdOfHeightsAndLeavesItOutWithout)
{
    Scene scene = sceneOf("r");
    scene.truth[3] = 0.1;
    EXPECT_EQ(scenesText({scene}).find("sd_"), std::string::npos);
    scene.truthSd[3] = 0.0125;
    const std::string text = scenesText({sceneOf("r"), scene});
    EXPECT_NE(text.find("h_+0.7_m,sd_+0.0_m\n"), std::string::npos) << text;
    ASSERT_TRUE(writeScenes(dir.file("sd.csv"), {sceneOf("r"), scene}));
    const auto file = readScenes(dir.file("sd.csv"));
    ASSERT_TRUE(file) << file.error().text;
    EXPECT_EQ(file->scenes.at(1), scene);
    EXPECT_TRUE(file->notices.empty());
    scene.truthSd[3] = -0.01;
    EXPECT_THROW((void)scenesText({scene}), std::invalid_argument);
}

}  // namespace
}  // namespace terratact
