// Tests that preferences are restored as saved, and that no preferences file prevents a start.
#include "app/shell/preferences/preferences.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>

#include "tests/support/bytes/messages.h"
#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

const Preferences kDefaults;

struct PreferencesFile : testing::Test {
    QString path() const { return QString::fromStdString(directory.file("terratact/console.ini")); }
    LoadedPreferences loadText(const std::string& content) const
    {
        std::filesystem::create_directories(directory.file("terratact"));
        return loadPreferences(
            QString::fromStdString(directory.write("terratact/console.ini", content)));
    }
    TemporaryDirectory directory;
};

Preferences unlikeTheDefaults()
{
    Preferences p;
    p.theme = ThemeName::NightRed;
    p.fontScale = 130;
    p.language = "cs";
    p.units = {LengthUnit::Centimetre, AngleUnit::Radian};
    p.layout = Layout::Review;
    p.sound = false;
    p.contactSound = 20;
    p.obstacleLimit = 0.1 + 0.2;  // has no short decimal form
    p.method = Method::Joint;
    p.preset = QualityPreset::Accurate;
    p.estimateSeconds = 5;
    p.forceThreshold = 3.5;
    p.probes = ProbePolicy::Question;
    p.probeAbove = 0.05;
    p.rollLimit = 0.2;
    p.asymmetryLimit = 0.3;
    p.tiltAmber = 0.4;
    p.tiltRed = 0.5;
    p.record = false;
    p.keepDays = 30;
    p.keepGigabytes = 7;
    p.mayDelete = true;
    p.model = QString::fromUtf8("/data/žluťoučký model, 2 = @Variant(x)\\%41;#.ttm");
    p.robot = "@robot.toml";
    p.dbc = QStringList{QString::fromUtf8("/data/p\u0159\u00edklad, 1.dbc"), "b;c.dbc"};
    p.pad.mapping.assign(PadAction::Explore, PadButton::Y);
    p.pad.deadZone = 0.25;
    p.pad.speedLimit = 0.1 + 0.2;
    p.sessionFolder = "/data/drives";
    p.window = QByteArray("\0\xff\n=;geometry", 13);
    return p;
}

TEST_F(PreferencesFile, isNotThereAtTheFirstStart)
{
    const LoadedPreferences loaded = loadPreferences(path());
    EXPECT_EQ(loaded.preferences, kDefaults);
    EXPECT_TRUE(loaded.troubles.empty());
    EXPECT_EQ(loaded.path, path());
}

TEST_F(PreferencesFile, givesBackEveryValue)
{
    EXPECT_FALSE(savePreferences(path(), unlikeTheDefaults()));
    const LoadedPreferences loaded = loadPreferences(path());
    EXPECT_TRUE(loaded.troubles.empty());
    EXPECT_TRUE(loaded.preferences == unlikeTheDefaults());
    EXPECT_FALSE(savePreferences(path(), kDefaults));
    EXPECT_TRUE(loadPreferences(path()).preferences == kDefaults)
        << "a second save replaces the first";
}

TEST_F(PreferencesFile, isNotSavedThroughASymbolicLink)
{
    const std::string victim = directory.write("victim", "mine");
    std::filesystem::create_directories(directory.file("terratact"));
    std::filesystem::create_symlink(victim, path().toStdString());
    const auto trouble = savePreferences(path(), unlikeTheDefaults());
    ASSERT_TRUE(trouble);
    EXPECT_NE(trouble->english().find("it is a symbolic link to " + victim), std::string::npos)
        << trouble->english();
    EXPECT_EQ(contentOf(victim), "mine");
}

TEST_F(PreferencesFile, whoseFolderCannotBeMadeIsNamedInOneSentence)
{
    const auto trouble = savePreferences("/proc/terratact/console.ini", kDefaults);
    ASSERT_TRUE(trouble);
    EXPECT_TRUE(trouble->english().starts_with(
        "Preferences: /proc/terratact: the directory cannot be made: "))
        << trouble->english();
    EXPECT_TRUE(trouble->english().ends_with("; nothing is saved")) << trouble->english();
}

TEST_F(PreferencesFile, isInAFolderForItsUserAlone)
{
    EXPECT_FALSE(savePreferences(path(), kDefaults));
    struct stat folder {};
    ASSERT_EQ(::stat(directory.file("terratact").c_str(), &folder), 0);
    EXPECT_EQ(folder.st_mode & 07777U, 0700U);
}

