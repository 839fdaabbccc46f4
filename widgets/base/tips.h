#pragma once

#include <QString>

class QAction;
class QPoint;
class QTableWidgetItem;
class QWidget;

namespace terratact {

/// A tip that wraps and shows the text as it is: somebody's file may say what looks like HTML.
QString plainTip(const QString& text);

// The only ways to a tip: each shows the text as it is.  A text that does not look like HTML is kept letter by letter.
void setTip(QWidget& widget, const QString& text);
void setTip(QAction& action, const QString& text);
void setTip(QTableWidgetItem& cell, const QString& text);
void showTip(const QPoint& global, const QString& text, QWidget* widget);

/// The text of the widget's tip, without the marks that keep it plain.
QString tipOf(const QWidget& widget);

/// From now on the plots of this process show each text as it is.
void keepPlotsPlain();

}  // namespace terratact
