#pragma once

#include <gtest/gtest.h>

#include <QGuiApplication>
#include <QRegularExpression>
#include <QSet>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "app/display/format.h"
#include "app/display/translated.h"
#include "app/start/language.h"
#include "core/base/message.h"
#include "core/base/result.h"

namespace terratact {

inline const std::string kSource = TERRATACT_SOURCE_DIR;

/// Returns the plain words of a text. Quoted parts of the file, keys, columns, numbers and paths are data.
inline QStringList plainWords(QString text)
{
    static const QRegularExpression kQuoted(
        QStringLiteral("(?<!\\w)'[^']*'|\"[^\"]*\"|`[^`]*`|\\[\\[?[a-z_]+\\]\\]?"));
    static const QRegularExpression kPlain(QStringLiteral("^[\\p{L}'’-]{2,}$"));
    static const QRegularExpression kBetween(QStringLiteral("[\\s,;:()…]+"));
    text.remove(kQuoted);
    return text.split(kBetween, Qt::SkipEmptyParts).filter(kPlain);
}

/// Leaves out the words of foreign parsers, which are not translated: they stand in the last place.
inline Message withoutForeign(Message message)
{
    static const char* const kForeign[]{"line %1: is not TOML: %2", "its structure is damaged: %1",
                                        "malformed database schema %1"};
    for (Message& argument : message.arguments) argument = withoutForeign(std::move(argument));
    for (const char* const source : kForeign)
        if (message.source == source) message.arguments.back() = Message::verbatim("…");
    return message;
}

/// Error sentences of the readers, one of each form.
class Refusals {
public:
    /// data: plain words that such a file contains: keys, tables, names.
    explicit Refusals(QSet<QString> data) : data_(std::move(data)) {}

    template <class Value>
    void add(const Result<Value>& read)
    {
        if (!read) add(read.error().message);
    }
    void add(const Message& refusal)
    {
        static const QRegularExpression kData(
            QStringLiteral("'[^']*'|[0-9][-+.0-9e]*|[a-z_]*_[a-z_]*"));
        Message message = withoutForeign(refusal);
        const QString english = format::text(message.english());
        forms_.emplace(QString(english).replace(kData, QStringLiteral("…")), std::move(message));
    }
    std::size_t size() const { return forms_.size(); }

    void expectTranslated() const
    {
        for (const char* language : {"cs", "de"}) {
            ASSERT_EQ(installLanguage(*qApp, language), QLatin1String(language));
            for (const auto& [form, message] : forms_) {
                const QString english = format::text(message.english());
                const QString translated = terratact::translated(message);
                EXPECT_NE(translated, english) << language;
                for (const QString& word : englishIn(english, translated))
                    ADD_FAILURE() << language << ": \"" << word.toStdString() << "\" is left in \""
                                  << translated.toStdString() << "\"";
            }
        }
        installLanguage(*qApp, "en");
    }

private:
    QStringList englishIn(const QString& english, const QString& translated) const
    {
        // Names, units and words that the languages share.
        static const QSet<QString> kSame{
            "SQLite",      "TOML",  "Terratact",  "ISO",   "IEEE",    "CAN",           "DBC",
            "FD",          "XL",    "ERRORFRAME", "float", "double",  "little-endian", "rad",
            "in",          "model", "text",       "bit",   "flipper", "program",       "offset",
            "multiplexor", "CSV",   "PDF",        "gzip"};
        const QStringList left = plainWords(translated);
        QStringList found;
        for (const QString& word : plainWords(english))
            if (left.contains(word) && !kSame.contains(word) && !data_.contains(word))
                found << word;
        return found;
    }

    QSet<QString> data_;
    std::map<QString, Message> forms_;  ///< form without data, and its first sentence
};

inline std::vector<std::string> linesOf(const std::string& text)
{
    std::vector<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

inline std::string joined(const std::vector<std::string>& lines)
{
    std::string text;
    for (const std::string& line : lines) text += line + "\n";
    return text;
}

}  // namespace terratact
