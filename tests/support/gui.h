#pragma once

#include <QAbstractButton>
#include <QAction>
#include <QComboBox>
#include <QHeaderView>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QProgressBar>
#include <QPushButton>
#include <QRegularExpression>
#include <QScrollArea>
#include <QScrollBar>
#include <QTableView>
#include <QTest>
#include <QWidget>
#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "tests/support/devices/paint_watch.h"
#include "tests/support/test_clock.h"
#include "tests/support/thread_time.h"

/// Helpers of the GUI tests.
namespace terratact::gui {

/// Each of these keys is STOP everywhere.
inline constexpr std::array kStopKeys{Qt::Key_F12, Qt::Key_Pause};

/// Values that must never reach a painter.
inline constexpr std::array kHostile{
    std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
    -std::numeric_limits<double>::infinity(), std::numeric_limits<double>::max(), -1e300};

/// Runs the event loop until the condition is true. Returns false after `patience` [ms] of the testClock, which a busy
/// machine slows down. Without such a clock it returns false only after kHang, too.
template <class Condition>
bool eventually(Condition&& condition, int patience = 20000)
{
    constexpr int kHang = 120'000;  // [ms] of the machine's clock, against tests that never end
    const double begin = testClock ? testClock() : 0.0;
    bool isTrue = false;
    (void)QTest::qWaitFor(
        [&] {
            isTrue = condition();
            return isTrue || (testClock && testClock() - begin > 0.001 * patience);
        },
        std::max(patience, kHang));
    return isTrue;
}

/// Shows a widget and gives it the focus of its window.
inline void showActive(QWidget& widget)
{
    widget.show();
    (void)QTest::qWaitForWindowExposed(&widget);
    widget.activateWindow();
    (void)QTest::qWaitForWindowActive(&widget);
}

/// Returns every text of visible widgets: display, tip and screen reader text. Texts are split into lines, and digits
/// become '#'.
inline std::set<std::string> textsOf(const QWidget& window)
{
    std::set<std::string> texts;
    const auto add = [&texts](const QString& all) {
        static const QRegularExpression kDigits(QStringLiteral("[0-9]+"));
        for (QString line : all.split(QLatin1Char('\n')))
            texts.insert(line.replace(kDigits, QStringLiteral("#")).trimmed().toStdString());
    };
    const auto addRows = [&add](const QAbstractItemModel& model, int columns) {
        for (int row = 0; row < model.rowCount(); ++row)
            for (int column = 0; column < columns; ++column) {
                const QModelIndex cell = model.index(row, column);
                for (const int role : {Qt::DisplayRole, Qt::ToolTipRole})
                    add(cell.data(role).toString());
            }
    };
    add(window.windowTitle());
    for (const QWidget* widget : window.findChildren<QWidget*>()) {
        if (!widget->isVisible()) continue;
        for (const QString& text :
             {widget->toolTip(), widget->accessibleName(), widget->accessibleDescription()})
            add(text);
        if (const auto* label = qobject_cast<const QLabel*>(widget)) add(label->text());
        if (const auto* bar = qobject_cast<const QProgressBar*>(widget)) add(bar->format());
        if (const auto* field = qobject_cast<const QLineEdit*>(widget))
            add(field->placeholderText());
        if (const auto* box = qobject_cast<const QComboBox*>(widget)) addRows(*box->model(), 1);
        if (const auto* button = qobject_cast<const QAbstractButton*>(widget)) add(button->text());
        if (const auto* button = qobject_cast<const QPushButton*>(widget); button && button->menu())
            for (const QAction* action : button->menu()->actions()) add(action->text());
        if (const auto* table = qobject_cast<const QTableView*>(widget)) {
            const QAbstractItemModel& model = *table->model();
            for (int column = 0; column < model.columnCount(); ++column)
                add(model.headerData(column, Qt::Horizontal).toString());
            addRows(model, model.columnCount());
        }
    }
    return texts;
}

/// Returns the readable texts of a window: visible labels, buttons, bars and tables. Drawn widgets count with their
/// screen reader text.
inline QStringList readableTexts(const QWidget& window)
{
    QStringList texts;
    for (const QWidget* widget : window.findChildren<QWidget*>()) {
        if (!widget->isVisible()) continue;
        texts << widget->accessibleDescription();
        if (const auto* label = qobject_cast<const QLabel*>(widget)) texts << label->text();
        if (const auto* button = qobject_cast<const QAbstractButton*>(widget))
            texts << button->text();
        if (const auto* bar = qobject_cast<const QProgressBar*>(widget)) texts << bar->text();
        if (const auto* table = qobject_cast<const QTableView*>(widget)) {
            const QAbstractItemModel& model = *table->model();
            for (int row = 0; row < model.rowCount(); ++row)
                for (int column = 0; column < model.columnCount(); ++column)
                    texts << model.index(row, column).data().toString();
        }
    }
    return texts;
}

/// The tips of buttons while enabled and while disabled; the tip of a disabled button must give the reason.
class TipsOfButtons {
public:
    /// Records the tips of the visible buttons.
    void poll(const QWidget& window)
    {
        for (const QAbstractButton* button : window.findChildren<QAbstractButton*>()) {
            if (!button->isVisible() || button->objectName().startsWith(QLatin1String("qt_")))
                continue;
            Tips& tips = tips_[button];
            (button->isEnabled() ? tips.enabled : tips.disabled).insert(button->toolTip());
            const QString name = button->accessibleName();
            tips.name = (name.isEmpty() ? button->text() : name).toStdString();
        }
    }
    /// Returns the names of buttons seen in both states.
    std::set<std::string> compared() const
    {
        std::set<std::string> names;
        for (const auto& [button, tips] : tips_)
            if (!tips.enabled.empty() && !tips.disabled.empty()) names.insert(tips.name);
        return names;
    }
    /// Returns disabled buttons without a tip, or with the same tip as when enabled.
    std::vector<std::string> silent() const
    {
        std::vector<std::string> names;
        for (const auto& [button, tips] : tips_)
            for (const QString& tip : tips.disabled)
                if (tip.isEmpty() || tips.enabled.count(tip) > 0)
                    names.push_back(tips.name + ": " + tip.toStdString());
        return names;
    }

private:
    struct Tips {
        std::string name;
        std::set<QString> enabled, disabled;
    };
    std::map<const QAbstractButton*, Tips> tips_;
};

inline constexpr int kHeaderFrame = 10;  // [px] padding and border around a column's name

/// Returns the texts of visible cells that are too low, or too narrow without a tip with the text.
inline std::vector<std::string> cutCells(const QTableView& table)
{
    constexpr int kFrame = 2;  // [px] margin of sizeHintForIndex() that may be cut
    std::vector<std::string> cut;
    const QAbstractItemModel& model = *table.model();
    for (int row = 0; row < model.rowCount(); ++row)
        for (int column = 0; column < model.columnCount(); ++column) {
            const QModelIndex cell = model.index(row, column);
            const QRect room = table.visualRect(cell);
            const QString text = cell.data().toString();
            if (text.isEmpty() || !table.viewport()->rect().intersects(room)) continue;
            const QSize needed =
                table.wordWrap()
                    ? table.fontMetrics()
                          .boundingRect(QRect(0, 0, room.width(), 9999), Qt::TextWordWrap, text)
                          .size()
                    : static_cast<const QAbstractItemView&>(table).sizeHintForIndex(cell);
            const QString tip = cell.data(Qt::ToolTipRole).toString();
            const bool isTold = tip.contains(text) || tip.contains(text.toHtmlEscaped());
            if ((!isTold && room.width() + kFrame < needed.width())
                || room.height() + kFrame < needed.height())
                cut.push_back(text.toStdString());
        }
    return cut;
}

/// Returns the texts of visible labels, buttons, bars, headings and cells that have too little room.
inline std::vector<std::string> cutText(const QWidget& window)
{
    std::vector<std::string> cut;
    const auto poll = [&](const QWidget& widget, const QString& text, const QSize& needed) {
        if (!widget.isVisible() || text.isEmpty()) return;
        if (widget.width() + 1 < needed.width() || widget.height() + 1 < needed.height())
            cut.push_back(text.toStdString());
    };
    for (const QLabel* label : window.findChildren<QLabel*>())
        if (!label->inherits("terratact::ElidedLabel"))  // its tip has all of the text
            poll(*label, label->text(),
                 label->wordWrap() ? QSize(0, label->heightForWidth(label->width()))
                                   : label->sizeHint());
    for (const QPushButton* button : window.findChildren<QPushButton*>())
        poll(*button, button->text(), button->minimumSizeHint());
    for (const QProgressBar* bar : window.findChildren<QProgressBar*>())
        if (bar->isTextVisible())
            poll(*bar, bar->text(), {bar->fontMetrics().horizontalAdvance(bar->text()), 0});
    for (const QTableView* table : window.findChildren<QTableView*>()) {
        const QHeaderView& header = *table->horizontalHeader();
        for (int column = 0; table->isVisible() && column < header.count(); ++column) {
            const QString text = table->model()->headerData(column, Qt::Horizontal).toString();
            const QSize needed = header.fontMetrics().size(0, text);
            if (!header.isSectionHidden(column)
                && header.sectionSize(column) < needed.width() + kHeaderFrame)
                cut.push_back(text.toStdString());
        }
        if (!table->isVisible()) continue;
        for (const std::string& text : cutCells(*table)) cut.push_back("cell: " + text);
    }
    return cut;
}

/// Returns the cut texts that remain after the layout has settled.
inline std::vector<std::string> cutWhenSettled(const QWidget& window)
{
    (void)eventually([&] { return cutText(window).empty(); });
    return cutText(window);
}

/// Returns the texts that are elided with "…"; their tips have all of the text.
inline std::vector<std::string> elidedText(const QWidget& window)
{
    std::vector<std::string> elided;
    for (const QLabel* label : window.findChildren<QLabel*>())
        if (label->isVisible() && label->inherits("terratact::ElidedLabel")
            && label->width() < label->sizeHint().width())
            elided.push_back(label->text().toStdString());
    return elided;
}

/// Returns texts that need scrolling although they should be visible at once.
inline std::vector<std::string> scrolledText(const QWidget& window)
{
    std::vector<std::string> scrolled;
    for (const QScrollArea* area : window.findChildren<QScrollArea*>())
        if (area->isVisible() && area->inherits("terratact::ScrollColumn")
            && area->verticalScrollBar()->maximum() > 0)
            scrolled.push_back(area->accessibleName().toStdString());
    return scrolled;
}

/// Returns true if Qt or Qwt lays out the widget's parts, some of which overlap.
inline bool hasPartsOfItsOwn(const QWidget& widget)
{
    for (const QWidget* at = &widget; at; at = at->parentWidget())
        if (at->inherits("QwtPlot")) return true;
    for (const char* kind : {"QAbstractScrollArea", "QAbstractSpinBox", "QComboBox"})
        if (widget.inherits(kind)) return true;
    return false;
}

/// Returns pairs of overlapping visible neighbours, and widgets that extend beyond their parent.
inline std::vector<std::string> overlaps(const QWidget& window)
{
    std::vector<std::string> found;
    const auto nameOf = [](const QWidget& widget) {
        const auto* label = qobject_cast<const QLabel*>(&widget);
        const auto* button = qobject_cast<const QAbstractButton*>(&widget);
        const QString text = label ? label->text() : button ? button->text() : QString();
        return std::string(widget.metaObject()->className()) + " “"
             + (text.isEmpty() ? widget.accessibleName() : text).toStdString() + "”";
    };
    QList<const QWidget*> parents{&window};
    for (const QWidget* widget : window.findChildren<QWidget*>()) parents << widget;
    for (const QWidget* parent : std::as_const(parents)) {
        if (!parent->isVisible() || hasPartsOfItsOwn(*parent)) continue;
        QList<const QWidget*> seen;
        for (const QWidget* child :
             parent->findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly)) {
            if (!child->isVisible() || child->isWindow() || child->inherits("QFocusFrame"))
                continue;  // the focus frame overlaps its control
            const bool scrolls = parent->objectName() == QLatin1String("qt_scrollarea_viewport");
            if (!scrolls && !parent->rect().contains(child->geometry()))
                found.push_back(nameOf(*child) + " reaches beyond " + nameOf(*parent) + ", "
                                + std::to_string(child->geometry().left()) + " to "
                                + std::to_string(child->geometry().right()) + " of "
                                + std::to_string(parent->width()) + " x "
                                + std::to_string(parent->height()));
            for (const QWidget* other : std::as_const(seen))
                if (child->geometry().intersects(other->geometry()))
                    found.push_back(nameOf(*child) + " lies upon " + nameOf(*other));
            seen << child;
        }
    }
    return found;
}

