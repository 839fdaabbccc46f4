// Tests translated sentences of the core.
#include <gtest/gtest.h>

#include <QApplication>
#include <cerrno>
#include <string>

#include "app/display/format.h"
#include "app/display/translated.h"
#include "app/mission/bus_text.h"
#include "app/shell/language.h"
#include "core/atem/following.h"
#include "core/atem/panel.h"
#include "core/infer/verdict/estimate_text.h"
#include "core/infer/verdict/verdict.h"
#include "core/robot/force_sensor.h"
#include "core/robot/watch/sensor_suspicion.h"
#include "drivers/gpio_chip.h"
#include "tests/support/estimates.h"

namespace terratact {
namespace {

/// Returns describe() of every enumerator from 0 to `last`; describe() knows none beyond it.
template <class Enum>
QStringList allTo(Enum last)
{
    QStringList sentences;
    for (int i = 0; i <= static_cast<int>(last); ++i)
        sentences << QString::fromStdString(describe(static_cast<Enum>(i)));
    EXPECT_THROW((void)describe(static_cast<Enum>(static_cast<int>(last) + 1)),
                 std::invalid_argument)
        << sentences.last().toStdString() << " is not the last";
    return sentences;
}

TEST(Languages, coreSentencesAreTranslatedWithTheirNumbers)
{
    constexpr const char* kTrouble =
        "/home/no 2/mine.ttm: cannot be opened: No such file or directory";
    TerrainEstimate estimate = stepEstimate();
    for (int i = 0; i < 400; ++i) {
        estimate.draws.push_back(estimate.height);
        if (i % 2 == 0) estimate.draws.back()[9] -= 0.3;
    }
    QStringList said = allTo(AtemPhase::Failed) + allTo(AtemFailure::Disarmed)
                     + allTo(DisarmCause::EpochChanged) + allTo(GateRefusal::OtherBin)
                     + allTo(WithholdReason::Contradiction) + allTo(RobotActivity::Stopped)
                     + allTo(Refusal::OutOfLimits)
                     + allTo(ElementState::Short).mid(1)  // Sound has no text
                     + QStringList{"yes", "no", "none", "not measured"};
    for (int i = 0; i <= static_cast<int>(AtemPhase::Failed); ++i)
        said << QString::fromStdString(describeFollowed(static_cast<AtemPhase>(i)));
    for (std::size_t i = 0; i < kSensors; ++i)
        said << QString::fromStdString(std::string(describe(sensorAt(i))));
    for (int i = 0; i < kSensorTroubles; ++i)
        for (const double way : {0.0, 0.6})
            said << QString::fromStdString(describeTrouble(
                {.trouble = static_cast<SensorTrouble>(i), .amount = 12.0, .way = way}));
    for (const double limit : {0.1, 0.9})  // an undecided and an almost certain value
        for (const std::string& sentence : hiddenByBands(estimate, limit))
            said << QString::fromStdString(sentence);
    said << QString::fromUtf8(
        "the estimate contradicts the readings: pitch +3° measured, -1° on its ground; "
        "front flippers -2° measured, +4° on its ground");
    for (const StepVerdict stepVerdict :
         {StepVerdict::Clear, StepVerdict::Blocked, StepVerdict::CannotTell})
        said << format::text(name(stepVerdict));
    for (const char* language : {"cs", "de"}) {
        if (installLanguage(*qApp, language) != QLatin1String(language))
            GTEST_SKIP() << "built without translations";
        for (const BusState state : kBusStates) {
            const QString english = QString::fromStdString(describe(state, "can0"));
            const QString translated = busWords(state, "can0");
            EXPECT_NE(translated, english) << language;
            EXPECT_TRUE(translated.startsWith("can0 ")) << translated.toStdString();
            const auto command = [](const QString& text) { return text.section(" (", -1); };
            EXPECT_TRUE(!english.endsWith(')') || command(translated) == command(english))
                << translated.toStdString();
        }
        for (const QString& english : said)
            EXPECT_NE(format::sentence(english.toStdString()), english) << language;
        const QString roll =
            format::sentence("roll -5.2°: the ground is not the same left and right");
        EXPECT_TRUE(roll.contains("-5.2°") && !roll.contains("ground")) << roll.toStdString();
        EXPECT_EQ(format::sentence("nobody knows 3 of these"), "nobody knows 3 of these");
        const QStringList trouble = format::sentence(kTrouble).split(": ");
        ASSERT_EQ(trouble.size(), 3) << language;
        EXPECT_EQ(trouble[0], "/home/no 2/mine.ttm");
        EXPECT_NE(trouble[1], "cannot be opened");
        EXPECT_NE(trouble[2], "No such file or directory");
    }
    EXPECT_EQ(installLanguage(*qApp, "tlh"), "en");
    EXPECT_EQ(format::sentence("ready"), "ready");
    EXPECT_EQ(format::sentence(kTrouble), kTrouble);
}

TEST(Languages, namesOfFilesColumnsAndSourcesAreNotTranslated)
{
    for (const char* language : {"cs", "de"}) {
        if (installLanguage(*qApp, language) != QLatin1String(language))
            GTEST_SKIP() << "built without translations";
        for (const char* name : {"up", "lost", "approve", "drive", "back", "stop", "halt",
                                 "settings", "ready", "stopped", "driving", "fast", "no", "none"}) {
            const QString whose = QString::fromUtf8(name);
            const std::string file =
                format::sentence(std::string(name) + ": cannot be opened").toStdString();
            EXPECT_TRUE(file.starts_with(std::string(name) + ": ")) << file;
            EXPECT_EQ(file.find("opened"), std::string::npos) << file;
            const std::string behind = "session deleted, since it is older than you have set: ";
            EXPECT_TRUE(format::sentence(behind + name).endsWith(": " + whose)) << name;
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
            EXPECT_EQ(format::sentence(word), word) << "a word of events is no sentence";
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

TEST(CoreSentences, withNamesAreTranslatedAroundTheNames)
{
    const InCzech czech;
    if (!czech.isThere) GTEST_SKIP() << "built without translations";
    const GpioChip chip{.path = "/dev/gpiochip0", .name = "gpiochip0", .label = "box", .lines = 4};
    const auto missing = chooseGpioChip({chip}, "", "gpiochip7");
    ASSERT_FALSE(missing);
    EXPECT_EQ(format::sentence("the panel is absent: " + missing.error().text),
              QString::fromUtf8("panel chybí: žádný čip GPIO jménem 'gpiochip7': je tu gpiochip0 "
                                "[box]"));
    GpioFound found;
    found.chip = "gpiochip0";
    found.label = "box";
    found.inputs = {{.offset = 2, .name = ""}};
    const Error busy =
        gpioRefused(EBUSY, found, {{}, {}, {.name = "", .used = true, .holder = ""}});
    EXPECT_TRUE(format::sentence(busy.text).contains(QString::fromUtf8("jiný program nebo jádro")))
        << busy.text << " -> " << format::sentence(busy.text).toStdString();
    EXPECT_FALSE(format::sentence(busy.text).contains("in use"));
    for (const Result<GpioChip>& none :
         {chooseGpioChip({}, "box", ""), chooseGpioChip({chip, chip}, "box", "")}) {
        ASSERT_FALSE(none);
        EXPECT_FALSE(format::sentence(none.error().text).contains("GPIO chip"))
            << none.error().text;
    }
    for (const std::string& trouble :
         {buttonTrouble(PanelContact::Approve, ButtonPhase::Stuck),
          buttonTrouble(PanelContact::Approve, ButtonPhase::HeldAtStart)})
        EXPECT_TRUE(format::sentence(trouble).startsWith(QString::fromUtf8("tlačítko"))) << trouble;
    EXPECT_FALSE(
        format::sentence("chains not converged: R-hat > 100 (limit 1.01), effective draws 4 "
                         "(limit 400)")
            .contains("chains"));
}

}  // namespace
}  // namespace terratact
