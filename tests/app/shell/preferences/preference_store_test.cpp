// Tests which preferences are saved, and how errors are reported.
#include "app/shell/preferences/preference_store.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <future>
#include <optional>
#include <string>
#include <vector>

#include "app/console/main_window.h"
#include "app/display/translated.h"
#include "app/start/language.h"
#include "core/store/file_read.h"
#include "tests/support/benches/look_bench.h"
#include "tests/support/gui.h"
#include "widgets/signals/event_list.h"

namespace terratact {
namespace {

using gui::eventually;

TEST_F(Look, choicesAreSavedButNotCommandLineOptions)
{
    Preferences fromCommandLine;
    fromCommandLine.theme = ThemeName::HighContrast;
    window.reset();
    open(fromCommandLine);
    press(Qt::Key_3);
    EXPECT_EQ(window->preferences().current().theme, ThemeName::HighContrast);
    EXPECT_TRUE(eventually([&] { return saved().layout == Layout::Review; }));
    EXPECT_EQ(saved().theme, ThemeName::Day);
    window->close();
    EXPECT_TRUE(eventually([&] { return !saved().window.isEmpty(); }));
}

TEST(PreferenceStore, aSlowDiskHoldsNoChangeAndGetsTheNewest)
{
    std::promise<void> disk;
    const std::shared_future<void> answers = disk.get_future().share();
    std::vector<double> written;
    {
        LoadedPreferences loaded;
        loaded.path = QStringLiteral("console.ini");
        PreferenceStore store(loaded, {}, [&](const QString&, const Preferences& p) {
            answers.wait();
            written.push_back(p.obstacleLimit);
            return std::optional<Message>();
        });
        for (const double limit : {0.2, 0.3, 0.4})
            store.change([limit](Preferences& p) { p.obstacleLimit = limit; });
        EXPECT_EQ(store.current().obstacleLimit, 0.4);
        disk.set_value();  // a change that waits never comes here
    }
    EXPECT_EQ(written, (std::vector{0.2, 0.4})) << "the end waits for the newest";
}

TEST_F(Look, aTroubleWithThePreferencesIsAnEvent)
{
    window.reset();
    directory.write("console.ini", "[General]\nschema=1\ntheme=purple\n");
    open();
    EXPECT_TRUE(eventually([&] {
        return window->events()->count() > 0
            && !window->events()->findItems("purple", Qt::MatchContains).isEmpty();
    }));
}

TEST_F(Look, preferencesThatCannotBeSavedAreAnEvent)
{
    const std::string file = directory.file("console.ini");
    std::filesystem::remove(file);
    std::filesystem::create_symlink("/proc/terratact", file);
    press(Qt::Key_3);
    EXPECT_TRUE(eventually([&] {
        return !window->events()->findItems("it is a symbolic link", Qt::MatchContains).isEmpty();
    }));
}

TEST_F(Look, preferenceErrorsUseTheCurrentLanguage)
{
    directory.write("console.ini", "[General]\nschema=1\nlanguage=cs\ntheme=purple\n");
    LoadedPreferences loaded =
        loadPreferences(QString::fromStdString(directory.file("console.ini")));
    loaded.troubles.push_back(robotNotUsed(fileError("mine.toml", TR_NOOP("core", "is empty"))));
    const PreferenceStore store(loaded, loaded.preferences);
    const auto sentences = [&store] {
        QStringList all;
        for (const Message& trouble : store.troubles()) all << translated(trouble);
        return all;
    };
    const QStringList english = sentences();
    ASSERT_EQ(installLanguage(*qApp, store.current().language), "cs");
    const QStringList czech = sentences();
    installLanguage(*qApp, "en");
    ASSERT_EQ(czech.size(), 2);
    EXPECT_TRUE(czech[0].contains("purple") && czech[0] != english[0]);
    EXPECT_TRUE(czech[1].contains("mine.toml: ") && !czech[1].contains("is empty"));
}

}  // namespace
}  // namespace terratact
