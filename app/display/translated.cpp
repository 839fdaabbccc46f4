#include "app/display/translated.h"

#include <QCoreApplication>

#include "app/display/format.h"

namespace terratact {
namespace {

std::string inLanguage(const Message& message)
{
    std::string source =
        message.context.empty()
            ? message.source
            : QCoreApplication::translate(message.context.c_str(), message.source.c_str())
                  .toStdString();
    if (message.arguments.empty()) return source;
    return terratact::filled(source, [&message](std::size_t place) {
        return place <= message.arguments.size() ? inLanguage(message.arguments[place - 1])
                                                 : std::string();
    });
}

}  // namespace

QString translated(const Message& message)
{
    return format::text(inLanguage(message));
}

QString translatedLine(const Message& message)
{
    return translated(message).replace(QLatin1Char('\n'), QLatin1Char(' '));
}

Message verbatim(const QString& text)
{
    return Message::verbatim(text.toStdString());
}

}  // namespace terratact
