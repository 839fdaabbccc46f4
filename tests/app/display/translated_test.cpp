// Tests messages in the languages of operators.
#include "app/display/translated.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <cerrno>
#include <string>

#include "app/display/format.h"
#include "app/display/units.h"
#include "app/mission/text/bus_text.h"
#include "app/start/language.h"
#include "core/atem/arming.h"
#include "core/atem/command_gate.h"
#include "core/atem/following.h"
#include "core/atem/loop_end.h"
#include "core/atem/panel.h"
#include "core/infer/estimate/quality_preset.h"
#include "core/infer/verdict/estimate_text.h"
#include "core/infer/verdict/verdict.h"
#include "core/learn/data/scene_file.h"
#include "core/robot/force_sensor.h"
#include "core/robot/robot_model.h"
#include "core/robot/watch/sensor_suspicion.h"
#include "core/store/csv_reader.h"
#include "core/store/file_read.h"
#include "drivers/gpio_chip.h"
#include "tests/support/estimates.h"

namespace terratact {
namespace {

/// Adds describe() of every enumerator from 0 to `last`; describe() knows none beyond it.
template <class Enum>
void addAllTo(std::vector<Message>& messages, Enum last)
{
    for (int i = 0; i <= static_cast<int>(last); ++i)
        messages.emplace_back(describe(static_cast<Enum>(i)));
    EXPECT_THROW((void)describe(static_cast<Enum>(static_cast<int>(last) + 1)),
                 std::invalid_argument)
        << messages.back().english() << " is not the last";
}

/// Returns what the core says of states, sensors and estimates.
std::vector<Message> coreMessages()
{
    std::vector<Message> messages;
    addAllTo(messages, AtemPhase::Advancing);
    addAllTo(messages, AtemFailure::BeginTimeout);
    addAllTo(messages, LoopEnd::NoOdometry);
    addAllTo(messages, DisarmCause::EpochChanged);
    addAllTo(messages, GateRefusal::OtherBin);
    addAllTo(messages, WithholdReason::Contradiction);
    addAllTo(messages, RobotActivity::Stopped);
    addAllTo(messages, Refusal::OutOfLimits);
    addAllTo(messages, StepVerdict::CannotTell);
    addAllTo(messages, QualityPreset::Accurate);
    for (int i = 1; i <= static_cast<int>(ElementState::Short); ++i)  // Sound has no translation
        messages.emplace_back(describe(static_cast<ElementState>(i)));
    for (int i = 0; i <= static_cast<int>(AtemPhase::Advancing); ++i)
        messages.emplace_back(describeFollowed(static_cast<AtemPhase>(i)));
    for (std::size_t i = 0; i < kSensors; ++i) messages.emplace_back(describe(sensorAt(i)));
    for (int i = 0; i < kSensorTroubles; ++i)
        for (const double way : {0.0, 0.6})
            messages.push_back(describeTrouble(
                {.trouble = static_cast<SensorTrouble>(i), .amount = 12.0, .way = way}));
    TerrainEstimate estimate = stepEstimate();
    for (int i = 0; i < 400; ++i) {
        estimate.draws.push_back(estimate.height);
        if (i % 2 == 0) estimate.draws.back()[9] -= 0.3;
    }
    for (const double limit : {0.1, 0.9})  // an undecided and an almost certain value
        for (const Message& sentence : hiddenByBands(estimate, limit)) messages.push_back(sentence);
    return messages;
}

TEST(Languages, messagesOfTheCoreAreTranslatedWithTheirNumbers)
{
    const std::vector<Message> messages = coreMessages();
    const Message trouble = fileError("/home/no 2/mine.ttm",
                                      Message::joined(TR_NOOP("core", "cannot be opened"),
                                                      TR_NOOP("core", "No such file or directory")))
                                .message;
    for (const char* language : {"cs", "de"}) {
        ASSERT_EQ(installLanguage(*qApp, language), QLatin1String(language));
        for (const BusState state : kBusStates) {
            const QString english = QString::fromStdString(describe(state, "can0").english());
            const QString translated = busStateText(state, "can0");
            EXPECT_NE(translated, english) << language;
            EXPECT_TRUE(translated.startsWith("can0")) << translated.toStdString();
            const auto command = [](const QString& text) { return text.section(" (", -1); };
            EXPECT_TRUE(!english.endsWith(')') || command(translated) == command(english))
                << translated.toStdString();
        }
        for (const Message& message : messages)
            EXPECT_NE(translated(message).toStdString(), message.english()) << language;
        const QString roll = translated(
            Message(TR_NOOP("core", "roll %1°: the ground is not the same left and right"),
                    fixed(-5.2, 1)));
        EXPECT_TRUE(roll.contains("-5.2°") && !roll.contains("ground")) << roll.toStdString();
        EXPECT_EQ(translated(Message::verbatim("ready")), "ready") << "a name";
        const QStringList parts = translated(trouble).split(": ");
        ASSERT_EQ(parts.size(), 3) << language;
        EXPECT_EQ(parts[0], "/home/no 2/mine.ttm");
        EXPECT_NE(parts[1], "cannot be opened");
        EXPECT_NE(parts[2], "No such file or directory");
    }
    EXPECT_EQ(installLanguage(*qApp, "tlh"), "en");
    EXPECT_EQ(translated(trouble).toStdString(), trouble.english());
}

TEST(Languages, namesOfFilesColumnsAndSourcesAreNotTranslated)
{
    for (const char* language : {"cs", "de"}) {
        ASSERT_EQ(installLanguage(*qApp, language), QLatin1String(language));
        for (const char* name : {"up", "lost", "approve", "drive", "back", "stop", "halt",
                                 "settings", "ready", "stopped", "driving", "fast", "no", "none"}) {
            const QString whose = QString::fromUtf8(name);
            const std::string file =
                translated(fileError(name, TR_NOOP("core", "cannot be opened")).message)
                    .toStdString();
            EXPECT_TRUE(file.starts_with(std::string(name) + ": ")) << file;
            EXPECT_EQ(file.find("opened"), std::string::npos) << file;
            const Message deleted(
                TR_NOOP("core", "session deleted, since it is older than you have set: %1"), name);
            EXPECT_TRUE(translated(deleted).endsWith(": " + whose)) << name;
            const QString column =
                translated(Message(TR_NOOP("core", "the column %1 appears twice"), name));
            EXPECT_TRUE(column.split(' ').contains(whose)) << column.toStdString();
            EXPECT_FALSE(column.contains("twice")) << column.toStdString();
            EXPECT_EQ(format::sourceName(name), whose);
            const QString replay = format::sourceName(std::string("REPLAY ") + name);
            EXPECT_TRUE(replay.endsWith(' ' + whose) && !replay.startsWith("REPLAY"))
                << replay.toStdString();
        }
        for (const char* word :
             {"up", "lost", "approve", "drive", "back", "stop", "halt", "settings"}) {
            EXPECT_NE(format::eventWord(word), word) << language;
        }
        EXPECT_NE(format::sourceName("SIMULATED ROBOT"), "SIMULATED ROBOT") << language;
    }
    installLanguage(*qApp, "en");
    EXPECT_EQ(format::sourceName("REPLAY drive"), "REPLAY drive");
    EXPECT_EQ(format::eventWord("drive"), "drive");
}

struct InCzech {
    InCzech() : isThere(installLanguage(*qApp, "cs") == QLatin1String("cs")) {}
    ~InCzech() { installLanguage(*qApp, "en"); }
    bool isThere;
};

TEST(Languages, messagesOfThePanelKeepTheirNames)
{
    const InCzech czech;
    ASSERT_TRUE(czech.isThere);
    const GpioChip chip{.path = "/dev/gpiochip0", .name = "gpiochip0", .label = "box", .lines = 4};
    const auto missing = chooseGpioChip({chip}, "", "gpiochip7");
    ASSERT_FALSE(missing);
    EXPECT_EQ(translated({TR_NOOP("core", "the panel is absent: %1"), missing.error().message}),
              QString::fromUtf8("panel chybí: žádný čip GPIO jménem 'gpiochip7': je tu gpiochip0 "
                                "[box]"));
    GpioFound found;
    found.chip = "gpiochip0";
    found.label = "box";
    found.inputs = {{.offset = 2, .name = ""}};
    const Error busy =
        gpioRefused(EBUSY, found, {{}, {}, {.name = "", .used = true, .holder = ""}});
    const QString held = translated(busy.message);
    EXPECT_TRUE(held.contains(QString::fromUtf8("jiný program nebo jádro"))) << held.toStdString();
    EXPECT_FALSE(held.contains("in use"));
    for (const Result<GpioChip>& none :
         {chooseGpioChip({}, "box", ""), chooseGpioChip({chip, chip}, "box", "")}) {
        ASSERT_FALSE(none);
        EXPECT_FALSE(translated(none.error().message).contains("GPIO chip")) << none.error().text;
    }
    for (const Message& trouble : {buttonTrouble(PanelContact::Approve, ButtonPhase::Stuck),
                                   buttonTrouble(PanelContact::Approve, ButtonPhase::HeldAtStart)})
        EXPECT_TRUE(translated(trouble).startsWith(QString::fromUtf8("tlačítko")))
            << trouble.english();
}

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
        ASSERT_EQ(installLanguage(*qApp, language), QLatin1String(language));
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

TEST(UnitsOf, messagesAreConvertedForPeopleOnly)
{
    const auto shown = [](const char* sentence, const auto&... arguments) {
        return translated(Message(SourceText{"core", sentence}, arguments...)).toStdString();
    };
    const Message roll(SourceText{"core", "roll %1 at %2"}, "+5.0°", "0.6 m");
    EXPECT_EQ(translated(roll), QString::fromUtf8("roll +5.0° at 0.6 m"));
    setUnits({LengthUnit::Centimetre, AngleUnit::Radian});
    EXPECT_EQ(translated(roll), "roll +0.087 rad at 60 cm");
    EXPECT_EQ(roll.english(), "roll +5.0° at 0.6 m") << "what a recording holds";
    EXPECT_EQ(shown("known to ± %1 m or better", "0.06"), "known to ± 6 cm or better");
    EXPECT_EQ(shown("arm: %1 m", "\u22120.123"), "arm: \u221212.3 cm");
    EXPECT_EQ(shown("%1 · %2 m · %3 m/min, %4 mm", "x", "1.25", "0.5", "3"),
              "x · 125 cm · 0.5 m/min, 3 mm");
    EXPECT_EQ(shown("drive 0.1 m on, %1 minutes", "5"), "drive 10 cm on, 5 minutes");
    EXPECT_EQ(shown("file %1 m", "a.csv"), "file a.csv m") << "no number";
    setUnits({});
}

TEST(UnitsOf, plottedValuesFollowTheUnitsInUse)
{
    const auto shown = [](const char* si) {
        const ShownUnit unit = shownUnit(si);
        return QStringLiteral("%1 %2").arg(unit.name).arg(unit.factor, 0, 'g', 4).toStdString();
    };
    EXPECT_EQ(shown("rad"), "° 57.3");
    EXPECT_EQ(shown("rad/s"), "°/s 57.3");
    EXPECT_EQ(shown("m"), "m 1");
    setUnits({LengthUnit::Centimetre, AngleUnit::Radian});
    EXPECT_EQ(shown("rad"), "rad 1");
    EXPECT_EQ(shown("m"), "cm 100");
    EXPECT_EQ(shown("m/s"), "cm/s 100");
    for (const char* other : {"", "N", "m/s²", "mm", "rad·s", "m/min"})
        EXPECT_EQ(shown(other), other + std::string(" 1"));
    setUnits({});
}

TEST(UnitsOf, numbersKeepTheirResolution)
{
    EXPECT_EQ(format::length(0.1, 2), "0.10 m");
    EXPECT_EQ(format::binName(9), "0.6 m");
    EXPECT_EQ(format::angle(0.1), QString::fromUtf8("+5.7°"));
    setUnits({LengthUnit::Centimetre, AngleUnit::Radian});
    EXPECT_EQ(format::length(0.1, 2), "10 cm");
    EXPECT_EQ(format::signedLength(0.1234, 3), "+12.3 cm");
    EXPECT_EQ(format::binName(9), "60 cm");
    EXPECT_EQ(format::angle(0.1), "+0.100 rad");
    EXPECT_EQ(format::plainAngle(0.4363, 0), "0.44 rad");
    EXPECT_EQ(format::degrees(0.1), QString::fromUtf8("+5.7°")) << "of a message";
    setUnits({});
}

}  // namespace
}  // namespace terratact