TEST(PreferencesRecord, namesEveryKeyThatChangesAndNoOther)
{
    Preferences now = kDefaults;
    EXPECT_EQ(changesOf(kDefaults, now), QString());
    now.window = "geometry";
    EXPECT_EQ(changesOf(kDefaults, now), QString()) << "nobody decided that";
    now.preset = QualityPreset::Fast;
    now.rollLimit = 0.125;
    now.sound = false;
    EXPECT_EQ(changesOf(kDefaults, now).section("; ", 0, 0), "sound: true → false");
    const QString all = changesOf(kDefaults, unlikeTheDefaults());
    for (const char* key : {"theme",
                            "font-scale",
                            "language",
                            "length-unit",
                            "angle-unit",
                            "layout",
                            "sound",
                            "obstacle-limit",
                            "method",
                            "quality",
                            "estimate-seconds",
                            "force-threshold",
                            "probe-policy",
                            "probe-above",
                            "roll-limit",
                            "asymmetry-limit",
                            "tilt-amber",
                            "tilt-red",
                            "record",
                            "keep-days",
                            "keep-gigabytes",
                            "model",
                            "robot",
                            "dbc",
                            "gamepad",
                            "gamepad-dead-zone",
                            "gamepad-speed"})
        EXPECT_TRUE(all.contains(QLatin1String(key) + ": ")) << key;
    EXPECT_TRUE(changesOf(kDefaults, now).contains("quality: balanced → fast; ")
                && changesOf(kDefaults, now).endsWith(" → 0.125"));
}

TEST_F(PreferencesFile, safeModeReadsAndWritesNothing)
{
    const LoadedPreferences loaded = loadPreferences(QString());
    EXPECT_EQ(loaded.preferences, kDefaults);
    EXPECT_FALSE(savePreferences(loaded.path, unlikeTheDefaults()));
    EXPECT_TRUE(directory.entries().empty());
}

TEST_F(PreferencesFile, aBadValueBecomesItsDefaultAndIsReported)
{
    const std::pair<const char*, const char*> cases[]{
        {"theme", "purple"},
        {"theme", ""},
        {"font-scale", "79"},
        {"font-scale", "201"},
        {"font-scale", "1e2"},
        {"font-scale", "99999999999999999999"},
        {"language", "tlh"},
        {"layout", "Drive "},
        {"sound", "1"},
        {"obstacle-limit", "nan"},
        {"obstacle-limit", "inf"},
        {"obstacle-limit", "0,10"},
        {"obstacle-limit", "1e300"},
        {"obstacle-limit", "-0.1"},
        {"method", "7"},
        {"quality", "best"},
        {"force-threshold", "0"},
        {"dbc", "a\\x0"},
        {"gamepad", "stop:a stop:b"},
        {"gamepad", "explore:a"},
        {"gamepad", ""},  // not after a line of its length: QSettings takes such files for one
        {"gamepad-dead-zone", "0"},
        {"gamepad-speed", "0.7"},
        {"probe-above", "@Variant(\\0\\0\\0\\x7f\\xff\\xff\\xff\\xff)"},
        {"roll-limit", "@Invalid()"},
        {"asymmetry-limit", "\"\""},
        {"model", "a, b"},
        {"robot", "x\\x0y"},
        {"window", "%%%"},
    };
    for (const auto& [key, value] : cases) {
        const LoadedPreferences loaded =
            loadText("[General]\nschema=1\n" + std::string(key) + "=" + value + "\n");
        EXPECT_TRUE(loaded.preferences == kDefaults) << key << "=" << value;
        ASSERT_EQ(loaded.troubles.size(), 1U) << key << "=" << value;
        EXPECT_TRUE(mentions(loaded.troubles.front(), key))
            << key << "=" << value << ": " << loaded.troubles.front().english();
        EXPECT_EQ(loaded.path, path()) << "the file may be replaced";
    }
}

TEST_F(PreferencesFile, oneBadValueLeavesTheOthers)
{
    const LoadedPreferences loaded =
        loadText("[General]\nschema=1\ntheme=night-red\nfont-scale=1000\nsound=false\nunknown=3\n");
    Preferences expected;
    expected.theme = ThemeName::NightRed;
    expected.sound = false;
    EXPECT_TRUE(loaded.preferences == expected);
    EXPECT_EQ(loaded.troubles.size(), 1U);
}

TEST_F(PreferencesFile, anUnreadableFileIsRenamed)
{
    std::string noise;
    for (int i = 0; i < 4096; ++i) noise += static_cast<char>((i * 7919 + i / 3) & 0xff);
    const std::string bad[]{noise,
                            "no section and no schema",
                            "[General\nschema=1\n",
                            "[General]\nschema=0\n",
                            "[General]\nschema=one\n",
                            std::string(2 << 20, 'x'),
                            std::string(100, '\0'),
                            "SQLite format 3"};
    for (const std::string& content : bad) {
        const LoadedPreferences loaded = loadText(content);
        EXPECT_TRUE(loaded.preferences == kDefaults);
        ASSERT_EQ(loaded.troubles.size(), 1U) << content.substr(0, 40);
        EXPECT_EQ(contentOf(path().toStdString() + ".bad"), content)
            << "kept for who wants to look";
        EXPECT_FALSE(std::filesystem::exists(path().toStdString()));
        EXPECT_FALSE(savePreferences(loaded.path, unlikeTheDefaults()));
        EXPECT_TRUE(loadPreferences(path()).preferences == unlikeTheDefaults());
    }
}

