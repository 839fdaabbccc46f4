#include "widgets/base/theme.h"

#include <QApplication>
#include <QFont>
#include <QLabel>
#include <QPalette>
#include <QStyle>
#include <QToolTip>
#include <algorithm>

#include "widgets/base/focus_mark.h"
#include "widgets/base/hidden_pages.h"
#include "widgets/base/late_style.h"
#include "widgets/base/palette.h"
#include "widgets/base/spoken.h"
#include "widgets/base/style_sheet.h"
#include "widgets/base/target_style.h"
#include "widgets/base/tips.h"

namespace terratact {
namespace {

LookInForce inForce;
Theme current;  ///< theme in use

QPalette paletteOf(const Theme& t)
{
    QPalette colours;
    colours.setColor(QPalette::Window, t.window);
    colours.setColor(QPalette::WindowText, t.text);
    colours.setColor(QPalette::Base, t.card);
    colours.setColor(QPalette::AlternateBase, mixed(t.card, t.text, 0.05));
    colours.setColor(QPalette::Text, t.text);
    colours.setColor(QPalette::PlaceholderText, t.muted);
    colours.setColor(QPalette::Button, t.button.area);
    colours.setColor(QPalette::ButtonText, t.button.text);
    colours.setColor(QPalette::Highlight, t.primary.area);
    colours.setColor(QPalette::HighlightedText, t.primary.text);
#if QT_VERSION >= QT_VERSION_CHECK(6, 6, 0)
    colours.setColor(QPalette::Accent, t.primary.area);
#endif
    colours.setColor(QPalette::Link, t.contact);
    colours.setColor(QPalette::ToolTipBase, t.tip);
    colours.setColor(QPalette::ToolTipText, t.text);
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
        colours.setColor(QPalette::Disabled, role, t.off.text);
    return colours;
}

/// Keeps Qt's record of the colours that widgets had before a style sheet. Qt deletes it with the last sheet in use.
/// From Qt 6.5 on, widgets would then keep the text colours of the previous sheet.
void keepColoursOfWidgets()
{
    static QWidget* const withSheet = new QWidget;
    withSheet->setStyleSheet(QStringLiteral("QWidget {}"));
}

/// Removes the style sheet without notifying widgets. The next sheet notifies each widget once; a sheet that replaces
/// another notifies each widget once per ancestor.
void dropSheet(QApplication& application)
{
    QWidgetList unnotified;
    for (QWidget* widget : QApplication::allWidgets()) {
        if (!widget->testAttribute(Qt::WA_WState_Polished)
            || widget->testAttribute(Qt::WA_SetStyle))
            continue;
        // QApplication::setStyle() uses these two attributes to select the widgets it notifies.
        widget->setAttribute(Qt::WA_WState_Polished, false);
        widget->setAttribute(Qt::WA_SetStyle);
        unnotified << widget;
    }
    application.setStyleSheet(QString());
    for (QWidget* widget : unnotified) {
        widget->setAttribute(Qt::WA_WState_Polished);
        widget->setAttribute(Qt::WA_SetStyle, false);
    }
}

}  // namespace

const Theme& theme()
{
    return current;
}

int scaled(int pixels)
{
    return (pixels * inForce.fontScale + 50) / 100;
}

int scaledLarge(int pixels)
{
    return inForce.fontScale <= 100 ? scaled(pixels) : std::max(pixels, scaled(pixels) * 3 / 4);
}

LookInForce lookInForce()
{
    return inForce;
}

void applyLook(QApplication& application, ThemeName name, int fontScale)
{
    const bool first = application.styleSheet().isEmpty();
    const bool colours = first || name != inForce.theme,
               letters = first || fontScale != inForce.fontScale;
    if (!colours && !letters) return;
    current = themeOf(name);
    inForce = {name, fontScale};
    installSpokenLabels();
    keepPlotsPlain();
    markFocus(application);
    restyleHiddenAreasLate(application);
    // Without a style sheet the font costs half. Each of the calls below visits every widget.
    if (first) {
        // A style sheet wraps the style; a second style would be wrapped, too.
        QApplication::setStyle(new TargetStyle);
        keepColoursOfWidgets();
    } else {
        postponeHiddenPages(application);
        dropSheet(application);
    }
    if (letters) {
        QFont font = QApplication::font();
        font.setPixelSize(scaled(14));
        QApplication::setFont(font);
        QToolTip::setFont(font);
    }
    if (colours) QApplication::setPalette(paletteOf(current));
    application.setStyleSheet(styleSheet(current));
}

void setTone(QLabel& label, Tone tone)
{
    static constexpr const char* kNames[]{"plain",   "muted", "strong", "good",
                                          "warning", "bad",   "accent"};
    const QString wanted = QLatin1String(kNames[static_cast<int>(tone)]);
    if (label.property("tone").toString() == wanted) return;
    label.setProperty("tone", wanted);
    label.style()->unpolish(&label);
    label.style()->polish(&label);
}

}  // namespace terratact
