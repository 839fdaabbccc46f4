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
    // What is still told in English alone is looked up whole.
    if (message.context.empty() && message.arguments.empty())
        return format::sentence(message.source);
    return format::text(inLanguage(message));
}

}  // namespace terratact
