#include "app/shell/preferences/settings_file.h"

#include <QDir>
#include <QFileInfo>
#include <QSet>
#include <QStringDecoder>
#include <QUrl>
#include <algorithm>
#include <utility>

#include "app/display/format.h"
#include "app/display/translated.h"
#include "app/shell/preferences/preference_values.h"
#include "core/store/file_read.h"
#include "core/store/file_write.h"

namespace terratact {
namespace {

constexpr std::size_t kMaxSettingsBytes = std::size_t{1} << 20U;
constexpr qsizetype kMaxProfileName = 60;  // characters
constexpr qsizetype kMaxProfileNameBytes = 200;
const QString kHeadKey = QStringLiteral("terratact-settings");
const QString kEnding = QStringLiteral(".settings");

bool isPathKey(const QString& key)
{
    return key == QLatin1String("model") || key == QLatin1String("robot")
        || key == QLatin1String("dbc");
}

/// What windows remember, which is no setting.
bool isOfWindows(const QString& key)
{
    return key == QLatin1String("window") || key == QLatin1String("session-folder");
}

bool isKept(const PreferenceValue& value, SettingsScope scope)
{
    const QString key = QLatin1String(value.key);
    if (isOfWindows(key)) return false;
    if (isPathKey(key)) return scope == SettingsScope::ThisComputer;
    return true;
}

/// Returns true if a line of a file gives the text back.
bool fitsLine(const QString& text)
{
    return text == text.trimmed() && !text.contains(QLatin1Char('\n'))
        && !text.contains(QLatin1Char('\r'));
}

/// Refusal of a line.
Error refusal(const std::string& path, qsizetype line, const Message& why)
{
    return fileError(path, {TR_NOOP("SettingsFile", "line %1: %2"), line, why});
}

Message noValue(const QString& text, const QString& key, const Message& expected)
{
    return {TR_NOOP("SettingsFile", "“%1” is no valid %2; expected: %3"),
            verbatim(text.left(40).simplified()), verbatim(key.left(40)), expected};
}

Message numberWithUnit(const char* unit)
{
    return {TR_NOOP("SettingsFile", "a number in %1"), unit};
}

/// Reads the lines one after the other.
class LineReader {
public:
    explicit LineReader(const std::string& path) : path_(path), known_(valuesOf(Preferences{})) {}

    /// Returns an Error to stop.
    Status read(const QString& line, qsizetype number)
    {
        const QString trimmed = line.trimmed();
        if (trimmed.isEmpty() || trimmed.startsWith(QLatin1Char('#'))) return Done{};
        const qsizetype equals = trimmed.indexOf(QLatin1Char('='));
        const QString key = trimmed.left(std::max<qsizetype>(equals, 0)).trimmed();
        const QString text = equals < 0 ? trimmed : trimmed.mid(equals + 1).trimmed();
        if (!begun_) return head(key, text, number);
        if (key.isEmpty())
            return refusal(path_, number,
                           {TR_NOOP("SettingsFile", "“%1” is no setting; expected: key = value"),
                            verbatim(trimmed.left(40))});
        return entry(key, text, number);
    }
    bool begun() const { return begun_; }
    SettingsFile take() { return std::move(file_); }

private:
    Status head(const QString& key, const QString& text, qsizetype number)
    {
        bool isNumber = false;
        const int version = text.toInt(&isNumber);
        if (key != kHeadKey || !isNumber || version < 1)
            return refusal(
                path_, number,
                {TR_NOOP("SettingsFile", "this is no file of settings; expected first: %1 = %2"),
                 verbatim(kHeadKey), kSettingsVersion});
        if (version > kSettingsVersion)
            return refusal(path_, number,
                           {TR_NOOP("SettingsFile",
                                    "version %1 is of a newer Terratact; expected: version %2. "
                                    "Update this program, or export the settings from its version"),
                            version, kSettingsVersion});
        begun_ = true;
        return Done{};
    }
    Status entry(const QString& key, const QString& text, qsizetype number)
    {
        const auto known = std::find_if(known_.begin(), known_.end(), [&key](const auto& value) {
            return key == QLatin1String(value.key);
        });
        if (known == known_.end() || isOfWindows(key))
            return refusal(
                path_, number,
                {TR_NOOP("SettingsFile", "“%1” is no setting; expected: a setting of this version"),
                 verbatim(key.left(40))});
        if (seen_.contains(key) && !known->isList)
            return refusal(
                path_, number,
                {TR_NOOP("SettingsFile", "%1 appears twice; expected: once"), verbatim(key)});
        return value(*known, text, number);
    }
    Status value(const PreferenceValue& known, const QString& text, qsizetype number)
    {
        const QString key = QLatin1String(known.key);
        QString plain = text;
        if (const QLatin1String unit(known.unit); !unit.isEmpty()) {
            if (!plain.endsWith(QLatin1Char(' ') + unit))
                return refusal(path_, number, noValue(text, key, numberWithUnit(known.unit)));
            plain.chop(unit.size() + 1);
            plain = plain.trimmed();
        }
        if (isPathKey(key) && !plain.isEmpty() && !QFileInfo(plain).isFile())
            return refusal(path_, number,
                           noValue(text, key, TR_NOOP("SettingsFile", "a file of this computer")));
        QString whole = plain;
        if (known.isList && seen_.contains(key))
            whole = file_.entries[at_.value(key)].text + QLatin1Char('\n') + plain;
        if (const auto expected = setValue(tried_, key, whole))
            return refusal(path_, number, noValue(text, key, *expected));
        if (seen_.contains(key)) {
            file_.entries[at_.value(key)].text = whole;
        } else {
            at_.insert(key, file_.entries.size());
            file_.entries.push_back({key, whole});
        }
        seen_.insert(key);
        return Done{};
    }

