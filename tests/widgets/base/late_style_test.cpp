#include "widgets/base/late_style.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QEvent>
#include <QPushButton>
#include <QScrollArea>
#include <QTableWidget>
#include <memory>

namespace terratact {
namespace {

/// Counts the changes of style that reach a scroll area.
class CountingArea final : public QScrollArea {
public:
    CountingArea()
    {
        setWidgetResizable(true);
        setWidget(new QPushButton(QStringLiteral("a button of some width")));
    }

    int changes = 0;

protected:
    bool event(QEvent* event) override
    {
        if (event->type() == QEvent::StyleChange) ++changes;
        return QScrollArea::event(event);
    }
};

struct LateStyle : testing::Test {
    void SetUp() override
    {
        restyleHiddenAreasLate(*qApp);
        area->resize(60, 60);
        area->show();
        area->hide();
        area->changes = 0;
    }

    void TearDown() override { qApp->setStyleSheet({}); }

    static void widenButtons()
    {
        qApp->setStyleSheet(QStringLiteral("QPushButton { min-width: 500px; }"));
    }

    std::unique_ptr<CountingArea> area = std::make_unique<CountingArea>();
};

TEST_F(LateStyle, reachesAHiddenAreaOnceWhenItIsShown)
{
    widenButtons();
    widenButtons();
    EXPECT_EQ(area->changes, 0);
    area->show();
    EXPECT_EQ(area->changes, 1);
    EXPECT_GE(area->widget()->width(), 500) << "the content has its new size";
    area->hide();
    area->show();
    EXPECT_EQ(area->changes, 1) << "nothing was missed";
}

/// Counts the changes of style that reach a table and the part of it that shows its cells.
class CountingTable final : public QTableWidget {
public:
    CountingTable() : QTableWidget(2, 2) {}
    int changes = 0;

protected:
    bool event(QEvent* event) override
    {
        if (event->type() == QEvent::StyleChange) ++changes;
        return QTableWidget::event(event);
    }

    bool viewportEvent(QEvent* event) override
    {
        if (event->type() == QEvent::StyleChange) ++changes;
        return QTableWidget::viewportEvent(event);
    }
};

TEST_F(LateStyle, reachesAHiddenTableOnceWhenItIsShown)
{
    CountingTable table;
    table.show();
    table.hide();
    table.changes = 0;
    qApp->setStyleSheet(QStringLiteral("QHeaderView::section { min-height: 70px; }"));
    EXPECT_EQ(table.changes, 0);
    table.show();
    EXPECT_EQ(table.changes, 2) << "the table and what shows its cells";
    EXPECT_GE(table.horizontalHeader()->height(), 70);
}

TEST_F(LateStyle, reachesAVisibleAreaAtOnce)
{
    area->show();
    widenButtons();
    EXPECT_GE(area->changes, 1);
    EXPECT_GE(area->widget()->width(), 500);
}

TEST_F(LateStyle, forgetsAnAreaThatIsDeletedHidden)
{
    widenButtons();
    area.reset();
    widenButtons();
    CountingArea other;
    other.show();
    EXPECT_GE(other.widget()->width(), 500);
}

}  // namespace
}  // namespace terratact
