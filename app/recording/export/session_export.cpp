#include "app/recording/export/session_export.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "app/recording/export/payload_signals.h"
#include "app/recording/export/session_exporter.h"
#include "app/runtime/text_output.h"
#include "core/store/file_read.h"

namespace terratact {

namespace {

/// A row besides frames: its time and its writer.
using Other = std::pair<SessionTime, std::function<bool(Exporter&)>>;

std::vector<Other> othersOf(const SessionReader& session, const ExportSelection& selection)
{
    std::vector<Other> others;
    const auto add = [&](const auto& rows) {
        for (const auto& row : rows)
            if (selection.covers(row.time))
                others.emplace_back(row.time, [&row](Exporter& e) { return e.write(row); });
    };
    add(session.estimates());
    add(session.events());
    std::stable_sort(others.begin(), others.end(),
                     [](const Other& a, const Other& b) { return a.first < b.first; });
    return others;
}

/// Returns the DBC messages that occur in the session.
PayloadSignals payloadOf(SessionReader& session, const ExportSelection& selection)
{
    PayloadSignals payload(selection.book);
    for (std::size_t i = 0; payload.hasBook() && i < session.batches().size(); ++i) {
        const SessionBatch& batch = session.batches()[i];
        if (secondsOf(batch.last) < selection.from || secondsOf(batch.first) > selection.to)
            continue;
        for (const FrameRow& row : session.frames(i))
            if (selection.covers(row.time)) payload.note(row.frame);
    }
    payload.name();
    return payload;
}

/// Returns the counts; empty if progress() cancelled.
std::optional<ExportCounts> run(SessionReader& session, Exporter& exporter,
                                const ExportSelection& selection,
                                const std::function<bool(double)>& progress)
{
    ExportCounts counts;
    const std::vector<Other> others = othersOf(session, selection);
    auto other = others.begin();
    exporter.begin();
    const std::size_t batches = session.batches().size();
    for (std::size_t i = 0; exporter.wantsFrames() && i < batches; ++i) {
        if (progress && !progress(static_cast<double>(i) / static_cast<double>(batches)))
            return std::nullopt;
        const SessionBatch& batch = session.batches()[i];
        if (secondsOf(batch.last) < selection.from || secondsOf(batch.first) > selection.to)
            continue;
        for (const FrameRow& frame : session.frames(i)) {
            if (!selection.covers(frame.time)) continue;
            for (; other != others.end() && other->first <= frame.time; ++other)
                counts.others += other->second(exporter) ? 1 : 0;
            const Taken taken = exporter.write(frame);
            counts.frames += taken == Taken::Written ? 1 : 0;
            counts.leftOut += taken == Taken::Inexpressible ? 1 : 0;
        }
    }
    for (; other != others.end(); ++other) counts.others += other->second(exporter) ? 1 : 0;
    exporter.end();
    return counts;
}

std::unique_ptr<Exporter> exporterFor(std::ostream& out, const SessionReader& session,
                                      ExportFormat format, const ExportSelection& selection,
                                      const PayloadSignals& payload)
{
    switch (format) {
    case ExportFormat::Candump: return candumpExporter(out, session.start());
    case ExportFormat::Asc: return ascExporter(out, session.start());
    case ExportFormat::Csv:
        return csvExporter(out, session, selection.what.value_or(ExportKind::Frames), payload);
    case ExportFormat::Mcap: return mcapExporter(out, session, selection.what, payload);
    }
    return nullptr;
}

std::string_view nameOf(ExportKind kind)
{
    switch (kind) {
    case ExportKind::Frames: return "frames";
    case ExportKind::Signals: return "signals";
    case ExportKind::Estimates: return "estimates";
    case ExportKind::Events: break;
    }
    return "events";
}

Message notRecorded(const ExportSelection& selection)
{
    const bool begins = std::isfinite(selection.from), ends = std::isfinite(selection.to);
    if (begins && ends)
        return {TR_NOOP("core", "nothing was recorded from %1 s to %2 s"), selection.from,
                selection.to};
    if (begins) return {TR_NOOP("core", "nothing was recorded from %1 s on"), selection.from};
    if (ends) return {TR_NOOP("core", "nothing was recorded until %1 s"), selection.to};
    return TR_NOOP("core", "nothing was recorded");
}

SourceText noneOf(ExportKind kind)
{
    switch (kind) {
    case ExportKind::Frames: return TR_NOOP("core", "no frames");
    case ExportKind::Signals: return TR_NOOP("core", "no signals");
    case ExportKind::Estimates: return TR_NOOP("core", "no estimates");
    case ExportKind::Events: return TR_NOOP("core", "no events");
    }
    return TR_NOOP("core", "nothing was recorded");
}

/// Returns the reason that nothing was written.
Error nothingOf(const SessionReader& session, const ExportSelection& selection,
                const ExportCounts& counts)
{
    if (counts.leftOut > 0)
        return fileError(
            session.path(),
            Message(
                TR_NOOP("core", "none of the frames can be written in this format: %1 left out"),
                counts.leftOut));
    Message cause = notRecorded(selection);
    if (selection.what) cause = Message::joined(std::move(cause), noneOf(*selection.what));
    const Message length(TR_NOOP("core", "the session lasts %1 s"),
                         fixed(secondsOf(session.end() - session.begin()), 1));
    return fileError(session.path(), Message::joined(std::move(cause), length));
}

}  // namespace

std::optional<ExportFormat> exportFormatFromName(std::string_view text)
{
    if (text == "candump") return ExportFormat::Candump;
    if (text == "asc") return ExportFormat::Asc;
    if (text == "csv") return ExportFormat::Csv;
    if (text == "mcap") return ExportFormat::Mcap;
    return std::nullopt;
}

std::optional<ExportFormat> exportFormatOf(const std::string& path)
{
    const std::size_t dot = path.rfind('.');
    if (dot == std::string::npos) return std::nullopt;
    const std::string ending = path.substr(dot + 1);
    return exportFormatFromName(ending == "log" ? "candump" : ending);
}

std::optional<ExportKind> exportKindFromName(std::string_view text)
{
    for (const ExportKind kind :
         {ExportKind::Frames, ExportKind::Signals, ExportKind::Estimates, ExportKind::Events})
        if (text == nameOf(kind)) return kind;
    return std::nullopt;
}

Result<ExportCounts> writeExport(SessionReader& session, const std::string& path,
                                 ExportFormat format, const ExportSelection& selection,
                                 const std::function<bool(double)>& progress)
{
    const bool framesOnly = format == ExportFormat::Candump || format == ExportFormat::Asc;
    if (framesOnly && selection.what.value_or(ExportKind::Frames) != ExportKind::Frames)
        return fileError(
            path, TR_NOOP("core", "a log of CAN frames holds nothing else; csv and mcap do"));
    Result<TextOutput> out = TextOutput::begin(path);
    if (!out) return out.error();
    const PayloadSignals payload = payloadOf(session, selection);
    auto counts = run(session, *exporterFor(out->stream(), session, format, selection, payload),
                      selection, progress);
    if (counts) counts->withoutColumns = payload.leftOut();
    if (!counts) return fileError(path, TR_NOOP("core", "not written: ended before it was whole"));
    if (counts->frames + counts->others == 0) return nothingOf(session, selection, *counts);
    if (Status done = out->commit(); !done) return done.error();
    return *counts;
}

}  // namespace terratact
