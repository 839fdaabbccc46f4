// Tests that files of settings give every value back, and that broken, foreign and newer files are refused.
#include "app/shell/preferences/settings_file.h"

#include <gtest/gtest.h>

#include <QFileInfo>

#include "app/shell/preferences/preference_text.h"
#include "app/shell/preferences/preference_values.h"
#include "core/store/file_read.h"
#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

const std::string kHead = "terratact-settings = 1\n";

std::string refusalOf(const std::string& content)
{
    const auto read = readSettings(content, "night.settings");
    return read ? std::string("accepted") : read.error().text;
}

Preferences another()
{
    Preferences p;
    p.theme = ThemeName::NightRed;
    p.obstacleLimit = 0.1 + 0.2;  // has no short decimal form
    p.tiltRed = 0.5;
    p.mayDelete = true;
    p.pad.speedLimit = 0.25;
    p.plotSets = QStringList{"one", "two"};
    p.window = QByteArray("geometry");
    return p;
}

TEST(SettingsFile, givesBackEveryValue)
{
    const auto read = readSettings(settingsText(another(), SettingsScope::Anywhere), "x");
    ASSERT_TRUE(read) << read.error().text;
    Preferences expected = another();
    expected.window.clear();
    EXPECT_TRUE(withSettings(Preferences{}, *read) == expected);
}

TEST(SettingsFile, namesItsUnitsAndIsReadable)
{
    const std::string text = settingsText(another(), SettingsScope::Anywhere);
    EXPECT_NE(text.find("\nterratact-settings = 1\n"), std::string::npos) << text;
    EXPECT_NE(text.find("\nobstacle-limit = 0.30000000000000004 m\n"), std::string::npos) << text;
    EXPECT_NE(text.find("\ntilt-red = 0.5 rad\n"), std::string::npos) << text;
    EXPECT_NE(text.find("\nplot-sets = one\nplot-sets = two\n"), std::string::npos) << text;
}

TEST(SettingsFile, ofAnywhereHoldsNoPlaceOfThisComputer)
{
    const TemporaryDirectory directory;
    const QString file = QString::fromStdString(directory.write("own.toml", "x"));
    Preferences p;
    p.robot = p.model = file;
    p.dbc = QStringList{file};
    const std::string anywhere = settingsText(p, SettingsScope::Anywhere);
    EXPECT_EQ(anywhere.find(file.toStdString()), std::string::npos) << anywhere;
    EXPECT_EQ(anywhere.find("\nwindow"), std::string::npos);
    const auto own = readSettings(settingsText(p, SettingsScope::ThisComputer), "x");
    ASSERT_TRUE(own) << own.error().text;
    EXPECT_TRUE(withSettings(Preferences{}, *own) == p);
}

TEST(SettingsFile, keepsWhatItLeavesOut)
{
    const auto read = readSettings(kHead + "# a remark\n\n  obstacle-limit=0.2 m\r\n", "x");
    ASSERT_TRUE(read) << read.error().text;
    Preferences expected = another();
    expected.obstacleLimit = 0.2;
    EXPECT_TRUE(withSettings(another(), *read) == expected);
}

TEST(SettingsFile, isRefusedWithLineAndWhatWasExpected)
{
    EXPECT_EQ(refusalOf("hello\n"),
              "night.settings: line 1: this is no file of settings; expected first: "
              "terratact-settings = 1");
    EXPECT_EQ(refusalOf(""), refusalOf("hello"));
    EXPECT_EQ(refusalOf("# x\nterratact-settings = 2\n"),
              "night.settings: line 2: version 2 is of a newer Terratact; expected: version 1. "
              "Update this program, or export the settings from its version");
    EXPECT_EQ(
        refusalOf(kHead + "obstacle-limit = 10 cm\n"),
        "night.settings: line 2: “10 cm” is no valid obstacle-limit; expected: a number in m");
    EXPECT_EQ(refusalOf(kHead + "obstacle-limit = 9 m\n"),
              "night.settings: line 2: “9 m” is no valid obstacle-limit; expected: a number from "
              "0.02 m to 0.6 m");
    EXPECT_EQ(refusalOf(kHead + "theme = purple"),
              "night.settings: line 2: “purple” is no valid theme; expected: one of day, "
              "night-red, high-contrast");
    EXPECT_EQ(refusalOf(kHead + "sound = true\nsound = false"),
              "night.settings: line 3: sound appears twice; expected: once");
    EXPECT_EQ(refusalOf(kHead + "speed = 4"),
              "night.settings: line 2: “speed” is no setting; expected: a setting of this version");
    EXPECT_EQ(refusalOf(kHead + "nonsense"),
              "night.settings: line 2: “nonsense” is no setting; expected: key = value");
    EXPECT_EQ(
        refusalOf(kHead + "window = AAAA"),
        "night.settings: line 2: “window” is no setting; expected: a setting of this version");
    EXPECT_EQ(
        refusalOf(kHead + "robot = /nowhere/robot.toml"),
        "night.settings: line 2: “/nowhere/robot.toml” is no valid robot; expected: a file of "
        "this computer");
    EXPECT_EQ(refusalOf(kHead + "theme = \xff\n"),
              "night.settings: line 2: this is no text; expected: UTF-8");
    EXPECT_EQ(refusalOf(kHead + "obstacle-limit = nan m\n"),
              "night.settings: line 2: “nan m” is no valid obstacle-limit; expected: a number from "
              "0.02 m to 0.6 m");
}

