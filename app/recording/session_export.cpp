#include "app/recording/session_export.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <memory>
#include <utility>
#include <vector>

#include "app/recording/mcap_writer.h"
#include "app/recording/payload_signals.h"
#include "app/recording/session_text.h"
#include "app/runtime/text_output.h"
#include "core/base/text.h"
#include "core/learn/data/columns.h"
#include "core/robot/robot_model.h"
#include "core/store/csv_text.h"
#include "core/store/file_read.h"
#include "core/wire/can_codec.h"
#include "core/wire/candump_log.h"
#include "core/wire/frame_layout.h"
#include "core/wire/log_text.h"
#include "core/wire/telemetry_listener.h"

namespace terratact {

namespace {

constexpr std::int64_t kSecond = 1'000'000'000;  // [ns]

/// Result of offering a frame to an exporter.
enum class Taken {
    Written,
    PassedOver,    ///< the frame has nothing of the selected kind
    Inexpressible  ///< the format cannot express the frame
};

/// Receives the selected rows of a session in time order and writes them in one format.
class Exporter {
public:
    virtual ~Exporter() = default;
    virtual bool wantsFrames() const { return true; }
    virtual void begin() {}
    virtual Taken take(const FrameRow&) { return Taken::PassedOver; }
    /// Returns false if this kind of row was not selected.
    virtual bool take(const EstimateRow&) { return false; }
    virtual bool take(const EventRow&) { return false; }
    virtual void end() {}
};

/// Returns the bus's name in the form that a log allows.
std::string interfaceName(const SessionStart& start)
{
    std::string name = start.bus.substr(0, 15);
    std::erase_if(name, [](char c) { return c <= ' ' || c > '~'; });
    return name.empty() ? "can0" : name;
}

class CandumpExporter final : public Exporter {
public:
    CandumpExporter(std::ostream& out, const SessionStart& start) : out_(out), start_(start) {}

    Taken take(const FrameRow& row) override
    {
        if (row.frame.isCut) return Taken::Inexpressible;
        const double time = static_cast<double>(wallTimeOf(start_, row.time)) * 1e-9;
        out_ << candumpLine(time, interface_, row.frame) << '\n';
        return Taken::Written;
    }

private:
    std::ostream& out_;
    const SessionStart& start_;
    std::string interface_ = interfaceName(start_);
};

/// Vector's format, as written by log2asc and read by asc2log and python-can.
class AscExporter final : public Exporter {
public:
    AscExporter(std::ostream& out, const SessionStart& start) : out_(out), start_(start) {}

    void end() override
    {
        if (!base_) writeHeader(wallTimeOf(start_, 0));
    }

    Taken take(const FrameRow& row) override
    {
        const CanFrame& frame = row.frame;
        const std::int64_t wall = wallTimeOf(start_, row.time);
        if (!base_) writeHeader(wall);
        const std::int64_t time = wall - *base_;
        if (frame.isCut || time < 0) return Taken::Inexpressible;
        const std::string moment = fmt::format("{:4}.{:06}", time / kSecond, time % kSecond / 1000);
        if (frame.error) {
            out_ << moment << " 1  ErrorFrame\n";
            return Taken::Written;
        }
        const std::string id = fmt::format("{:X}{}", frame.id, frame.extended ? "x" : "");
        if (frame.fd) {
            writeFd(moment, id, row);
            return Taken::Written;
        }
        out_ << fmt::format("{} 1  {:<15} {}   {} {:d}", moment, id, row.sent ? "Tx" : "Rx",
                            frame.remote ? 'r' : 'd', frame.length);
        for (std::size_t i = 0; i < frame.length && !frame.remote; ++i)
            out_ << fmt::format(" {:02X}", frame.data.at(i));
        out_ << '\n';
        return Taken::Written;
    }

private:
    /// Unknown flags are 0; 3000 marks a CAN FD frame with bit rate switching.
    void writeFd(const std::string& moment, const std::string& id, const FrameRow& row)
    {
        unsigned code = 0;
        while (bytesOfCode(code) < row.frame.length) ++code;
        out_ << fmt::format("{} CANFD   1 {:<4} {:>8}  {:>32} 1 0 {:x} {:>2}", moment,
                            row.sent ? "Tx" : "Rx", id, "", code, row.frame.length);
        for (const std::uint8_t byte : bytesOf(row.frame)) out_ << fmt::format(" {:02X}", byte);
        out_ << "        0    0     3000        0        0        0        0        0\n";
    }

