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
#include <array>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "tests/support/paint_watch.h"
#include "tests/support/thread_time.h"

/// What the GUI tests share.
namespace terratact::gui {

/// Each of them is STOP, everywhere.
inline constexpr std::array kStopKeys{Qt::Key_F12, Qt::Key_Pause};

/// Values no painter may ever see.
inline constexpr std::array kHostile{
    std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
    -std::numeric_limits<double>::infinity(), std::numeric_limits<double>::max(), -1e300};

/// Runs the event loop until the condition holds; false after `patience`.
template <class Condition>
bool eventually(Condition&& condition, int patience = 20000)
{
    return QTest::qWaitFor(std::forward<Condition>(condition), patience);
}

/// Shows a widget and gives it the focus of its window.
inline void showActive(QWidget& widget)
{
    widget.show();
    (void)QTest::qWaitForWindowExposed(&widget);
    widget.activateWindow();
    (void)QTest::qWaitForWindowActive(&widget);
}

/// Every text of a visible widget: what it shows, its tip and what a screen reader says; line by line, each run of
/// digits as '#'.
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

/// What can be read in a window: the texts of its visible labels, buttons, bars and tables, and of what is drawn what a
/// screen reader says of it.
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

/// The tips of buttons while they can be pressed and while they cannot: then they have to say why not.
class TipsOfButtons {
public:
    /// Takes those of the buttons that are seen now.
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
    /// The names of buttons that were seen both ways.
    std::set<std::string> compared() const
    {
        std::set<std::string> names;
        for (const auto& [button, tips] : tips_)
            if (!tips.enabled.empty() && !tips.disabled.empty()) names.insert(tips.name);
        return names;
    }
    /// Of those that cannot be pressed: with no tip, or one that they have where they can, too.
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

inline constexpr int kHeaderFrame = 10;  // [px] around a column's name: padding and border

/// The texts of the cells in view that are less high than they need, or narrower and no tip says all.
inline std::vector<std::string> cutCells(const QTableView& table)
{
    constexpr int kFrame = 2;  // [px] of sizeHintForIndex() around the text that is nobody's loss
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

/// The texts of visible labels, buttons, bars, columns' names and cells that have less room than they need.
inline std::vector<std::string> cutText(const QWidget& window)
{
    std::vector<std::string> cut;
    const auto poll = [&](const QWidget& widget, const QString& text, const QSize& needed) {
        if (!widget.isVisible() || text.isEmpty()) return;
        if (widget.width() + 1 < needed.width() || widget.height() + 1 < needed.height())
            cut.push_back(text.toStdString());
    };
    for (const QLabel* label : window.findChildren<QLabel*>())
        if (!label->inherits("terratact::ElidedLabel"))  // its tip says all
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

/// Those of them that remain once the layout has come to rest.
inline std::vector<std::string> cutWhenSettled(const QWidget& window)
{
    (void)eventually([&] { return cutText(window).empty(); }, 2000);
    return cutText(window);
}

/// The texts of lines that end in "…" for want of room; their tips say all.
inline std::vector<std::string> elidedText(const QWidget& window)
{
    std::vector<std::string> elided;
    for (const QLabel* label : window.findChildren<QLabel*>())
        if (label->isVisible() && label->inherits("terratact::ElidedLabel")
            && label->width() < label->sizeHint().width())
            elided.push_back(label->text().toStdString());
    return elided;
}

/// What has to be scrolled to be read, of what should be seen at once.
inline std::vector<std::string> scrolledText(const QWidget& window)
{
    std::vector<std::string> scrolled;
    for (const QScrollArea* area : window.findChildren<QScrollArea*>())
        if (area->isVisible() && area->inherits("terratact::ScrollColumn")
            && area->verticalScrollBar()->maximum() > 0)
            scrolled.push_back(area->accessibleName().toStdString());
    return scrolled;
}

/// Whether a widget's parts are laid out by somebody else than us: Qt's and Qwt's own, of which some lie upon others.
inline bool hasPartsOfItsOwn(const QWidget& widget)
{
    for (const QWidget* at = &widget; at; at = at->parentWidget())
        if (at->inherits("QwtPlot")) return true;
    for (const char* kind : {"QAbstractScrollArea", "QAbstractSpinBox", "QComboBox"})
        if (widget.inherits(kind)) return true;
    return false;
}

/// Pairs of visible neighbours that lie upon each other, and what reaches beyond the widget it is in.
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
                continue;  // the frame of the focus lies upon what has it
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

/// Those that remain once the layout has come to rest.
inline std::vector<std::string> overlapsWhenSettled(const QWidget& window)
{
    (void)eventually([&] { return overlaps(window).empty(); }, 2000);
    return overlaps(window);
}

/// All of that, with what it is.
inline std::vector<std::string> cramped(const QWidget& window)
{
    std::vector<std::string> found = overlaps(window);
    for (const std::string& text : cutText(window)) found.push_back("cut: " + text);
    for (const std::string& text : scrolledText(window)) found.push_back("scrolls: " + text);
    return found;
}

/// Paints a widget, one pixel to a point whatever the screen has; fails by returning a null image, and paints nothing,
/// where a painter would be asked for what is not finite or far off: Qt may take seconds for it (PaintWatch).  A null
/// image, too, where painting takes this thread as long for whatever reason.
inline QImage painted(QWidget& widget)
{
    PaintWatch watch(widget.size());
    widget.render(&watch);
    if (watch.hostile() > 0) return {};
    QImage image(widget.size(), QImage::Format_ARGB32_Premultiplied);
    image.fill(Qt::transparent);
    constexpr double kMaxLength = 1000.0;  // [ms]; some 20 is usual
    const double began = threadMilliseconds();
    widget.render(&image);
    return threadMilliseconds() - began < kMaxLength ? image : QImage();
}

/// Until a widget looks the same in ten rounds of the event loop: laid out, and drawn in the colours in force.  Not for
/// one that shows what is live.
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

/// How many pixels of an image have exactly this colour.
inline int pixelsOf(const QImage& image, const QColor& colour)
{
    int count = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) count += image.pixelColor(x, y) == colour ? 1 : 0;
    return count;
}

/// How many different colours an image has: more than a handful when something was drawn.
inline int colours(const QImage& image)
{
    QSet<QRgb> seen;
    for (int y = 0; y < image.height(); y += 2)
        for (int x = 0; x < image.width(); x += 2) seen.insert(image.pixel(x, y));
    return static_cast<int>(seen.size());
}

}  // namespace terratact::gui
