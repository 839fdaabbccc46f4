// Pictures of the gamepad's page, in every theme, at the smallest window and the largest font.
#include "app/console/pages/gamepad_page.h"
#include "tests/app/console/screens/screens.h"

namespace terratact {

TEST_F(Screens, gamepad)
{
    inEveryLanguage([&] {
        desk.set({});
        open({.hasGamepad = true});
        press(Qt::Key_F10);
        picture("no_gamepad",
                {GamepadPage::tr("No gamepad is connected. Plug one in at any time.")});
        GamepadState state;
        state.connection = 1;
        state.name = "Gamepad 360";
        const auto show = [&](const std::function<void()>& change) {
            change();
            desk.set(state);
            QTest::qWait(100);  // for some ticks of the window
        };
        show([] {});
        show([&] { state[PadAxis::RightTrigger] = 1.0; });
        show([&] {
            state[PadAxis::LeftY] = -0.6;
            state[PadAxis::LeftX] = 0.2;
            state[PadButton::A] = state[PadButton::Y] = true;
        });
        const QStringList connected{GamepadPage::tr("Connected: %1")};
        picture("page_gamepad", connected);
        QTest::mouseClick(console->gamepadPage()->assignButton(), Qt::LeftButton);
        picture("assigns_a_control",
                {GamepadPage::tr("Press the button or trigger for: %1. It waits 10 s.")});
        QTest::mouseClick(console->gamepadPage()->assignButton(), Qt::LeftButton);
        const auto inTheme = [&](ThemeName theme, std::string_view name) {
            console->preferences().change([&](Preferences& p) { p.theme = theme; });
            picture(name, connected);
        };
        inTheme(ThemeName::NightRed, "page_gamepad_by_night");
        inTheme(ThemeName::HighContrast, "page_gamepad_in_high_contrast");
        console->preferences().change([](Preferences& p) { p.theme = ThemeName::Day; });
        console->setRoom({1200, 680});
        console->resize(1200, 680);
        picture("page_gamepad_in_the_smallest_window", connected);
        console->setRoom({1440, 900});
        console->resize(1440, 900);
        console->preferences().change([](Preferences& p) { p.fontScale = 200; });
        picture("page_gamepad_in_letters_of_200_percent", connected);
    });
}

}  // namespace terratact