    /// Writes the header, whose date has whole seconds. first: [ns] since 1970; a recording may begin before its time
    /// 0.
    void writeHeader(std::int64_t first)
    {
        base_ = std::min(first, wallTimeOf(start_, 0)) / kSecond * kSecond;
        const std::time_t seconds = *base_ / kSecond;
        std::tm when{};
        localtime_r(&seconds, &when);
        constexpr std::array kDays{"Sun", "Mon", "Tue", "Wed", "Thu", "Fri", "Sat"};
        constexpr std::array kMonths{"Jan", "Feb", "Mar", "Apr", "May", "Jun",
                                     "Jul", "Aug", "Sep", "Oct", "Nov", "Dec"};
        out_ << fmt::format("date {} {} {:02} {:02}:{:02}:{:02} {}\n",
                            kDays.at(static_cast<std::size_t>(when.tm_wday)),
                            kMonths.at(static_cast<std::size_t>(when.tm_mon)), when.tm_mday,
                            when.tm_hour, when.tm_min, when.tm_sec, 1900 + when.tm_year)
             << "base hex  timestamps absolute\nno internal events logged\n";
    }

    std::ostream& out_;
    const SessionStart& start_;
    std::optional<std::int64_t> base_;  ///< [ns] since 1970 of the file's time 0
};

std::string hexBytes(const CanFrame& frame)
{
    std::string text;
    for (const std::uint8_t byte : bytesOf(frame)) text += fmt::format("{:02X}", byte);
    return text;
}

class CsvExporter final : public Exporter {
public:
    CsvExporter(std::ostream& out, const SessionReader& session, ExportKind what,
                const PayloadSignals& payload)
        : out_(out), session_(session), what_(what), payload_(payload)
    {
    }

    bool wantsFrames() const override
    {
        return what_ == ExportKind::Frames || what_ == ExportKind::Signals;
    }

    void begin() override
    {
        switch (what_) {
        case ExportKind::Frames:
            out_ << "__time,id,extended,remote,error,fd,sent,local,length,data\n";
            break;
        case ExportKind::Signals:
            out_ << "__time";
            for (const FrameLayout& layout : frameLayouts())
                for (const SignalLayout& signal : layout.payload)
                    out_ << ',' << csvField(heading(layout, signal));
            for (const PayloadSignals::Message& message : payload_.messages())
                for (const DbcSignal& signal : message.described->message.payload)
                    out_ << ',' << csvField(headingOf(message, signal));
            out_ << '\n';
            break;
        case ExportKind::Estimates:
            out_ << "__time,estimate,scene,role,method,bin_m,height_m,mean_m,sd_m,q10_m,q90_m,"
                    "source,"
                    "ceiling_m,rhat,ess,truth_m,touch\n";
            break;
        case ExportKind::Events:
            out_ << "__time,event,kind,subject,text,number,estimate,proposal,shown\n";
            break;
        }
    }

    Taken take(const FrameRow& row) override
    {
        if (what_ == ExportKind::Frames) {
            const CanFrame& f = row.frame;
            out_ << fmt::format("{},{},{:d},{:d},{:d},{:d},{:d},{:d},{:d},{}\n", moment(row.time),
                                f.id, f.extended, f.remote, f.error, f.fd, row.sent, row.local,
                                f.length, hexBytes(f));
            return Taken::Written;
        }
        if (const auto content = unpack(row.frame); std::holds_alternative<Unpacked>(content))
            takeSignals(row.time, std::get<Unpacked>(content));
        else if (const auto message = payload_.find(row.frame))
            takePayload(row, payload_.messages()[*message]);
        else
            return Taken::PassedOver;
        return Taken::Written;
    }