TEST(SettingsFile, replacesNothingUnasked)
{
    const TemporaryDirectory directory;
    const std::string path = directory.file("a.settings");
    ASSERT_TRUE(writeSettings(path, another(), SettingsScope::Anywhere));
    const std::string before = *readFile(path, 1U << 20U);
    const Status again = writeSettings(path, Preferences{}, SettingsScope::Anywhere);
    ASSERT_FALSE(again);
    EXPECT_NE(again.error().text.find("the file exists"), std::string::npos) << again.error().text;
    EXPECT_EQ(*readFile(path, 1U << 20U), before);
    EXPECT_TRUE(writeSettings(path, Preferences{}, SettingsScope::Anywhere, true));
    EXPECT_NE(*readFile(path, 1U << 20U), before);
}

TEST(SettingsFile, ofAProfileHasAnyNameButNoPath)
{
    const TemporaryDirectory directory;
    const QString folder = QString::fromStdString(directory.file("profiles"));
    for (const QString& name : {QStringLiteral("robot A/night"), QStringLiteral(".."),
                                QString::fromUtf8("žlutý 100 %")}) {
        const QString path = profilePath(folder, name);
        EXPECT_EQ(QFileInfo(path).path(), folder) << path.toStdString();
        EXPECT_TRUE(writeSettings(path.toStdString(), another(), SettingsScope::ThisComputer));
    }
    EXPECT_EQ(profilesIn(folder).size(), 3);
    EXPECT_TRUE(profilesIn(folder).contains(QStringLiteral("robot A/night")));
    EXPECT_TRUE(whyNoProfileName(QString()));
    EXPECT_TRUE(whyNoProfileName(QStringLiteral("a\nb")));
    EXPECT_TRUE(whyNoProfileName(QString(61, QLatin1Char('x'))));
    EXPECT_FALSE(whyNoProfileName(QStringLiteral("robot A/night")));
}

TEST(PreferenceText, namesEverySettingAndPutsSafetyFirst)
{
    for (const PreferenceValue& value : valuesOf(Preferences{})) {
        const QString key = QLatin1String(value.key);
        EXPECT_EQ(preferenceLabel(key).isEmpty(),
                  key == QLatin1String("window") || key == QLatin1String("session-folder"))
            << value.key;
    }
    const auto changes = changesBetween(Preferences{}, another());
    ASSERT_EQ(changes.size(), 6U);
    EXPECT_EQ(changes[0].label, "step limit");
    EXPECT_EQ(changes[0].before, "0.1 m");
    EXPECT_TRUE(changes[3].isSafety);
    EXPECT_FALSE(changes[4].isSafety);
    EXPECT_TRUE(changesBetween(another(), another()).empty());
}

TEST(PreferenceText, namesEveryChangedActionOfTheGamepad)
{
    Preferences now;
    now.pad.mapping = *PadMapping::parse(
        "stop:rightshoulder dead-man:righttrigger drive:lefty+ feel-forward:lefttrigger explore:x "
        "approve:b refuse:a raise-limit:dpup lower-limit:dpdown");
    const auto changes = changesBetween(Preferences{}, now);
    QStringList lines;
    for (const PreferenceChange& change : changes) {
        EXPECT_TRUE(change.isSafety) << change.label.toStdString();
        lines << change.label + ": " + change.before + " → " + change.now;
    }
    EXPECT_EQ(lines, (QStringList{
                         "gamepad: STOP, second control: Back → none",
                         "gamepad: drive: left stick, up and down, forward − → left stick, up and "
                         "down, forward +",
                         "gamepad: approve the probe (hold): A (lower) → B (right)",
                         "gamepad: refuse the probe: B (right) → A (lower)"}))
        << lines.join("\n").toStdString();
}

TEST(PreferenceText, longPathsShowWhereTheyDiffer)
{
    const QString folder = "/home/operator" + QString("/robots of the team").repeated(8);
    Preferences before, now;
    before.robot = folder + "/a.toml";
    now.robot = folder + "/b.toml";
    before.model = "/" + QString(300, 'x') + "a.model";
    now.model = "/" + QString(300, 'x') + "b" + QString(400, 'y') + ".model";
    const auto changes = changesBetween(before, now);
    ASSERT_EQ(changes.size(), 2U);
    EXPECT_EQ(changes[0].before, "…" + QString(20, 'x') + "a.model");
    EXPECT_TRUE(changes[0].now.startsWith("…" + QString(20, 'x') + "by"));
    EXPECT_TRUE(changes[0].now.endsWith("y.model"));
    EXPECT_EQ(changes[0].now.size(), 200);
    EXPECT_EQ(changes[1].before, "…/a.toml");
    EXPECT_EQ(changes[1].now, "…/b.toml");
}

}  // namespace
}  // namespace terratact