    const std::string& path_;
    std::vector<PreferenceValue> known_;
    bool begun_ = false;
    SettingsFile file_;
    Preferences tried_;
    QSet<QString> seen_;
    QHash<QString, std::size_t> at_;
};

}  // namespace

std::string settingsText(const Preferences& preferences, SettingsScope scope)
{
    QStringList text{
        QStringLiteral("# Settings of Terratact. SI units stand behind each number."),
        QStringLiteral("# A setting that is left out keeps its value when the file is imported."),
        QStringLiteral("%1 = %2").arg(kHeadKey).arg(kSettingsVersion)};
    for (const PreferenceValue& value : valuesOf(preferences)) {
        if (!isKept(value, scope)) continue;
        const QString key = QLatin1String(value.key), unit = QLatin1String(value.unit);
        const QStringList lines =
            value.isList ? value.text.split(QLatin1Char('\n')) : QStringList{value.text};
        if (!std::all_of(lines.begin(), lines.end(), fitsLine)) {
            text << QStringLiteral("# %1 is left out: its text does not fit a line").arg(key);
            continue;
        }
        for (const QString& line : lines) {
            const QStringList parts{key + QStringLiteral(" ="), line, unit};
            text << parts.join(QLatin1Char(' ')).trimmed();
        }
    }
    return text.join(QLatin1Char('\n')).toStdString().append("\n");
}

Result<SettingsFile> readSettings(const std::string& content, const std::string& path)
{
    QStringDecoder decoder(QStringDecoder::Utf8);
    LineReader reader(path);
    std::size_t begin = 0;
    for (qsizetype number = 1; begin < content.size(); ++number) {
        const std::size_t end = std::min(content.find('\n', begin), content.size());
        const QString line = decoder.decode(
            QByteArrayView(content.data() + begin, static_cast<qsizetype>(end - begin)));
        if (decoder.hasError() || line.contains(QChar(0)))
            return refusal(path, number,
                           TR_NOOP("SettingsFile", "this is no text; expected: UTF-8"));
        if (const Status read = reader.read(line, number); !read) return read.error();
        begin = end + 1;
    }
    if (!reader.begun())
        return refusal(
            path, 1,
            {TR_NOOP("SettingsFile", "this is no file of settings; expected first: %1 = %2"),
             verbatim(kHeadKey), kSettingsVersion});
    return reader.take();
}

Result<SettingsFile> readSettingsFile(const std::string& path)
{
    // A pipe would block the window.
    if (const QFileInfo info(QString::fromStdString(path)); info.exists() && !info.isFile())
        return fileError(path, TR_NOOP("SettingsFile", "is no file"));
    const auto content = readFile(path, kMaxSettingsBytes);
    if (!content) return content.error();
    return readSettings(*content, path);
}

Status writeSettings(const std::string& path, const Preferences& preferences, SettingsScope scope,
                     bool replaces)
{
    if (!replaces && QFileInfo::exists(QString::fromStdString(path)))
        return fileError(
            path,
            TR_NOOP("SettingsFile", "the file exists and was not replaced; choose another name"));
    const Access access =
        scope == SettingsScope::ThisComputer ? Access::OwnerAlways : Access::Everybody;
    if (scope == SettingsScope::ThisComputer) {
        const std::string folder = QFileInfo(QString::fromStdString(path)).path().toStdString();
        if (Status made = makeDirectory(folder, Access::Owner); !made) return made;
    }
    return writeFileAtomically(path, settingsText(preferences, scope), access);
}

Preferences withSettings(Preferences preferences, const SettingsFile& file)
{
    for (const SettingsFile::Entry& entry : file.entries)
        setValue(preferences, entry.key, entry.text);
    return preferences;
}

QString profileFolder()
{
    const QString path = preferencesPath();
    return path.isEmpty() ? QString() : QFileInfo(path).path() + QStringLiteral("/profiles");
}

QStringList profilesIn(const QString& folder)
{
    QStringList names;
    if (folder.isEmpty()) return names;
    for (const QString& file : QDir(folder).entryList({QLatin1Char('*') + kEnding}, QDir::Files)) {
        const QString name = QUrl::fromPercentEncoding(file.chopped(kEnding.size()).toLatin1());
        if (!whyNoProfileName(name) && profilePath(folder, name).endsWith(QLatin1Char('/') + file))
            names << name;
    }
    names.sort(Qt::CaseInsensitive);
    return names;
}

QString profilePath(const QString& folder, const QString& name)
{
    // A dot is encoded, too: no name is a folder or hidden.
    return folder + QLatin1Char('/')
         + QString::fromLatin1(QUrl::toPercentEncoding(name, QByteArray(), QByteArray(".")))
         + kEnding;
}

std::optional<Message> whyNoProfileName(const QString& name)
{
    if (name.trimmed().isEmpty() || name != name.trimmed())
        return Message(TR_NOOP("SettingsFile", "a profile needs a name"));
    if (name.size() > kMaxProfileName
        || QUrl::toPercentEncoding(name).size() > kMaxProfileNameBytes)
        return Message(TR_NOOP("SettingsFile", "a profile's name has at most %1 letters"),
                       kMaxProfileName);
    if (format::line(name.toStdString()) != name)
        return Message(TR_NOOP("SettingsFile", "a profile's name is one line of plain text"));
    return std::nullopt;
}

}  // namespace terratact
