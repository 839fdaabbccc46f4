#include "app/mission/signal_rows.h"

#include <QCoreApplication>
#include <QStringList>

#include "app/display/format.h"
#include "app/display/translated.h"
#include "app/link/can_text.h"
#include "core/limits.h"
#include "core/wire/dbc/dbc_text.h"

namespace terratact {
namespace {

struct SignalRowText {
    Q_DECLARE_TR_FUNCTIONS(terratact::SignalsPage)
};

/// Returns the frame's kind in the robot's protocol; empty: none.
std::optional<FrameKind> kindOf(const CanFrame& frame)
{
    const bool mayBeOurs = !frame.error && !frame.extended && !frame.remote && !frame.fd;
    return mayBeOurs ? kindOfId(frame.id) : std::nullopt;
}

/// Returns the text of wordsOf(). Names and texts from DBC files are the same in every language.
QString contentOf(const std::vector<NamedValue>& values)
{
    if (isNotMeasured(values)) return translated(TR_NOOP("core", "not measured"));
    QStringList parts;
    for (const NamedValue& value : values)
        parts << QStringLiteral("%1 %2 %3")
                     .arg(format::text(value.name),
                          value.shown.empty() ? format::text(value.value) : translated(value.shown),
                          format::text(shownDbcText(value.unit)))
                     .trimmed();
    return parts.join(QStringLiteral(", "));
}

SignalRow::Standing standingOf(const TappedFrame& frame)
{
    using Standing = SignalRow::Standing;
    if (!frame.age || !frame.isMeasured) return Standing::Stale;
    if (*frame.age <= kStaleAfter) return Standing::Fresh;
    const bool isCyclic = frame.kind && layoutOf(*frame.kind).period > 0.0;
    return isCyclic ? Standing::Stale : Standing::Said;
}

QString withMinus(QString number)
{
    return number.replace(QLatin1Char('-'), QChar(0x2212));
}

QString valueText(const SignalLayout& layout, const std::optional<double>& value)
{
    return value ? withMinus(translated(wordOf(layout, *value))) : format::kNothing;
}

/// Returns false for identifiers, which have no meaningful extremes.
bool isQuantity(const SignalLayout& layout)
{
    return !layout.unit.empty();
}

SignalRow rowOf(const TappedFrame& frame, const SignalLayout& layout, const TappedSignal& signal)
{
    SignalRow row;
    row.name = format::text(layout.name);
    row.unit = format::text(layout.unit);
    row.rate = frame.rate;
    row.age = frame.age;
    row.standing = standingOf(frame);
    if (layout.name == "Measured" && frame.age && *frame.age <= kStaleAfter)
        row.standing = SignalRow::Standing::Fresh;
    row.value = valueText(layout, signal.last);
    if (isQuantity(layout)) {
        row.least = valueText(layout, signal.least);
        row.most = valueText(layout, signal.most);
    }
    row.history.assign(signal.history.begin(), signal.history.end());
    return row;
}

QString valueText(const DbcSignal& signal, const std::optional<double>& value)
{
    if (!value) return format::kNothing;
    const QString text = format::text(wordOrNumber(signal, *value));
    return wordOf(signal, *value) ? text : withMinus(text);
}

/// Returns the newest value with all its digits.
QString newestText(const DbcSignal& signal, const TappedSignal& tapped)
{
    if (!tapped.last) return format::kNothing;
    const QString text = format::text(wordOrNumber(signal, tapped.bits));
    return wordOfBits(signal, tapped.bits) ? text : withMinus(text);
}

/// Returns Stale for an old value of a periodic message, Said for one of an occasional message.
SignalRow::Standing standingOf(const SignalTimes& times, const DbcMessage& message)
{
    using Standing = SignalRow::Standing;
    if (!times.age) return Standing::Stale;
    if (*times.age <= times.fresh) return Standing::Fresh;
    return message.period() > 0.0 ? Standing::Stale : Standing::Said;
}

SignalRow rowOf(const DbcMessage& message, const DbcSignal& layout, const TappedSignal& signal,
                const SignalTimes& times)
{
    SignalRow row;
    row.name = format::text(layout.name);
    row.unit = format::text(shownDbcText(layout.unit));
    row.rate = times.rate;
    row.age = times.age;
    row.standing = standingOf(times, message);
    row.value = newestText(layout, signal);
    if (layout.words.empty()) {
        row.least = valueText(layout, signal.least);
        row.most = valueText(layout, signal.most);
    }
    row.history.assign(signal.history.begin(), signal.history.end());
    row.meaning = format::text(layout.comment);
    return row;
}

void addRobots(std::vector<SignalRow>& rows, const TappedFrame& frame,
               std::span<const DbcMessage> protocol)
{
    const DbcMessage* said =
        protocol.empty() ? nullptr : &protocol[static_cast<std::size_t>(*frame.kind)];
    const auto layout = layoutOf(*frame.kind).payload;
    for (std::size_t i = 0; i < layout.size(); ++i) {
        rows.push_back(rowOf(frame, layout[i], frame.payload[i]));
        if (said)
            rows.back().meaning = format::text(said->signal(std::string(layout[i].name)).comment);
    }
}

SignalRow wholeFrame(const TappedFrame& frame)
{
    SignalRow row;
    row.rate = frame.rate;
    row.age = frame.age;
    row.standing = standingOf(frame);
    row.value = format::text(bytesText(frame.newest));
    return row;
}

QString nameOf(const TappedFrame& frame)
{
    return frame.described ? format::text(frame.described->message.name)
                           : frameName(frame.newest, nullptr);
}

QString meaningOf(const TappedFrame& frame, std::span<const DbcMessage> protocol)
{
    if (frame.kind && !protocol.empty())
        return format::text(protocol[static_cast<std::size_t>(*frame.kind)].comment);
    if (!frame.described) return {};
    const DbcMessage& message = frame.described->message;
    return SignalRowText::tr("%1, as %2 describes it; sent by %3\n%4")
        .arg(format::text(message.name), format::text(frame.described->file),
             format::text(message.sender), format::text(message.comment))
        .trimmed();
}

}  // namespace

std::vector<SignalRow> signalRows(const std::vector<TappedFrame>& frames,
                                  std::span<const DbcMessage> protocol)
{
    std::vector<SignalRow> rows;
    for (const TappedFrame& frame : frames) {
        const std::size_t first = rows.size();
        if (frame.kind) addRobots(rows, frame, protocol);
        if (frame.described) {
            const DbcMessage& message = frame.described->message;
            for (std::size_t i = 0; i < frame.payload.size(); ++i)
                rows.push_back(
                    rowOf(message, message.payload[i], frame.payload[i], frame.times[i]));
        }
        if (rows.size() == first) rows.push_back(wholeFrame(frame));
        rows[first].frame =
            QStringLiteral("%1 %2").arg(format::text(idText(frame.newest)), nameOf(frame));
        rows[first].frameMeaning = meaningOf(frame, protocol);
    }
    return rows;
}

QString frameName(const CanFrame& frame, const DbcBook* book)
{
    if (frame.error) return SignalRowText::tr("error frame");
    if (const auto kind = kindOf(frame)) return format::text(layoutOf(*kind).name);
    const auto described = book ? book->find(frame) : nullptr;
    return described ? format::text(described->message.name) : SignalRowText::tr("unknown");
}

TraceText traceText(const CanFrame& frame, const std::shared_ptr<const DbcBook>& book)
{
    // A new reader, so that the text does not depend on earlier frames.
    const FrameWords said = frameReader(CanProtocol::Terratact, book)->read(frame, 0.0);
    return {.id = format::text(idText(frame)),
            .name = frameName(frame, book.get()),
            .bytes = format::text(bytesText(frame)),
            .content = said.values.empty() && frame.error ? format::text(said.verdict)
                                                          : contentOf(said.values)};
}

}  // namespace terratact
