#include "widgets/look.h"

#include <QApplication>
#include <QFont>
#include <QLabel>
#include <QPalette>
#include <QStyle>
#include <QStyleFactory>

#include "widgets/palette.h"

namespace terratact {
namespace {

QString styleSheet()
{
    QString sheet = QStringLiteral(R"(
QToolTip { color: @text; background: #fffbe6; border: 1px solid @border; padding: 4px; }
QFrame[card="true"] { background: @card; border: 1px solid @border; border-radius: 6px; }
QLabel[heading="true"] { font-weight: bold; }
QLabel[tone="muted"] { color: @muted; }
QLabel[tone="strong"] { font-weight: bold; }
QLabel[tone="good"] { color: @good; }
QLabel[tone="doubt"] { color: @doubt; }
QLabel[tone="bad"] { color: @bad; font-weight: bold; }
QLabel[tone="accent"] { color: @accent; font-weight: bold; }

QPushButton { background: @button; color: @text; border: 1px solid #b9c5d0; border-radius: 5px;
              padding: 4px 12px; min-height: @targetpx; }
QPushButton:hover { background: #d8e0e8; }
QPushButton:pressed { background: @down; }
QPushButton:focus { border: 2px solid @contact; padding: 3px 11px; }
QPushButton:disabled { background: #f1f4f7; color: #5d6a77; border-color: #d5dde5; }
QPushButton[role="primary"] { background: @contact; color: white; border-color: #0d3f7a; font-weight: bold; }
QPushButton[role="primary"]:hover { background: #1b66bd; }
QPushButton[role="primary"]:pressed { background: #0d3f7a; }
QPushButton[role="primary"]:focus { border: 2px solid @text; }
QPushButton[role="primary"]:disabled { background: #f1f4f7; color: #5d6a77; border-color: #d5dde5; }
QPushButton[role="stop"] { background: @stop; color: white; border: 2px solid #ffffff; border-radius: 6px;
                           font-size: 20px; font-weight: bold; min-width: 184px; min-height: 36px; padding: 0 16px; }
QPushButton[role="stop"]:hover { background: #d92626; }
QPushButton[role="stop"]:pressed { background: #8e0f0f; }
QPushButton[role="stop"]:focus { border: 3px solid @source; }
QPushButton[latched="true"] { background: #7d0b0b; border: 2px dashed #ffffff; }

QLabel#verdictBadge { border-radius: 6px; padding: 6px 2px; min-width: 172px; font-size: 19px; font-weight: bold;
                      color: #ffffff; }
QLabel#verdictBadge[outlook="clear"] { background: @good; }
QLabel#verdictBadge[outlook="blocked"] { background: @bad; }
QLabel#verdictBadge[outlook="open"] { background: @doubt; }
QLabel#verdictBadge[outlook="none"] { background: @button; color: @muted; }
QLabel#verdictQuestion { font-size: 16px; font-weight: bold; }
QPushButton[role="compact"] { padding: 3px 3px; font-size: 13px; }
QPushButton[role="small"] { padding: 5px 4px; min-width: 26px; font-size: 18px; font-weight: bold; }

QFrame#navigationRail { background: @header; }
QFrame#navigationRail QPushButton { background: transparent; color: @headertext; border: none; padding: 4px 6px;
                                    min-width: 78px; min-height: 40px; }
QFrame#navigationRail QPushButton:hover { background: #33444f; }
QFrame#navigationRail QPushButton:checked { background: #33444f; color: @source; border-left: 4px solid @source;
                                            padding-left: 2px; }
QFrame#navigationRail QPushButton:focus { border: 2px solid @source; }

QFrame#statusHeader { background: @header; }
QFrame#statusHeader QPushButton[role="quiet"] { background: #33444f; color: @headertext; border-color: #4d606d; }
QFrame#statusHeader QPushButton[role="quiet"]:disabled { color: #b4c0c9; border-color: #46565f; }
QFrame#statusHeader QPushButton[role="alarm"] { background: #8e1414; color: #ffffff; border: 2px solid #ffffff; font-weight: bold; }
QFrame#statusHeader QPushButton[role="armed"] { background: #9a5b00; color: #ffffff; border-color: #ffd9a0; font-weight: bold; }
QFrame#statusHeader QLabel { color: @headertext; }
QFrame#statusHeader QLabel#sourceName { color: @source; font-size: 19px; font-weight: bold; }
QFrame#statusHeader QLabel[chip="true"] { border-radius: 5px; padding: 5px 10px; background: #33444f; }
QFrame#statusHeader QLabel[chip="true"][tone="good"] { background: #1f5a35; color: #e2f7e8; }
QFrame#statusHeader QLabel[chip="true"][tone="doubt"] { background: #7a4a00; color: #fff1d6; }
QFrame#statusHeader QLabel[chip="true"][tone="bad"] { background: #8e1414; color: #ffffff; }
QFrame#statusHeader QLabel[chip="true"][tone="accent"] { background: #55217c; color: #f3e6ff; }
QLabel#banner { background: #8e1414; color: white; font-weight: bold; padding: 7px 16px; }

QProgressBar { border: 1px solid #b9c5d0; border-radius: 4px; background: @card; color: @text;
               text-align: center; min-height: 20px; }
QProgressBar::chunk { background: #a9c8ea; border-radius: 3px; }
QTableView { background: @card; alternate-background-color: @window; border: none; color: @text; }
QTableView::item { padding: 0 6px; }
QHeaderView { background: @card; }
QHeaderView::section { background: @button; color: @text; border: none; border-right: 1px solid @border; padding: 4px 6px; }
QLineEdit { background: @card; color: @text; border: 1px solid @muted; border-radius: 4px; padding: 2px 8px; }
QLineEdit:focus { border: 2px solid @contact; padding: 1px 7px; }
QListWidget { background: @card; border: none; color: @text; }
QListWidget::item { padding: 2px 0; }
)");
    const std::pair<const char*, QString> words[]{
        {"@window", theme().window.name()},
        {"@headertext", theme().headerText.name()},
        {"@header", theme().header.name()},
        {"@text", theme().text.name()},
        {"@muted", theme().muted.name()},
        {"@card", theme().card.name()},
        {"@border", theme().cardBorder.name()},
        {"@good", theme().good.name()},
        {"@doubt", theme().doubt.name()},
        {"@bad", theme().bad.name()},
        {"@accent", theme().accent.name()},
        {"@button", theme().button.name()},
        {"@down", theme().buttonDown.name()},
        {"@contact", theme().contact.name()},
        {"@stop", theme().stop.name()},
        {"@source", theme().source.name()},
        {"@target", QString::number(kTarget - 10)},
    };
    for (const auto& [word, value] : words) sheet.replace(QLatin1String(word), value);
    return sheet;
}

}  // namespace

const Theme& theme()
{
    static const Theme day;
    return day;
}

void applyLook(QApplication& application)
{
    QApplication::setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
    QPalette colours;
    colours.setColor(QPalette::Window, theme().window);
    colours.setColor(QPalette::WindowText, theme().text);
    colours.setColor(QPalette::Base, theme().card);
    colours.setColor(QPalette::Text, theme().text);
    colours.setColor(QPalette::Button, theme().button);
    colours.setColor(QPalette::ButtonText, theme().text);
    colours.setColor(QPalette::Highlight, theme().contact);
    colours.setColor(QPalette::ToolTipText, theme().text);
    QApplication::setPalette(colours);
    QFont font = QApplication::font();
    font.setPixelSize(14);
    QApplication::setFont(font);
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