TEST_F(PreferencesFile, anEmptyFileIsNoSchemaEither)
{
    const LoadedPreferences loaded = loadText("");
    EXPECT_TRUE(loaded.preferences == kDefaults);
    EXPECT_EQ(loaded.troubles.size(), 1U);
}

TEST_F(PreferencesFile, aNewerSchemaIsLeftAlone)
{
    const std::string newer = "[General]\nschema=3\ntheme=night-red\n";
    const LoadedPreferences loaded = loadText(newer);
    EXPECT_TRUE(loaded.preferences == kDefaults);
    ASSERT_EQ(loaded.troubles.size(), 1U);
    EXPECT_TRUE(mentions(loaded.troubles.front(), "newer"));
    EXPECT_FALSE(savePreferences(loaded.path, unlikeTheDefaults()));
    EXPECT_EQ(contentOf(path().toStdString()), newer);
}

TEST_F(PreferencesFile, theOldDefaultMethodBecomesTheNewOne)
{
    const LoadedPreferences old = loadText("[General]\nschema=1\nmethod=local\n");
    EXPECT_EQ(old.preferences.method, Method::Trail);
    ASSERT_EQ(old.troubles.size(), 1U);
    EXPECT_TRUE(mentions(old.troubles.front(), "trail")) << old.troubles.front().english();
    const QString saved = QString::fromStdString(directory.file("saved.ini"));
    EXPECT_FALSE(savePreferences(saved, old.preferences));
    EXPECT_TRUE(loadPreferences(saved).troubles.empty()) << "said once";
    const auto loadedFrom = [&](const std::string& name, const std::string& lines) {
        // a new file each time, because QSettings caches what it has read
        return loadPreferences(
            QString::fromStdString(directory.write(name, "[General]\n" + lines)));
    };
    EXPECT_EQ(loadedFrom("joint.ini", "schema=1\nmethod=joint\n").preferences.method, Method::Joint)
        << "it was chosen";
    const LoadedPreferences chosen = loadedFrom("local.ini", "schema=2\nmethod=local\n");
    EXPECT_EQ(chosen.preferences.method, Method::Local);
    EXPECT_TRUE(chosen.troubles.empty());
}

TEST_F(PreferencesFile, aFolderOrAPipeInItsPlaceIsReported)
{
    std::filesystem::create_directories(path().toStdString());
    const LoadedPreferences folder = loadPreferences(path());
    EXPECT_EQ(folder.troubles.size(), 1U);
    EXPECT_EQ(folder.path, QString());
    const std::string pipe = directory.file("pipe.ini");
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    EXPECT_EQ(loadPreferences(QString::fromStdString(pipe)).troubles.size(), 1U)
        << "and it returned";
}

TEST_F(PreferencesFile, failureToWriteIsReported)
{
    directory.write("terratact", "a file where the folder should be");
    EXPECT_TRUE(savePreferences(path(), kDefaults));
    EXPECT_EQ(loadPreferences(path()).preferences, kDefaults);
}

TEST(Preferences, settleWhatAnEstimateIsMadeWith)
{
    const Preferences p = unlikeTheDefaults();
    Settings base;
    base.seed = 42;
    const Settings settings = withPreferences(base, p);
    EXPECT_EQ(settings.seed, 42U);
    EXPECT_EQ(settings.method, Method::Joint);
    EXPECT_EQ(settings.draws, withPreset(base, QualityPreset::Accurate).draws);
    EXPECT_EQ(settings.forceThreshold, 3.5);
    EXPECT_EQ(settings.probeAbove, 0.05);
    EXPECT_EQ(settings.rollLimit, 0.2);
    EXPECT_EQ(settings.asymmetryLimit, 0.3);
    Settings defaults = withPreset(Settings{}, QualityPreset::Balanced);
    EXPECT_EQ(defaults.method, Method::Local) << "of commands for single scenes";
    defaults.method = Method::Trail;
    EXPECT_EQ(withPreferences(Settings{}, Preferences{}), defaults);
}

TEST(Preferences, lieInTheUsersConfigurationFolder)
{
    qputenv("XDG_CONFIG_HOME", "/some/where");
    EXPECT_EQ(preferencesPath(), "/some/where/terratact/console.ini");
    qunsetenv("XDG_CONFIG_HOME");
    const QByteArray home = qgetenv("HOME");
    qputenv("HOME", "relative");
    EXPECT_FALSE(preferencesPath().startsWith("relative")) << "not in the working directory";
    qputenv("HOME", home);
}

}  // namespace
}  // namespace terratact