    bool take(const EstimateRow& row) override
    {
        if (what_ != ExportKind::Estimates) return false;
        const TerrainEstimate& e = row.estimate;
        const SceneRow* scene = session_.scene(row.scene);
        for (std::size_t i = 0; i < kBins; ++i)
            out_ << fmt::format(
                "{},{},{},{},{},{:.1f},{},{},{},{},{},{},{},{},{},{},{}\n", moment(row.time),
                row.id, row.scene, name(row.role), name(e.settings.method),
                binCentre(static_cast<int>(i)), e.height[i], e.mean[i], e.sd[i], e.q10[i], e.q90[i],
                name(e.origin[i]), std::isfinite(e.ceiling[i]) ? numberText(e.ceiling[i]) : "",
                e.rhat[i], e.ess[i], scene && scene->truth ? numberText(scene->truth->at(i)) : "",
                name(e.touch[i]));
        return true;
    }

    bool take(const EventRow& row) override
    {
        if (what_ != ExportKind::Events) return false;
        out_ << fmt::format("{},{},{},{},{},{},{},{},{}\n", moment(row.time), row.id,
                            name(row.kind), csvField(row.subject), csvField(row.text),
                            row.number ? numberText(*row.number) : "", row.estimate, row.proposal,
                            csvField(row.shown));
        return true;
    }

private:
    static std::string heading(const FrameLayout& layout, const SignalLayout& signal)
    {
        return signal.unit.empty()
                 ? fmt::format("{}.{}", layout.name, signal.name)
                 : fmt::format("{}.{} [{}]", layout.name, signal.name, signal.unit);
    }

    std::string moment(SessionTime time) const
    {
        return nanosecondText(wallTimeOf(session_.start(), time));
    }

    void takeSignals(SessionTime time, const Unpacked& content)
    {
        out_ << moment(time);
        const FrameLayout& own = layoutOf(content.kind);
        for (const FrameLayout& layout : frameLayouts())
            for (std::size_t i = 0; i < layout.payload.size(); ++i) {
                out_ << ',';
                if (&layout == &own) out_ << numberText(content.values.at(i));
            }
        out_ << std::string(payload_.signals(), ',') << '\n';
    }

    void takePayload(const FrameRow& row, const PayloadSignals::Message& message)
    {
        std::size_t own = 0;
        for (const FrameLayout& layout : frameLayouts()) own += layout.payload.size();
        const auto numbers = numbersOf(message.described->message, row.frame);
        out_ << moment(row.time) << std::string(own + message.firstSignal, ',');
        for (const std::string& number : numbers) out_ << ',' << number;
        out_ << std::string(payload_.signals() - message.firstSignal - numbers.size(), ',') << '\n';
    }

