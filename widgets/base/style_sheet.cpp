#include "widgets/base/style_sheet.h"

#include <QFile>
#include <QHash>
#include <QRegularExpression>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "widgets/base/palette.h"

// Q_INIT_RESOURCE must be used outside any namespace; it loads the resources of a static library.
static void loadStyle()
{
    Q_INIT_RESOURCE(style);
}

namespace terratact {
namespace {

QString sheetWithPlaceholders()
{
    loadStyle();
    QFile file(QStringLiteral(":/style/theme.qss"));
    if (!file.open(QIODevice::ReadOnly)) throw std::logic_error("theme.qss is not in the program");
    return QString::fromUtf8(file.readAll());
}

QHash<QString, QColor> coloursOf(const Theme& t)
{
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
        {"warning", t.warning},
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
        {"chipWarning", t.chipWarning},
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
    return colours;
}

}  // namespace

QColor mixed(const QColor& a, const QColor& b, double shareOfB)
{
    const auto between = [shareOfB](int from, int to) {
        return static_cast<int>(std::lround(from + shareOfB * (to - from)));
    };
    return {between(a.red(), b.red()), between(a.green(), b.green()), between(a.blue(), b.blue())};
}

int scaledSmall(int pixels)
{
    return std::min(pixels, scaled(pixels));
}

QString styleSheet(const Theme& theme)
{
    QString sheet = sheetWithPlaceholders();
    sheet.remove(QRegularExpression(QStringLiteral("^/\\*.*?\\*/\n"),
                                    QRegularExpression::DotMatchesEverythingOption));
    const QHash<QString, QColor> colours = coloursOf(theme);
    static const QRegularExpression kWord(QStringLiteral("@(?:(small)?([0-9]+)px|([A-Za-z]+))"));
    for (QRegularExpressionMatch word = kWord.match(sheet); word.hasMatch();
         word = kWord.match(sheet, word.capturedStart())) {
        const QString pixels = word.captured(2), name = word.captured(3);
        const auto sized = word.captured(1).isEmpty() ? scaled : scaledSmall;
        if (pixels.isEmpty() && !colours.contains(name))
            throw std::logic_error("theme.qss: no colour @" + name.toStdString());
        const QString value = pixels.isEmpty() ? colours.value(name).name()
                                               : QStringLiteral("%1px").arg(sized(pixels.toInt()));
        sheet.replace(word.capturedStart(), word.capturedLength(), value);
    }
    return sheet;
}

}  // namespace terratact
