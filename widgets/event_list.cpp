#include "widgets/event_list.h"

#include "widgets/palette.h"

namespace terratact {

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
    constexpr int kMost = 500;
    static const QString kMarks[]{QString(), QStringLiteral("! "), QStringLiteral("✘ ")};
    const QColor colours[]{theme().text, theme().doubt, theme().bad};
    const auto level = static_cast<std::size_t>(weight);
    auto* item =
        new QListWidgetItem(at.toString(QStringLiteral("HH:mm:ss  ")) + kMarks[level] + text);
    item->setForeground(colours[level]);
    insertItem(0, item);
    while (count() > kMost) delete takeItem(count() - 1);
}

}  // namespace terratact
