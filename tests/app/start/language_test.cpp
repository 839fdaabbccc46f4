// Tests the languages of the console.
#include "app/start/language.h"

#include <gtest/gtest.h>

#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QLocale>
#include <QSpinBox>

#include "tests/support/benches/look_bench.h"
#include "tests/support/gui.h"
#include "widgets/base/navigation_rail.h"

namespace terratact {
namespace {

using gui::eventually;

TEST_F(Look, noLanguageCutsText)
{
    for (const char* language : {"en", "cs", "de"}) {
        window.reset();
        ASSERT_EQ(installLanguage(*qApp, language), QLatin1String(language));
        open();
        explore();
        for (const QSize size : {QSize(1280, 720), QSize(1440, 900), window->minimumSize()}) {
            window->resize(size);
            QTest::qWait(100);
            eachPage([&] {
                (void)eventually([&] { return gui::cutText(*window).empty(); },
                                 2000);  // waits for the layout
                EXPECT_EQ(gui::cutText(*window), std::vector<std::string>())
                    << language << ", width " << size.width() << ", page "
                    << window->rail()->chosen();
            });
        }
        EXPECT_EQ(window->keys().html().contains("drive back"), language == std::string_view("en"));
    }
    installLanguage(*qApp, "en");
}

TEST(Languages, numbersAreWrittenAndReadTheSameInEach)
{
    for (const char* language : {"en", "cs", "de"}) {
        QLocale::setDefault(QLocale(QLocale::German, QLocale::Germany));  // like LANG=de_DE
        (void)installLanguage(*qApp, language);
        QDoubleSpinBox box;
        box.setRange(0.0, 100'000.0);
        box.setValue(12'345.5);
        EXPECT_EQ(box.text(), "12345.50") << language;
        box.findChild<QLineEdit*>()->setText("0.25");
        box.interpretText();
        EXPECT_EQ(box.value(), 0.25) << language;
        QSpinBox whole;
        whole.setRange(0, 100'000);
        whole.setValue(10'000);
        EXPECT_EQ(whole.text(), "10000") << language;
    }
    installLanguage(*qApp, "en");
}

}  // namespace
}  // namespace terratact
