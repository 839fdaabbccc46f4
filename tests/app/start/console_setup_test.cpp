// Tests where a window's settings come from.
#include "app/start/console_setup.h"

#include <gtest/gtest.h>

#include <string>

#include "tests/support/other_user.h"

namespace terratact {
namespace {

TEST(ConsoleSetup, withoutAHomeFolderSaysWhatIsNotSaved)
{
    constexpr uid_t kUnknown = 54'321;  // not in the user database
    const int silent = asOtherUser(kUnknown, [] {
        const LoadedPreferences loaded = preferencesFor({});
        if (!loaded.path.isEmpty() || loaded.troubles.size() != 1) return 1;
        const std::string said = loaded.troubles.front().english();
        return said.find("set HOME or XDG_CONFIG_HOME") == std::string::npos ? 2 : 0;
    });
    if (silent < 0) GTEST_SKIP() << "only root may act as another user";
    EXPECT_EQ(silent, 0) << "1: it is not the only trouble, 2: it does not say what helps";
    ConsoleOptions picture;
    picture.screenshot = "a.png";
    EXPECT_TRUE(preferencesFor(picture).troubles.empty()) << "a picture saves none";
}

}  // namespace
}  // namespace terratact
