#pragma once

#include <QString>

class QAction;
class QPoint;
class QTableWidgetItem;
class QWidget;

namespace terratact {

/// Returns a wrapping tip that shows the text literally, because text from a file may contain HTML.
QString plainTip(const QString& text);

// All tips are set by these functions, which show the text literally. Text that Qt does not take for HTML is stored
// unchanged.
void setTip(QWidget& widget, const QString& text);
void setTip(QAction& action, const QString& text);
void setTip(QTableWidgetItem& cell, const QString& text);
void showTip(const QPoint& global, const QString& text, QWidget* widget);

/// Returns the text of the widget's tip without the escapes of plainTip().
QString tipOf(const QWidget& widget);

/// Makes every plot of this process show plain text only.
void keepPlotsPlain();

}  // namespace terratact
