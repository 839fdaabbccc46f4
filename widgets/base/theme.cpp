#include "widgets/base/theme.h"

#include <QApplication>
#include <QFont>
#include <QHash>
#include <QLabel>
#include <QPalette>
#include <QRegularExpression>
#include <QStyle>
#include <QToolTip>
#include <cmath>

#include "widgets/base/focus_mark.h"
#include "widgets/base/palette.h"
#include "widgets/base/spoken.h"
#include "widgets/base/target_style.h"
#include "widgets/base/tips.h"

namespace terratact {
namespace {

LookInForce inForce;
Theme current;  ///< theme in use

QColor mixed(const QColor& a, const QColor& b, double shareOfB)
{
    const auto between = [shareOfB](int from, int to) {
        return static_cast<int>(std::lround(from + shareOfB * (to - from)));
    };
    return {between(a.red(), b.red()), between(a.green(), b.green()), between(a.blue(), b.blue())};
}

/// Placeholders of the style sheet: @name is a colour. @nameArea and @nameText are a fill's colours, @nameHover and
/// @nameDown its area under the mouse and pressed. @12px is a length at the font scale.
QString styleSheet()
{
    QString sheet = QStringLiteral(R"(
QToolTip { color: @text; background: @tip; border: 1px solid @buttonBorder; padding: @4px; }
QFrame[card="true"] { background: @card; border: 1px solid @border; border-radius: 6px; }
QLabel[heading="true"] { font-weight: bold; }
QLabel[headline="true"] { font-size: @15px; font-weight: bold; }
QLabel[tone="muted"] { color: @muted; }
QLabel[tone="strong"] { font-weight: bold; }
QLabel[tone="good"] { color: @good; }
QLabel[tone="doubt"] { color: @doubt; }
QLabel[tone="bad"] { color: @bad; font-weight: bold; }
QLabel[tone="accent"] { color: @accent; font-weight: bold; }

QPushButton { background: @buttonArea; color: @buttonText; border: 1px solid @buttonBorder; border-radius: 5px;
              padding: 4px @12px; min-height: @24px; }
QPushButton:hover { background: @buttonHover; }
QPushButton:pressed { background: @buttonDown; }
QPushButton:focus { border: 2px solid @focus; padding: 3px @11px; }
QPushButton:disabled { background: @offArea; color: @offText; border-color: @offBorder; }
QPushButton[role="primary"] { background: @primaryArea; color: @primaryText; border-color: @primaryDown; font-weight: bold; }
QPushButton[role="primary"]:hover { background: @primaryHover; }
QPushButton[role="primary"]:pressed { background: @primaryDown; }
QPushButton[role="primary"]:focus { border: 2px solid @text; }
QPushButton[role="primary"]:disabled { background: @offArea; color: @offText; border-color: @offBorder; font-weight: normal; }
QPushButton[role^="stop"] { background: @stopArea; color: @stopText; border: 2px solid @stopBorder; border-radius: 6px;
                            font-size: @20px; font-weight: bold; min-width: 184px; min-height: @36px; padding: 0 16px; }
QPushButton[role="stop"]:hover { background: @stopHover; }
QPushButton[role="stopNotSent"] { background: @stopArea; color: @stopText; border: 4px dashed @source; }
QPushButton[role="stopSent"] { background: @cautionArea; color: @cautionText; border: 2px solid @source; }
QPushButton[role="stopped"] { background: @stoppedArea; color: @stoppedText; border: 2px dashed @stopBorder; }
QPushButton[role^="stop"]:pressed { background: @stopDown; color: @stopText; }
QPushButton[role^="stop"]:focus { border: 3px solid @source; }
QPushButton[role="stopNone"], QPushButton[role="stopNone"]:pressed { background: @chipArea; color: @chipOffText;
  border: 2px dashed @chipBorder; font-size: @16px; font-weight: normal; }

QLabel#verdictBadge { border-radius: 6px; padding: 6px 2px; font-size: @19px; font-weight: bold; }
QLabel#verdictBadge[answer="clear"] { background: @clearArea; color: @clearText; }
QLabel#verdictBadge[answer="blocked"] { background: @blockedArea; color: @blockedText; }
QLabel#verdictBadge[answer="open"] { background: @openArea; color: @openText; }
QLabel#verdictBadge[answer="none"] { background: @offArea; color: @offText; }
QLabel#verdictQuestion { font-size: @16px; font-weight: bold; }
QLabel#verdictQuestion[tone="muted"] { font-weight: normal; }
QPushButton[role="compact"] { padding: 3px 3px; font-size: @13px; }
QPushButton[role="flat"] { background: transparent; color: @muted; border-color: transparent; padding: 3px 4px; font-size: @13px; }
QPushButton[role="flat"]::menu-indicator { subcontrol-origin: padding; subcontrol-position: center right; }
QPushButton[role="flat"]:hover, QPushButton[role="flat"]:pressed { background: @buttonHover; color: @buttonText; }
QPushButton[role="flat"]:focus { border: 2px solid @focus; padding: 2px 3px; }
QPushButton[role="small"] { padding: 5px 4px; min-width: @26px; font-size: @18px; font-weight: bold; }

QFrame#navigationRail { background: @header; }
QFrame#navigationRail QPushButton { background: transparent; color: @headerText; border: none; padding: 4px 6px;
                                    min-width: @78px; min-height: @40px; }
QFrame#navigationRail[dense="true"] QPushButton { min-height: 26px; }
QFrame#navigationRail QPushButton:hover { background: @chipHover; }
QFrame#navigationRail QPushButton:checked { background: @chipArea; color: @source; border-left: 4px solid @source;
                                            padding-left: 2px; }
QFrame#navigationRail QPushButton[asks="true"] { background: @chipAccentArea; color: @chipAccentText; }
QFrame#navigationRail QPushButton[role="alarm"] { background: @chipBadArea; color: @chipBadText; }
QFrame#navigationRail QPushButton:focus { border: 2px solid @source; }

QFrame#statusHeader { background: @header; }
QFrame#statusHeader QPushButton[role="quiet"] { background: @chipArea; color: @chipText; border-color: @chipBorder; }
QFrame#statusHeader QPushButton[role="quiet"]:focus, QFrame#statusHeader QPushButton[role="caution"]:focus { border-color: @source; }
QFrame#statusHeader QPushButton[role="quiet"]:disabled { color: @chipOffText; border-color: @chipBorder; }
QFrame#statusHeader QPushButton[role="alarm"] { background: @chipBadArea; color: @chipBadText; border: 2px solid @stopBorder; font-weight: bold; }
QFrame#statusHeader QPushButton[role="caution"] { background: @chipDoubtArea; color: @chipDoubtText; border-color: @chipBorder; }
QFrame#statusHeader QPushButton[role="armed"] { background: @cautionArea; color: @cautionText; border-color: @source; font-weight: bold; }
QFrame#statusHeader QLabel { color: @headerText; }
QFrame#statusHeader QLabel#sourceName { color: @source; font-size: @17px; font-weight: bold; }
QFrame#statusHeader QLabel[chip="true"] { border: 1px solid @chipBorder; border-radius: 5px; padding: 4px 8px;
                                          background: @chipArea; color: @chipText; }
QFrame#statusHeader QLabel[chip="true"][tone="good"] { background: @chipGoodArea; color: @chipGoodText; }
QFrame#statusHeader QLabel[chip="true"][tone="doubt"] { background: @chipDoubtArea; color: @chipDoubtText; }
QFrame#statusHeader QLabel[chip="true"][tone="bad"] { background: @chipBadArea; color: @chipBadText; }
QFrame#statusHeader QLabel[chip="true"][tone="accent"] { background: @chipAccentArea; color: @chipAccentText; }
QScrollArea#scrollColumn { border: 1px solid transparent; }
QScrollArea#scrollColumn:focus { border: 1px solid @focus; }
QLabel#banner { background: @bannerArea; color: @bannerText; font-weight: bold; padding: 7px 16px; }
QLabel#question { background: @chipAccentArea; color: @chipAccentText; font-weight: bold; padding: 7px 16px; }
QLabel#safeStrip { background: @cautionArea; color: @cautionText; font-size: @13px; padding: 2px 16px; }
QLabel#reviewStrip { background: @cautionArea; color: @cautionText; font-weight: bold; padding: 5px 12px; }

QMenu { background: @card; color: @text; border: 1px solid @buttonBorder; }
QMenu::item { padding: @9px @28px; }
QMenu::item:selected { background: @primaryArea; color: @primaryText; }
QMenu::item:disabled { color: @offText; }
QMenu::indicator { width: @14px; height: @14px; left: @7px; }
QMenu::separator { height: 1px; background: @border; margin: 4px 0; }

QProgressBar { border: 1px solid @buttonBorder; border-radius: 4px; background: @card; color: @doneText;
               text-align: center; min-height: @20px; }
QProgressBar::chunk { background: @doneArea; border-radius: 3px; }
QTableView { background: @card; alternate-background-color: @window; border: none; color: @text; gridline-color: @border; }
QTableView::item { padding: 0 6px; }
QHeaderView { background: @card; }
QHeaderView::section { background: @buttonArea; color: @buttonText; border: 1px solid @border; padding: 4px; }
QTableCornerButton::section { background: @buttonArea; border: 1px solid @border; }
QLineEdit { background: @card; color: @text; border: 1px solid @muted; border-radius: 4px; padding: 2px 8px; }
QLineEdit:focus { border: 2px solid @focus; padding: 1px 7px; }
QListWidget { background: @card; border: none; color: @text; }
QListWidget::item { padding: 2px 0; }
)");
    const Theme& t = current;
    QHash<QString, QColor> colours{
        {"window", t.window},
        {"text", t.text},
        {"muted", t.muted},
        {"card", t.card},
        {"border", t.cardBorder},
        {"tip", t.tip},
        {"header", t.header},
        {"headerText", t.headerText},
        {"source", t.source},
        {"good", t.good},
        {"doubt", t.doubt},
        {"bad", t.bad},
        {"accent", t.accent},
        {"focus", t.contact},
        {"buttonBorder", t.buttonBorder},
        {"offBorder", t.offBorder},
        {"stopBorder", t.stopBorder},
        {"chipBorder", t.chipBorder},
        {"chipOffText", t.chipOffText},
    };
    const std::pair<QString, Fill> fills[]{
        {"button", t.button},
        {"off", t.off},
        {"primary", t.primary},
        {"stop", t.stop},
        {"stopped", t.stopped},
        {"caution", t.caution},
        {"chip", t.chip},
        {"chipGood", t.chipGood},
        {"chipDoubt", t.chipDoubt},
        {"chipBad", t.chipBad},
        {"chipAccent", t.chipAccent},
        {"banner", t.banner},
        {"done", t.done},
        {"clear", t.clear},
        {"blocked", t.blocked},
        {"open", t.open},
    };
    for (const auto& [name, fill] : fills) {
        colours[name + "Area"] = fill.area;
        colours[name + "Text"] = fill.text;
        colours[name + "Hover"] = mixed(fill.area, fill.text, 0.1);
        colours[name + "Down"] = mixed(fill.area, QColor(Qt::black), 0.3);
    }
    static const QRegularExpression kWord(QStringLiteral("@(?:([0-9]+)px|([A-Za-z]+))"));
    for (QRegularExpressionMatch word = kWord.match(sheet); word.hasMatch();
         word = kWord.match(sheet, word.capturedStart())) {
        const QString pixels = word.captured(1);
        const QString value = pixels.isEmpty() ? colours.value(word.captured(2)).name()
                                               : QStringLiteral("%1px").arg(scaled(pixels.toInt()));
        sheet.replace(word.capturedStart(), word.capturedLength(), value);
    }
    return sheet;
}

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
    colours.setColor(QPalette::Link, t.contact);
    colours.setColor(QPalette::ToolTipBase, t.tip);
    colours.setColor(QPalette::ToolTipText, t.text);
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
        colours.setColor(QPalette::Disabled, role, t.off.text);
    return colours;
}

