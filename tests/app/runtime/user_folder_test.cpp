// Tests where a user's own files are kept.
#include "app/runtime/user_folder.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <optional>
#include <string>

namespace terratact {
namespace {

/// An environment variable that gets its earlier value back.
class Variable {
public:
    explicit Variable(const char* name) : name_(name)
    {
        if (const char* const now = std::getenv(name)) before_ = now;
    }
    ~Variable()
    {
        if (before_)
            set(before_->c_str());
        else
            ::unsetenv(name_);
    }
    Variable(const Variable&) = delete;
    Variable& operator=(const Variable&) = delete;
    void set(const char* value) const { ::setenv(name_, value, 1); }

private:
    const char* name_;
    std::optional<std::string> before_;
};

TEST(UserFolder, isThatOfTheVariableElseBelowTheHomeFolder)
{
    const Variable own("XDG_CONFIG_HOME"), home("HOME");
    home.set("/home/a");
    own.set("/settings");
    EXPECT_EQ(userFolder("XDG_CONFIG_HOME", ".config"), "/settings");
    for (const char* const odd : {"", "settings", "./settings"}) {
        own.set(odd);
        EXPECT_EQ(userFolder("XDG_CONFIG_HOME", ".config"), "/home/a/.config") << odd;
    }
}

TEST(UserFolder, isNeverRelative)
{
    const Variable own("XDG_CONFIG_HOME"), home("HOME");
    own.set("");
    for (const char* const odd : {"", "relative", "."}) {
        home.set(odd);
        const std::string folder = userFolder("XDG_CONFIG_HOME", ".config");
        EXPECT_TRUE(folder.empty() || folder.starts_with('/')) << odd << ": " << folder;
    }
}

}  // namespace
}  // namespace terratact
