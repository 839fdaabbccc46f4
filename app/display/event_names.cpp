#include <QCoreApplication>
#include <string>

#include "app/display/format.h"

namespace terratact {
namespace {

// Names that events of a session hold. They become shown text here only. core/atem/arming.cpp marks the names of
// arming for translation.
[[maybe_unused]] constexpr const char* kEventNames[] = {
    // What the link did, and what the operator decided.
    QT_TRANSLATE_NOOP("event", "up"),
    QT_TRANSLATE_NOOP("event", "lost"),
    QT_TRANSLATE_NOOP("event", "telemetry lost"),
    QT_TRANSLATE_NOOP("event", "approve"),
    QT_TRANSLATE_NOOP("event", "choose"),
    QT_TRANSLATE_NOOP("event", "drive"),
    QT_TRANSLATE_NOOP("event", "explore"),
    QT_TRANSLATE_NOOP("event", "abort"),
    QT_TRANSLATE_NOOP("event", "feel forward"),
    QT_TRANSLATE_NOOP("event", "forget"),
    QT_TRANSLATE_NOOP("event", "restore"),
    QT_TRANSLATE_NOOP("event", "halt"),
    QT_TRANSLATE_NOOP("event", "let go"),
    QT_TRANSLATE_NOOP("event", "override"),
    QT_TRANSLATE_NOOP("event", "refuse"),
    QT_TRANSLATE_NOOP("event", "release stop"),
    QT_TRANSLATE_NOOP("event", "second method"),
    QT_TRANSLATE_NOOP("event", "stop"),
    QT_TRANSLATE_NOOP("event", "settings"),
    QT_TRANSLATE_NOOP("event", "forward"),
    QT_TRANSLATE_NOOP("event", "back"),
    QT_TRANSLATE_NOOP("event", "none"),
    // The session itself, and marks in it.
    QT_TRANSLATE_NOOP("event", "begun"),
    QT_TRANSLATE_NOOP("event", "continued"),
    QT_TRANSLATE_NOOP("event", "ended"),
    QT_TRANSLATE_NOOP("event", "recovered"),
    QT_TRANSLATE_NOOP("event", "merged"),
    QT_TRANSLATE_NOOP("event", "missing"),
    QT_TRANSLATE_NOOP("event", "log"),
    QT_TRANSLATE_NOOP("event", "clock"),
    QT_TRANSLATE_NOOP("event", "operator"),
    QT_TRANSLATE_NOOP("event", "snapshot"),
    QT_TRANSLATE_NOOP("event", "snapshot note"),
    // Identifiers of alarms.
    QT_TRANSLATE_NOOP("event", "silence"),
    QT_TRANSLATE_NOOP("event", "link"),
    QT_TRANSLATE_NOOP("event", "bus"),
    QT_TRANSLATE_NOOP("event", "foreign"),
    QT_TRANSLATE_NOOP("event", "dropped"),
    QT_TRANSLATE_NOOP("event", "checksum"),
    QT_TRANSLATE_NOOP("event", "sensors"),
    QT_TRANSLATE_NOOP("event", "sensor-fault"),
    QT_TRANSLATE_NOOP("event", "attitude"),
    QT_TRANSLATE_NOOP("event", "model"),
    QT_TRANSLATE_NOOP("event", "panel"),
    QT_TRANSLATE_NOOP("event", "exploration"),
    QT_TRANSLATE_NOOP("event", "recording"),
    // A button of the panel; the others are decisions, too.
    QT_TRANSLATE_NOOP("event", "atem"),
};

constexpr const char* kSimulated = QT_TRANSLATE_NOOP("source", "SIMULATED ROBOT");
constexpr const char* kReplay = QT_TRANSLATE_NOOP("source", "REPLAY %1");

}  // namespace

QString format::eventWord(std::string_view english)
{
    return line(QCoreApplication::translate("event", std::string(english).c_str()).toStdString());
}

QString format::sourceName(std::string_view english)
{
    static const std::string kReplayed =
        std::string(kReplay).substr(0, std::string(kReplay).find('%'));
    if (english == kSimulated) return QCoreApplication::translate("source", kSimulated);
    if (!english.starts_with(kReplayed)) return shownName(english);
    return QCoreApplication::translate("source", kReplay)
        .arg(shownName(english.substr(kReplayed.size())));
}

}  // namespace terratact
