#include "app/shell/preferences/preference_text.h"

#include <QCoreApplication>
#include <algorithm>
#include <array>

#include "app/display/format.h"
#include "app/display/units.h"
#include "app/shell/preferences/pad_text.h"

namespace terratact {
namespace {

struct Described {
    const char* key;
    const char* label;
    bool isSafety = false;
};

constexpr bool kSafety = true;

const std::array<Described, 31> kDescribed{
    {{"theme", QT_TRANSLATE_NOOP("PreferenceText", "theme")},
     {"font-scale", QT_TRANSLATE_NOOP("PreferenceText", "size of text")},
     {"language", QT_TRANSLATE_NOOP("PreferenceText", "language")},
     {"length-unit", QT_TRANSLATE_NOOP("PreferenceText", "unit of lengths")},
     {"angle-unit", QT_TRANSLATE_NOOP("PreferenceText", "unit of angles")},
     {"layout", QT_TRANSLATE_NOOP("PreferenceText", "layout")},
     {"sound", QT_TRANSLATE_NOOP("PreferenceText", "alarms may be heard"), kSafety},
     {"contact-sound", QT_TRANSLATE_NOOP("PreferenceText", "sound of contacts")},
     {"obstacle-limit", QT_TRANSLATE_NOOP("PreferenceText", "step limit"), kSafety},
     {"method", QT_TRANSLATE_NOOP("PreferenceText", "method"), kSafety},
     {"quality", QT_TRANSLATE_NOOP("PreferenceText", "quality")},
     {"estimate-seconds", QT_TRANSLATE_NOOP("PreferenceText", "time limit of an estimate")},
     {"force-threshold", QT_TRANSLATE_NOOP("PreferenceText", "contact force"), kSafety},
     {"probe-policy", QT_TRANSLATE_NOOP("PreferenceText", "the arm is offered")},
     {"probe-above", QT_TRANSLATE_NOOP("PreferenceText", "the arm is offered above a sd of")},
     {"roll-limit", QT_TRANSLATE_NOOP("PreferenceText", "roll limit of the verdict"), kSafety},
     {"hazard-rate", QT_TRANSLATE_NOOP("PreferenceText", "rate of hazards"), kSafety},
     {"asymmetry-limit",
      QT_TRANSLATE_NOOP("PreferenceText", "flipper difference limit of the verdict"), kSafety},
     {"tilt-amber", QT_TRANSLATE_NOOP("PreferenceText", "tilt limit, amber"), kSafety},
     {"tilt-red", QT_TRANSLATE_NOOP("PreferenceText", "tilt limit, red"), kSafety},
     {"record", QT_TRANSLATE_NOOP("PreferenceText", "everything is recorded"), kSafety},
     {"keep-days", QT_TRANSLATE_NOOP("PreferenceText", "delete a session after"), kSafety},
     {"keep-gigabytes", QT_TRANSLATE_NOOP("PreferenceText", "delete the oldest beyond"), kSafety},
     {"may-delete", QT_TRANSLATE_NOOP("PreferenceText", "sessions may be deleted"), kSafety},
     {"model", QT_TRANSLATE_NOOP("PreferenceText", "model file"), kSafety},
     {"robot", QT_TRANSLATE_NOOP("PreferenceText", "robot file, with its torques"), kSafety},
     {"dbc", QT_TRANSLATE_NOOP("PreferenceText", "DBC files")},
     {"gamepad", QT_TRANSLATE_NOOP("PreferenceText", "controls of the gamepad"), kSafety},
     {"gamepad-dead-zone", QT_TRANSLATE_NOOP("PreferenceText", "dead zone of the gamepad"),
      kSafety},
     {"gamepad-speed", QT_TRANSLATE_NOOP("PreferenceText", "speed limit of the gamepad"), kSafety},
     {"plot-sets", QT_TRANSLATE_NOOP("PreferenceText", "saved sets of plots")}}};

const Described* described(const QString& key)
{
    const auto* const found =
        std::find_if(kDescribed.begin(), kDescribed.end(),
                     [&key](const Described& entry) { return key == QLatin1String(entry.key); });
    return found == kDescribed.end() ? nullptr : found;
}

QString shownText(const PreferenceValue& value)
{
    const QString unit = QLatin1String(value.unit);
    if (unit == QLatin1String("rad")) return format::plainAngle(value.text.toDouble());
    if (unit == QLatin1String("m") && units().length == LengthUnit::Centimetre)
        return format::significant(100.0 * value.text.toDouble(), 6) + QStringLiteral(" cm");
    if (!unit.isEmpty()) return value.text + QLatin1Char(' ') + unit;
    if (value.text == QLatin1String("true"))
        return QCoreApplication::translate("PreferenceText", "yes");
    if (value.text == QLatin1String("false"))
        return QCoreApplication::translate("PreferenceText", "no");
    if (value.text.isEmpty()) return QCoreApplication::translate("PreferenceText", "none");
    QString text = value.text;
    return format::line(text.replace(QLatin1Char('\n'), QStringLiteral("; ")).toStdString());
}

/// Returns where a text may be cut at or before `at`, not inside of a character.
qsizetype cutBefore(const QString& text, qsizetype at)
{
    return at > 0 && at < text.size() && text.at(at).isLowSurrogate() ? at - 1 : at;
}

/// Shortens a text beyond 200 characters in its middle.
QString shortMiddle(const QString& text)
{
    constexpr qsizetype kMaxShownText = 200, kBeginShown = 140;
    if (text.size() <= kMaxShownText) return text;
    return text.left(cutBefore(text, kBeginShown)) + QChar(0x2026)
         + text.mid(cutBefore(text, text.size() - (kMaxShownText - kBeginShown - 1)));
}

/// Shortens two long texts so that their first difference stays: their common beginning becomes "…".
void shortenBoth(QString& before, QString& now)
{
    constexpr qsizetype kWhole = 60, kSharedPart = 20;
    if (std::max(before.size(), now.size()) <= kWhole) return;
    const qsizetype least = std::min(before.size(), now.size());
    qsizetype common = 0;
    while (common < least && before.at(common) == now.at(common)) ++common;
    const qsizetype folder =
        common > 0 ? before.left(common).lastIndexOf(QLatin1Char('/')) : qsizetype(-1);
    const qsizetype cut = cutBefore(before, std::max(folder, common - kSharedPart));
    if (cut > 1)
        for (QString* const text : {&before, &now}) *text = QChar(0x2026) + text->mid(cut);
    before = shortMiddle(before);
    now = shortMiddle(now);
}

QString shownControl(const std::optional<PadControl>& control)
{
    if (!control) return QCoreApplication::translate("PreferenceText", "none");
    const auto* const stick = std::get_if<PadStick>(&*control);
    if (!stick) return controlName(*control);
    const char* const sentence = stick->forward < 0
                                   ? QT_TRANSLATE_NOOP("PreferenceText", "%1, forward −")
                                   : QT_TRANSLATE_NOOP("PreferenceText", "%1, forward +");
    return QCoreApplication::translate("PreferenceText", sentence).arg(controlName(*control));
}

/// Adds a change per action of the gamepad.
void addPadChanges(const PadMapping& before, const PadMapping& now, const QString& key,
                   std::vector<PreferenceChange>& changes)
{
    for (std::size_t i = 0; i < kPadActions; ++i) {
        const auto action = static_cast<PadAction>(i);
        if (before[action] == now[action]) continue;
        changes.push_back(
            {key,
             QCoreApplication::translate("PreferenceText", "gamepad: %1").arg(actionName(action)),
             shownControl(before[action]), shownControl(now[action]), isSafetyRelevant(key)});
    }
}

}  // namespace

QString preferenceLabel(const QString& key)
{
    const Described* const entry = described(key);
    return entry ? QCoreApplication::translate("PreferenceText", entry->label) : QString();
}

bool isSafetyRelevant(const QString& key)
{
    const Described* const entry = described(key);
    return entry && entry->isSafety;
}

std::vector<PreferenceChange> changesBetween(const Preferences& before, const Preferences& now)
{
    const auto old = valuesOf(before), wanted = valuesOf(now);
    std::vector<PreferenceChange> changes;
    for (std::size_t i = 0; i < old.size(); ++i) {
        const QString key = QLatin1String(old[i].key);
        if (old[i].text == wanted[i].text || !described(key)) continue;
        if (key == QLatin1String("gamepad")) {
            addPadChanges(before.pad.mapping, now.pad.mapping, key, changes);
            continue;
        }
        QString was = shownText(old[i]), will = shownText(wanted[i]);
        shortenBoth(was, will);
        changes.push_back({key, preferenceLabel(key), was, will, isSafetyRelevant(key)});
    }
    std::stable_partition(changes.begin(), changes.end(),
                          [](const PreferenceChange& change) { return change.isSafety; });
    return changes;
}

}  // namespace terratact