    std::ostream& out_;
    const SessionReader& session_;
    ExportKind what_;
    const PayloadSignals& payload_;
};

std::string jsonNumbers(std::span<const double> values)
{
    std::string text = "[";
    for (const double value : values)
        text += fmt::format("{}{}", text.size() > 1 ? "," : "", value);
    return text + "]";
}

constexpr const char* kCanSchema =
    R"({"type":"object","title":"CAN frame","properties":{"id":{"type":"integer"},"extended":{"type":"boolean"},)"
    R"("remote":{"type":"boolean"},"error":{"type":"boolean"},"fd":{"type":"boolean"},"sent":{"type":"boolean"},)"
    R"("length":{"type":"integer"},"data":{"type":"array","items":{"type":"integer"}},"name":{"type":"string"},)"
    R"("signals":{"type":"object","additionalProperties":{"type":"number"}}}})";
constexpr const char* kMeasurementSchema =
    R"({"type":"object","title":"line of telemetry; rad, A, N","properties":{"pitch":{"type":"number"},)"
    R"("roll":{"type":"number"},"front_left":{"type":"number"},"front_right":{"type":"number"},)"
    R"("rear_left":{"type":"number"},"rear_right":{"type":"number"},"front_left_current":{"type":"number"},)"
    R"("front_right_current":{"type":"number"},"rear_left_current":{"type":"number"},)"
    R"("rear_right_current":{"type":"number"},"force":{"type":"array","items":{"type":"number"}},)"
    R"("missing":{"type":"array","items":{"type":"string"}},)"
    R"("activity":{"type":"string"},"refusal":{"type":"string"}}})";
constexpr const char* kEstimateSchema =
    R"({"type":"object","title":"terrain profile; m in the frame of the IMU","properties":{"id":{"type":"integer"},)"
    R"("scene":{"type":"integer"},"role":{"type":"string"},"method":{"type":"string"},"seconds":{"type":"number"},)"
    R"("step_limit":{"type":"number"},"converged":{"type":"boolean"},"ending":{"type":"string"},)"
    R"("warnings":{"type":"array","items":{"type":"string"}},"bins":{"type":"array","items":{"type":"object",)"
    R"("properties":{"x":{"type":"number"},"height":{"type":"number"},"mean":{"type":"number"},"sd":{"type":"number"},)"
    R"("q10":{"type":"number"},"q90":{"type":"number"},"source":{"type":"string"},"touch":{"type":"string"},"ceiling":{"type":"number"},)"
    R"("truth":{"type":"number"}}}}}})";
constexpr const char* kEventSchema =
    R"({"type":"object","title":"what happened","properties":{"id":{"type":"integer"},"kind":{"type":"string"},)"
    R"("subject":{"type":"string"},"text":{"type":"string"},"number":{"type":"number"},"estimate":{"type":"integer"},)"
    R"("proposal":{"type":"integer"},"shown":{"type":"string"}}})";

class McapExporter final : public Exporter {
public:
    McapExporter(std::ostream& out, const SessionReader& session, std::optional<ExportKind> what,
                 const PayloadSignals& payload)
        : session_(session), what_(what), payload_(payload), mcap_(out, session.start().program)
    {
        if (const auto robot = robotModelFrom(session.path(), session.start().robot); robot)
            listener_ = std::make_unique<TelemetryListener>(*robot);
    }

    bool wantsFrames() const override
    {
        return !what_ || *what_ == ExportKind::Frames || *what_ == ExportKind::Signals;
    }

    void begin() override
    {
        const auto add = [&](ExportKind kind, const char* topic, const char* name,
                             const char* schema) {
            return !what_ || *what_ == kind ? mcap_.addChannel(topic, name, schema)
                                            : std::uint16_t{0};
        };
        can_ = add(ExportKind::Frames, "/can", "terratact.CanFrame", kCanSchema);
        measurement_ =
            add(ExportKind::Signals, "/measurement", "terratact.Measurement", kMeasurementSchema);
        if (measurement_ != 0)
            for (const PayloadSignals::Message& message : payload_.messages())
                channels_.push_back(mcap_.addChannel("/payload/" + message.name, message.name,
                                                     jsonSchemaOf(message)));
        estimate_ = add(ExportKind::Estimates, "/estimate", "terratact.Estimate", kEstimateSchema);
        event_ = add(ExportKind::Events, "/event", "terratact.Event", kEventSchema);
        const SessionStart& start = session_.start();
        mcap_.addMetadata("terratact.session", {{"program", start.program},
                                                {"source", start.source},
                                                {"bus", start.bus},
                                                {"robot_sha256", start.robotHash},
                                                {"start", utcText(wallTimeOf(start, 0))}});
    }

