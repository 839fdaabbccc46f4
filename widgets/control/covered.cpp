#include "widgets/control/covered.h"

#include <QApplication>
#include <QWidget>
#include <algorithm>

namespace terratact {

bool isCovered(const QWidget& widget)
{
    const QRect here(widget.mapToGlobal(QPoint()), widget.size());
    return std::ranges::any_of(QApplication::topLevelWidgets(), [&](const QWidget* other) {
        const Qt::WindowType type = other->windowType();
        const bool isDialog = type == Qt::Window || type == Qt::Dialog || type == Qt::Tool;
        const QWidget* const parent = other->parentWidget();
        const bool isAbove = type == Qt::Popup  // a menu may have no parent
                          || (isDialog && parent && parent->window() == widget.window());
        return isAbove && other->isVisible() && !other->isMinimized()
            && other->frameGeometry().intersects(here);
    });
}

}  // namespace terratact