/// Returns the overlaps that remain after the layout has settled.
inline std::vector<std::string> overlapsWhenSettled(const QWidget& window)
{
    (void)eventually([&] { return overlaps(window).empty(); });
    return overlaps(window);
}

/// Returns all of these faults with their kinds.
inline std::vector<std::string> cramped(const QWidget& window)
{
    std::vector<std::string> found = overlaps(window);
    for (const std::string& text : cutText(window)) found.push_back("cut: " + text);
    for (const std::string& text : scrolledText(window)) found.push_back("scrolls: " + text);
    return found;
}

/// Paints a widget at one pixel per point. Returns a null image without painting if coordinates are not finite or far
/// outside (PaintWatch). Qt may need seconds for them. A null image is also returned if painting takes this thread too
/// long.
inline QImage painted(QWidget& widget)
{
    PaintWatch watch(widget.size());
    widget.render(&watch);
    if (watch.hostile() > 0) return {};
    QImage image(widget.size(), QImage::Format_ARGB32_Premultiplied);
    image.fill(Qt::transparent);
    constexpr double kMaxLength = 1000.0;  // [ms]; 20 ms is usual
    const double began = threadMilliseconds();
    widget.render(&image);
    return threadMilliseconds() - began < kMaxLength ? image : QImage();
}

/// Waits until a widget looks the same in ten rounds of the event loop. Layout and colours are then final. Not for
/// widgets with live content.
inline void settle(QWidget& widget)
{
    QImage before;
    int rounds = 0;
    (void)eventually([&] {
        const QImage now = painted(widget);
        rounds = now == before ? rounds + 1 : 0;
        before = now;
        return rounds == 10;
    });
}

/// Returns the number of pixels with exactly this colour.
inline int pixelsOf(const QImage& image, const QColor& colour)
{
    int count = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) count += image.pixelColor(x, y) == colour ? 1 : 0;
    return count;
}

/// Returns the number of different colours; more than a handful means that something was drawn.
inline int colours(const QImage& image)
{
    QSet<QRgb> seen;
    for (int y = 0; y < image.height(); y += 2)
        for (int x = 0; x < image.width(); x += 2) seen.insert(image.pixel(x, y));
    return static_cast<int>(seen.size());
}

}  // namespace terratact::gui
