#include "widgets/signals/event_list.h"

#include <QEvent>

#include "widgets/base/palette.h"

namespace terratact {
namespace {

QColor colourOf(Weight weight)
{
    switch (weight) {
    case Weight::Note: return theme().text;
    case Weight::Doubt: return theme().doubt;
    case Weight::Bad: return theme().bad;
    }
    return theme().text;
}

}  // namespace

EventList::EventList(QWidget* parent) : QListWidget(parent)
{
    setAccessibleName(tr("Last minutes"));
    setSelectionMode(QAbstractItemView::NoSelection);
    setFocusPolicy(Qt::TabFocus);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setWordWrap(true);
    setSpacing(0);
    setFrameShape(QFrame::NoFrame);
}

void EventList::add(const QString& text, Weight weight, QTime at)
{
    tell(text, weight, at);
    emit added(text, weight);
}

void EventList::tell(const QString& text, Weight weight, QTime at)
{
    constexpr int kMax = 500;
    static const QString kMarks[]{QString(), QStringLiteral("! "), QStringLiteral("✘ ")};
    const auto level = static_cast<std::size_t>(weight);
    auto* item =
        new QListWidgetItem(at.toString(QStringLiteral("HH:mm:ss  ")) + kMarks[level] + text);
    item->setData(Qt::UserRole, static_cast<int>(weight));
    item->setForeground(colourOf(weight));
    insertItem(0, item);
    while (count() > kMax) delete takeItem(count() - 1);
}

void EventList::changeEvent(QEvent* event)
{
    QListWidget::changeEvent(event);
    if (event->type() != QEvent::StyleChange) return;
    for (int row = 0; row < count(); ++row)
        item(row)->setForeground(
            colourOf(static_cast<Weight>(item(row)->data(Qt::UserRole).toInt())));
}

}  // namespace terratact
