#include "tests/app/console/screens/screens_texts.h"

#include <QRegularExpression>
#include <algorithm>

#include "app/display/format.h"
#include "core/wire/frame_layout.h"

namespace terratact {
namespace {

/// Names of frames and signals, which are the same in every language.
const QRegularExpression& namesOfTheBus()
{
    static const QRegularExpression kNames = [] {
        QStringList names;
        for (const FrameLayout& layout : frameLayouts()) {
            names << format::text(layout.name);
            for (const SignalLayout& signal : layout.payload) names << format::text(signal.name);
        }
        names.replaceInStrings(QRegularExpression("[0-9]+"), "#");
        std::sort(names.begin(), names.end(),  // longest first
                  [](const QString& a, const QString& b) { return a.size() > b.size(); });
        return QRegularExpression(names.join('|'));
    }();
    return kNames;
}

/// Returns the pattern of a text with placeholders (%1).
QRegularExpression patternOf(const QString& text)
{
    static const QRegularExpression kPlaces(QStringLiteral("\\\\%[1-9]"));
    QString pattern = QRegularExpression::escape(text);
    return QRegularExpression(pattern.replace(kPlaces, QStringLiteral(".*")),
                              QRegularExpression::CaseInsensitiveOption
                                  | QRegularExpression::DotMatchesEverythingOption);
}

}  // namespace

bool isSameEverywhere(const std::string& text)
{
    static const QRegularExpression kNames(
        "\\b(pa|pac|pafc|pafac|local|joint|clearance|trail|Absolem|Terratact|SIMULATED ROBOT|"
        "REPLAY|English|Deutsch|Eigen|Qwt|OpenBLAS.*|Linux.*|R-hat|ESS|AVX|rad|STOP|Token|"
        "terratact (simulate|train) "
        ".*|[Mm]odel|[Gg]amepad|[Pp]anel|[Rr]obot|Bus|Start|Status|Name|Training|"
        "Signal|Rate|Bytes|REC|Export|Format|Details)\\b|can#|"
        "\\b(Ctrl|Alt|PgUp|PgDown|Home|End|Esc|Del|Backspace)\\b|"  // key names of these languages
        "/usr/share/doc/terratact/copyright|candump|Vector|Foxglove|Čeština|\\bbit\\b|UTC|/min\\b|"
        "[^ ]*\\.(ttm|toml|csv|log|tts|png|svg|pdf|html|mcap|asc)\\b|"
        // texts of the system and of substitute drivers
        "/proc/terratact|no such chip");
    static const QRegularExpression kWord("[A-Za-z]{3}");
    QString rest = QString::fromStdString(text);
    return !rest.remove(kNames).remove(namesOfTheBus()).contains(kWord);
}

bool isWordsOfAFile(const std::string& text)
{
    return text.starts_with("<p ") || text.ends_with("</p>");
}

std::set<std::string> partsOf(const std::string& text)
{
    static const QRegularExpression kJoints(QStringLiteral(" · | — |: "));
    std::set<std::string> parts{text};
    for (const QString& part : QString::fromStdString(text).split(kJoints))
        parts.insert(part.toStdString());
    return parts;
}

QStringList missingIn(const QStringList& texts, const QStringList& says)
{
    QStringList missing;
    for (const QString& text : says) {
        const QRegularExpression pattern = patternOf(text);
        const bool isThere =
            std::ranges::any_of(texts, [&](const QString& read) { return read.contains(pattern); });
        if (!isThere) missing << text;
    }
    return missing;
}

}  // namespace terratact