    Taken take(const FrameRow& row) override
    {
        const auto described = payload_.find(row.frame);
        Taken taken = Taken::PassedOver;
        if (can_ != 0) {
            write(can_, row.time, frameJson(row));
            taken = Taken::Written;
        }
        if (described && !channels_.empty()) {
            write(channels_[*described], row.time,
                  jsonValuesOf(payload_.messages()[*described].described->message, row.frame));
            taken = Taken::Written;
        }
        if (measurement_ == 0 || !listener_ || row.sent) return taken;
        const auto measured = listener_->take(row.frame, secondsOf(row.time));
        if (!measured) return taken;
        write(measurement_, row.time, measurementJson(*measured));
        return Taken::Written;
    }
    bool take(const EstimateRow& row) override
    {
        if (estimate_ != 0) write(estimate_, row.time, estimateJson(row));
        return estimate_ != 0;
    }
    bool take(const EventRow& row) override
    {
        if (event_ == 0) return false;
        const std::string number = row.number ? fmt::format(",\"number\":{}", *row.number) : "";
        write(
            event_, row.time,
            fmt::format(
                R"({{"id":{},"kind":{},"subject":{},"text":{}{},"estimate":{},"proposal":{},"shown":{}}})",
                row.id, jsonText(name(row.kind)), jsonText(row.subject), jsonText(row.text), number,
                row.estimate, row.proposal, jsonText(row.shown)));
        return true;
    }
    void end() override { mcap_.finish(); }

private:
    void write(std::uint16_t channel, SessionTime time, const std::string& json)
    {
        mcap_.write(channel, static_cast<std::uint64_t>(wallTimeOf(session_.start(), time)), json);
    }

    std::string frameJson(const FrameRow& row) const
    {
        const CanFrame& f = row.frame;
        std::string data;
        for (const std::uint8_t byte : bytesOf(f))
            data += fmt::format("{}{}", data.empty() ? "" : ",", byte);
        std::string meaning;
        if (const auto content = unpack(f); std::holds_alternative<Unpacked>(content)) {
            const auto& sound = std::get<Unpacked>(content);
            const FrameLayout& layout = layoutOf(sound.kind);
            for (std::size_t i = 0; i < layout.payload.size(); ++i)
                meaning += fmt::format("{}{}:{}", i > 0 ? "," : "",
                                       jsonText(layout.payload[i].name), sound.values.at(i));
            meaning = fmt::format(R"(,"name":{},"signals":{{{}}})", jsonText(layout.name), meaning);
        } else if (const auto described = payload_.find(f)) {
            const auto& message = payload_.messages()[*described];
            meaning = fmt::format(R"(,"name":{},"signals":{})", jsonText(message.name),
                                  jsonValuesOf(message.described->message, f));
        }
        return fmt::format(
            R"({{"id":{},"extended":{},"remote":{},"error":{},"fd":{},"sent":{},"length":{},"data":[{}]{}}})",
            f.id, f.extended, f.remote, f.error, f.fd, row.sent, f.length, data, meaning);
    }

    static std::string measurementJson(const Measurement& m)
    {
        return fmt::format(
            R"({{"pitch":{},"roll":{},"front_left":{},"front_right":{},"rear_left":{},"rear_right":{},)"
            R"("front_left_current":{},"front_right_current":{},"rear_left_current":{},"rear_right_current":{},)"
            R"("force":{},"activity":{},"refusal":{}{}}})",
            m.pitch, m.roll, m.frontLeft, m.frontRight, m.rearLeft, m.rearRight, m.frontLeftCurrent,
            m.frontRightCurrent, m.rearLeftCurrent, m.rearRightCurrent, jsonNumbers(m.force),
            jsonText(describe(m.activity)), jsonText(describe(m.refusal)), missingJson(m.missing));
    }

    /// Returns the names of unmeasured features, whose numbers are 0; empty if all were measured.
    static std::string missingJson(MissingFeatures missing)
    {
        std::string names;
        for (std::size_t d = 0; d < missing.size(); ++d)
            if (missing[d])
                names +=
                    fmt::format("{}\"{}\"", names.empty() ? "" : ",", featureColumns()[d].name);
        return names.empty() ? names : fmt::format(R"(,"missing":[{}])", names);
    }

