// Tests that widgets of hidden pages adopt a new theme later, and look the same then.
#include "widgets/base/hidden_pages.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QLabel>
#include <QStackedWidget>

#include "tests/support/gui.h"
#include "widgets/base/theme.h"

namespace terratact {
namespace {

using gui::eventually;

/// Newer versions of Qt restyle all pages at once.
constexpr bool kPagesAreLate = QT_VERSION < QT_VERSION_CHECK(6, 5, 0);

/// Counts the changes of style that reach a label.
class CountingLabel final : public QLabel {
public:
    using QLabel::QLabel;
    int changes = 0;

protected:
    bool event(QEvent* event) override
    {
        if (event->type() == QEvent::StyleChange) ++changes;
        return QLabel::event(event);
    }
};

struct HiddenPagesOf : testing::Test {
    void SetUp() override
    {
        applyLook(*qApp);
        for (CountingLabel** page : {&shown, &hidden}) {
            *page = new CountingLabel(QStringLiteral("a page"));
            (*page)->setProperty("headline", true);
            stack.addWidget(*page);
        }
        gui::showActive(stack);
        stack.setCurrentIndex(1);
        stack.setCurrentIndex(0);
        shown->changes = hidden->changes = 0;
    }

    void TearDown() override { qApp->setStyleSheet({}); }

    QStackedWidget stack;
    CountingLabel *shown = nullptr, *hidden = nullptr;
};

TEST_F(HiddenPagesOf, adoptANewThemeWhenTheyAreShown)
{
    applyLook(*qApp, ThemeName::NightRed, 150);
    applyLook(*qApp, ThemeName::HighContrast, 200);
    EXPECT_GT(shown->changes, 0);
    if (kPagesAreLate) {
        EXPECT_EQ(hidden->changes, 0);
    }
    stack.setCurrentIndex(1);
    if (kPagesAreLate) {
        EXPECT_EQ(hidden->changes, 1);
    }
    EXPECT_EQ(hidden->font(), shown->font());
    gui::settle(*hidden);
    const QImage second = gui::painted(*hidden);
    stack.setCurrentIndex(0);
    gui::settle(*shown);
    EXPECT_EQ(gui::painted(*shown), second);
}

TEST_F(HiddenPagesOf, adoptANewThemeInIdleTime)
{
    applyLook(*qApp, ThemeName::NightRed, 150);
    EXPECT_TRUE(eventually([&] { return hidden->changes > 0; }));
    EXPECT_EQ(hidden->font(), shown->font());
    EXPECT_EQ(hidden->sizeHint(), shown->sizeHint());
    EXPECT_TRUE(styleHiddenPages(0)) << "none waits any more";
}

TEST_F(HiddenPagesOf, areStyledAtOnceOnDemand)
{
    applyLook(*qApp, ThemeName::Day, 150);
    styleHiddenPages();
    EXPECT_EQ(hidden->sizeHint(), shown->sizeHint());
    applyLook(*qApp, ThemeName::Day, 180);
    styleHiddenPage(*hidden);
    EXPECT_EQ(hidden->sizeHint(), shown->sizeHint());
}

TEST_F(HiddenPagesOf, mayBeDeletedWhileTheyWait)
{
    applyLook(*qApp, ThemeName::NightRed, 150);
    delete hidden;
    styleHiddenPages();
    applyLook(*qApp, ThemeName::Day, 100);
    EXPECT_TRUE(styleHiddenPages(0));
}

}  // namespace
}  // namespace terratact
