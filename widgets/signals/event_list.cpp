#include "widgets/signals/event_list.h"

#include <QEvent>

#include "app/display/translated.h"
#include "widgets/base/palette.h"

namespace terratact {
namespace {

QColor colourOf(EventSeverity severity)
{
    switch (severity) {
    case EventSeverity::Note: return theme().text;
    case EventSeverity::Warning: return theme().warning;
    case EventSeverity::Bad: return theme().bad;
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

void EventList::add(const Message& text, EventSeverity severity, QTime at, EventPlace place)
{
    log(translated(text), severity, at);
    emit added(text, severity, place);
}

void EventList::add(const QString& text, EventSeverity severity, QTime at)
{
    log(text, severity, at);
    emit added(verbatim(text), severity, EventPlace::ListOnly);
}

void EventList::log(const QString& text, EventSeverity severity, QTime at)
{
    constexpr int kMax = 500;
    static const QString kMarks[]{QString(), QStringLiteral("! "), QStringLiteral("✘ ")};
    const auto level = static_cast<std::size_t>(severity);
    auto* item =
        new QListWidgetItem(at.toString(QStringLiteral("HH:mm:ss  ")) + kMarks[level] + text);
    item->setData(Qt::UserRole, static_cast<int>(severity));
    item->setForeground(colourOf(severity));
    insertItem(0, item);
    while (count() > kMax) delete takeItem(count() - 1);
}

void EventList::changeEvent(QEvent* event)
{
    QListWidget::changeEvent(event);
    if (event->type() != QEvent::StyleChange) return;
    for (int row = 0; row < count(); ++row)
        item(row)->setForeground(
            colourOf(static_cast<EventSeverity>(item(row)->data(Qt::UserRole).toInt())));
}

}  // namespace terratact