/// Removes the style sheet without notifying widgets. The next sheet notifies each widget once.
void dropSheet(QApplication& application)
{
    QWidgetList untold;
    for (QWidget* widget : QApplication::allWidgets()) {
        if (!widget->testAttribute(Qt::WA_WState_Polished)
            || widget->testAttribute(Qt::WA_SetStyle))
            continue;
        // QApplication::setStyle() uses these two attributes to select the widgets it notifies.
        widget->setAttribute(Qt::WA_WState_Polished, false);
        widget->setAttribute(Qt::WA_SetStyle);
        untold << widget;
    }
    application.setStyleSheet(QString());
    for (QWidget* widget : untold) {
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
    // A style sheet wraps the style; a second style would be wrapped, too.
    if (first) QApplication::setStyle(new TargetStyle);
    // Each of these three calls visits every widget.
    if (letters) {
        QFont font = QApplication::font();
        font.setPixelSize(scaled(14));
        QApplication::setFont(font);
        QToolTip::setFont(font);
    }
    if (colours) QApplication::setPalette(paletteOf(current));
    // Replacing a sheet restyles each widget once per ancestor (Qt 6.4). Setting the first sheet restyles it once.
    if (!first) dropSheet(application);
    application.setStyleSheet(styleSheet());
}

void setTone(QLabel& label, Tone tone)
{
    static constexpr const char* kNames[]{"plain", "muted", "strong", "good",
                                          "doubt", "bad",   "accent"};
    const QString wanted = QLatin1String(kNames[static_cast<int>(tone)]);
    if (label.property("tone").toString() == wanted) return;
    label.setProperty("tone", wanted);
    label.style()->unpolish(&label);
    label.style()->polish(&label);
}

}  // namespace terratact