    std::string estimateJson(const EstimateRow& row) const
    {
        const TerrainEstimate& e = row.estimate;
        const SceneRow* scene = session_.scene(row.scene);
        std::string bins, warnings;
        for (std::size_t i = 0; i < kBins; ++i) {
            bins += fmt::format(
                R"({}{{"x":{},"height":{},"mean":{},"sd":{},"q10":{},"q90":{},"source":{},"touch":{})",
                i > 0 ? "," : "", binCentre(static_cast<int>(i)), e.height[i], e.mean[i], e.sd[i],
                e.q10[i], e.q90[i], jsonText(name(e.origin[i])), jsonText(name(e.touch[i])));
            if (std::isfinite(e.ceiling[i])) bins += fmt::format(",\"ceiling\":{}", e.ceiling[i]);
            if (scene && scene->truth) bins += fmt::format(",\"truth\":{}", scene->truth->at(i));
            bins += "}";
        }
        for (const std::string& warning : e.warnings)
            warnings += fmt::format("{}{}", warnings.empty() ? "" : ",", jsonText(warning));
        return fmt::format(
            R"({{"id":{},"scene":{},"role":{},"method":{},"seconds":{},"step_limit":{},"converged":{},"ending":{},"warnings":[{}],"bins":[{}]}})",
            row.id, row.scene, jsonText(name(row.role)), jsonText(name(e.settings.method)),
            row.seconds, row.stepLimit, e.converged, jsonText(name(e.ending)), warnings, bins);
    }

    const SessionReader& session_;
    std::optional<ExportKind> what_;
    const PayloadSignals& payload_;
    std::vector<std::uint16_t> channels_;  // channels of the DBC messages
    McapWriter mcap_;
    std::unique_ptr<TelemetryListener> listener_;
    std::uint16_t can_ = 0, measurement_ = 0, estimate_ = 0, event_ = 0;
};

/// A row besides frames: its time and its writer.
using Other = std::pair<SessionTime, std::function<bool(Exporter&)>>;

std::vector<Other> othersOf(const SessionReader& session, const ExportSelection& selection)
{
    std::vector<Other> others;
    const auto add = [&](const auto& rows) {
        for (const auto& row : rows)
            if (selection.covers(row.time))
                others.emplace_back(row.time, [&row](Exporter& e) { return e.take(row); });
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
            const Taken taken = exporter.take(frame);
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
    case ExportFormat::Candump: return std::make_unique<CandumpExporter>(out, session.start());
    case ExportFormat::Asc: return std::make_unique<AscExporter>(out, session.start());
    case ExportFormat::Csv:
        return std::make_unique<CsvExporter>(out, session,
                                             selection.what.value_or(ExportKind::Frames), payload);
    case ExportFormat::Mcap:
        return std::make_unique<McapExporter>(out, session, selection.what, payload);
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

std::string rangeText(const ExportSelection& selection)
{
    const bool begins = std::isfinite(selection.from), ends = std::isfinite(selection.to);
    if (begins && ends) return fmt::format(" from {} s to {} s", selection.from, selection.to);
    if (begins) return fmt::format(" from {} s on", selection.from);
    return ends ? fmt::format(" until {} s", selection.to) : std::string();
}

/// Returns the reason that nothing was written.
Error nothingOf(const SessionReader& session, const ExportSelection& selection,
                const ExportCounts& counts)
{
    if (counts.leftOut > 0)
        return fileError(
            session.path(),
            fmt::format("none of the frames can be written in this format: {} left out",
                        counts.leftOut));
    const std::string kind =
        selection.what ? fmt::format(": no {}", nameOf(*selection.what)) : std::string();
    return fileError(session.path(),
                     fmt::format("nothing was recorded{}{}: the session lasts {:.1f} s",
                                 rangeText(selection), kind,
                                 secondsOf(session.end() - session.begin())));
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
        return fileError(path, "a log of CAN frames holds nothing else; csv and mcap do");
    Result<TextOutput> out = TextOutput::begin(path);
    if (!out) return out.error();
    const PayloadSignals payload = payloadOf(session, selection);
    auto counts = run(session, *exporterFor(out->stream(), session, format, selection, payload),
                      selection, progress);
    if (counts) counts->withoutColumns = payload.leftOut();
    if (!counts) return fileError(path, "not written: ended before it was whole");
    if (counts->frames + counts->others == 0) return nothingOf(session, selection, *counts);
    if (Status done = out->commit(); !done) return done.error();
    return *counts;
}

}  // namespace terratact
