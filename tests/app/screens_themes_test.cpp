// What decides, in the colours of the night and of high contrast, in the smallest window and in the largest letters.
#include <utility>

#include "app/link_status.h"
#include "tests/app/screens.h"
#include "tests/support/gui.h"
#include "widgets/atem_panel.h"
#include "widgets/held_button.h"
#include "widgets/probe_card.h"
#include "widgets/status_header.h"
#include "widgets/words.h"

namespace terratact {

using gui::eventually;

TEST_F(Screens, themes)
{
    const auto named = [](const char* what, const char* theme) {
        return std::string(what) + '_' + theme;
    };
    inEveryLanguage([&] {
        for (const auto& [theme, name] : {std::pair(ThemeName::NightRed, "by_night"),
                                          std::pair(ThemeName::HighContrast, "in_high_contrast")}) {
            open({.linkLostAfter = 0.8});
            console->preferences().change([theme = theme](Preferences& p) { p.theme = theme; });
            picture(named("not_ready", name), {AtemPanel::tr("not ready")});
            ASSERT_NO_FATAL_FAILURE(explore());
            const QString question = ProbeCard::tr("hold to approve probe at %1 (Space)");
            picture(named("asked", name), {question});
            press(Qt::Key_F12);
            picture(named("stopped", name), {StatusHeader::tr("STOPPED (F12)")});
            robot->stage({.isMute = true});
            picture(named("link_lost", name),
                    {LinkStatus::tr("%1 for %2 — nothing on this screen is live%3")});
            press(Qt::Key_F4);
            picture(named("alarms", name), {words::sentence("link lost")});
        }

        open({});
        console->setRoom({1200, 680});
        console->resize(1200, 680);
        ASSERT_NO_FATAL_FAILURE(explore());
        picture("asked_in_the_smallest_window", {ProbeCard::tr("%1 left, then no")});
        console->setRoom({1440, 900});
        console->resize(1440, 900);
        console->preferences().change([](Preferences& p) { p.fontScale = 200; });
        picture("asked_in_letters_of_200_percent", {ProbeCard::tr("%1 left")});
    });
}

}  // namespace terratact
