// Pictures of proposals and alarms in the night and high-contrast themes, at the smallest window and largest font.
#include <string_view>

#include "app/console/connection/link_status.h"
#include "app/display/format.h"
#include "app/display/translated.h"
#include "tests/app/console/screens/screens.h"
#include "widgets/control/atem_panel.h"
#include "widgets/control/probe_card.h"
#include "widgets/control/status_header.h"

namespace terratact {

TEST_F(Screens, themes)
{
    struct Names {
        ThemeName theme;
        std::string_view notReady, asked, stopped, lost, alarms;
    };
    constexpr Names kThemes[]{{ThemeName::NightRed, "not_ready_by_night", "asked_by_night",
                               "stopped_by_night", "link_lost_by_night", "alarms_by_night"},
                              {ThemeName::HighContrast, "not_ready_in_high_contrast",
                               "asked_in_high_contrast", "stopped_in_high_contrast",
                               "link_lost_in_high_contrast", "alarms_in_high_contrast"}};
    inEveryLanguage([&] {
        for (const Names& names : kThemes) {
            open({.linkLostAfter = 0.8});
            console->preferences().change([&](Preferences& p) { p.theme = names.theme; });
            picture(names.notReady, {AtemPanel::tr("not ready")});
            ASSERT_NO_FATAL_FAILURE(explore());
            picture(names.asked, {ProbeCard::tr("hold to approve probe %1 (Space)")});
            press(Qt::Key_F12);
            picture(names.stopped, {StatusHeader::tr("STOPPED (F12)")});
            robot->stage({.isMute = true});
            picture(names.lost, {LinkStatus::tr("%1 for %2 — nothing on this screen is live%3")});
            press(Qt::Key_F4);
            picture(names.alarms, {translated(TR_NOOP("core", "link lost"))});
        }

        open({});
        console->setRoom({1200, 680});
        console->resize(1200, 680);
        ASSERT_NO_FATAL_FAILURE(explore());
        picture("asked_in_the_smallest_window", {ProbeCard::tr("%1 left")});
        console->setRoom({1440, 900});
        console->resize(1440, 900);
        console->preferences().change([](Preferences& p) { p.fontScale = 200; });
        picture("asked_in_letters_of_200_percent", {ProbeCard::tr("%1 left")});
    });
}

}  // namespace terratact
