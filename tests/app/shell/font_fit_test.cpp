// Tests that every page follows a change of the font size at run time, including tables.
#include "app/shell/font_fit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <string>
#include <utility>

#include "app/display/format.h"
#include "app/start/language.h"
#include "tests/support/benches/bus_console_bench.h"
#include "tests/support/benches/review_bench.h"
#include "widgets/base/navigation_rail.h"
#include "widgets/signals/alarm_table.h"
#include "widgets/signals/raw_trace.h"
#include "widgets/signals/signal_table.h"

namespace terratact {
namespace {

using gui::eventually;

constexpr const char* kLanguages[]{"en", "cs", "de"};
constexpr std::pair<int, QSize> kLetters[]{{150, {1920, 1080}}, {200, {2560, 1440}}};  // [%]

/// Shows each page of the window in each font size; no text may be cut.
void lookAtEachPage(ConsoleWindow& window, NavigationRail& rail,
                    const std::function<void(int)>& resizeLetters, const std::string& language)
{
    for (const auto& [percent, size] : kLetters) {
        window.setRoom(size);
        resizeLetters(percent);
        window.resize(size);
        EXPECT_EQ(lookInForce().fontScale, percent);
        for (int page = 0; page < rail.pages(); ++page) {
            rail.choose(page);
            QTest::qWait(150);
            EXPECT_EQ(gui::cutWhenSettled(window), std::vector<std::string>())
                << language << ", " << percent << " %, page " << page;
        }
        rail.choose(0);
        resizeLetters(100);
    }
}

struct ConsoleFont : BusConsole {
    ~ConsoleFont() override
    {
        window.reset();
        robot.reset();
        installLanguage(*qApp, "en");
        applyLook(*qApp);
    }
};

TEST_F(ConsoleFont, cutNothingOnAnyPageInAnyLanguage)
{
    for (const char* language : kLanguages) {
        window.reset();
        robot.reset();
        applyLook(*qApp);
        ASSERT_EQ(installLanguage(*qApp, language), QLatin1String(language));
        open();
        ASSERT_TRUE(exploresAndProbes());
        QTest::mousePress(window->header()->stopButton(), Qt::LeftButton);
        ASSERT_TRUE(eventually([&] { return !window->alarms().list().alarms().empty(); }))
            << "no alarm stands";
        lookAtEachPage(
            *window, *window->rail(),
            [this](int percent) {
                window->preferences().change([percent](Preferences& p) { p.fontScale = percent; });
            },
            language);
    }
}

struct ReviewFont : ReviewOf {
    ~ReviewFont() override
    {
        window.reset();
        installLanguage(*qApp, "en");
        applyLook(*qApp);
    }
};

TEST_F(ReviewFont, cutNothingOnAnyPageInAnyLanguage)
{
    record();
    for (const char* language : kLanguages) {
        window.reset();
        applyLook(*qApp);
        ASSERT_EQ(installLanguage(*qApp, language), QLatin1String(language));
        open();
        window->goTo(RobotSessionTimes::kAlarm + 0.1);
        lookAtEachPage(
            *window, *window->rail(),
            [this](int percent) {
                press(Qt::Key_0, Qt::ControlModifier);
                for (int now = 100; now < percent; now += kFontStep)
                    press(Qt::Key_Plus, Qt::ControlModifier);
            },
            language);
    }
}

TEST(TableFont, resizeRowsAndColumnsOfExistingTables)
{
    applyLook(*qApp);
    RawTrace trace(
        [](const CanFrame&) {
            return TraceText{"022", "Attitude", "[8]", "words"};
        },
        [](const CanFrame&) { return QString(); });
    SignalTable table;
    AlarmTable alarms;
    const auto sizes = [&] {
        return std::array{table.rowHeight(0),
                          table.columnWidth(SignalTable::Value),
                          trace.view()->verticalHeader()->defaultSectionSize(),
                          trace.view()->columnWidth(0),
                          trace.filter()->width(),
                          alarms.table()->columnWidth(0)};
    };
    table.setRows({SignalRow{}});
    alarms.resize(900, 300);
    trace.resize(1200, 300);
    for (QWidget* shown : std::initializer_list<QWidget*>{&trace, &table, &alarms}) shown->show();
    const auto before = sizes();
    applyLook(*qApp, ThemeName::Day, 200);
    const auto grew = [&](std::size_t i) { return sizes()[i] > 1.5 * before[i]; };
    for (std::size_t i = 0; i < before.size(); ++i)
        EXPECT_TRUE(gui::eventually([&] { return grew(i); })) << i << ": " << before[i];
    applyLook(*qApp);
}

/// Returns the final font scale of a window and the number of trials.
std::pair<int, int> lettersThatFit(int wanted, QSize room, const std::function<QSize(int)>& needs)
{
    int percent = wanted, tries = 1;
    for (; percent > kSmallestFont && needs(percent).expandedTo(room) != room; ++tries)
        percent = smallerFont(percent, needs(percent), room);
    return {percent, tries};
}

TEST(FontFit, areTheLargestThatFit)
{
    const auto fits = [](int wanted, QSize room) {
        return lettersThatFit(wanted, room,
                              [](int percent) { return QSize(10 * percent, 5 * percent); });
    };
    EXPECT_EQ(fits(100, {2000, 2000}), std::pair(100, 1)) << "never larger than wanted";
    EXPECT_EQ(fits(200, {2000, 1000}), std::pair(200, 1)) << "just so";
    EXPECT_EQ(fits(200, {1999, 2000}), std::pair(190, 2)) << "too wide";
    EXPECT_EQ(fits(200, {2000, 700}), std::pair(140, 2)) << "too high";
    EXPECT_EQ(fits(155, {1460, 2000}), std::pair(145, 2)) << "steps are from the wanted ones";
    EXPECT_EQ(fits(200, {100, 100}), std::pair(kSmallestFont, 2)) << "smaller there are none";
}

TEST(FontFit, areTheLargestThatFitWithFixedSizeParts)
{
    for (int room = 900; room < 1700; room += 7) {
        const auto needs = [](int percent) { return QSize(5 * percent, 700 + 4 * percent); };
        const auto [percent, tries] = lettersThatFit(200, {2000, room}, needs);
        EXPECT_EQ(percent, std::clamp((room - 700) / 40 * 10, kSmallestFont, 200)) << room;
        EXPECT_LE(tries, 8) << room;
    }
}

}  // namespace
}  // namespace terratact
