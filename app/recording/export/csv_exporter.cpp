#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "app/recording/export/session_exporter.h"
#include "app/recording/recorded_sides.h"
#include "app/recording/session_text.h"
#include "core/base/message.h"
#include "core/base/text.h"
#include "core/store/csv_text.h"
#include "core/wire/can_codec.h"
#include "core/wire/frame_layout.h"

namespace terratact {
namespace {

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
        case ExportKind::Signals: out_ << csvLine(signalColumns()); break;
        case ExportKind::Estimates:
            out_ << "__time,estimate,scene,role,method,bin_m,height_m,mean_m,sd_m,q10_m,q90_m,"
                    "source,"
                    "ceiling_m,rhat,ess,truth_m,touch,side\n";
            break;
        case ExportKind::Events:
            out_ << "__time,event,kind,subject,text,number,estimate,proposal,shown\n";
            break;
        }
    }

    Taken write(const FrameRow& row) override
    {
        if (what_ == ExportKind::Frames) {
            const CanFrame& f = row.frame;
            out_ << csvLine({moment(row.time), f.id, f.extended, f.remote, f.error, f.fd, row.sent,
                             row.local, f.length, hexBytes(f)});
            return Taken::Written;
        }
        if (const auto content = unpack(row.frame); std::holds_alternative<Unpacked>(content))
            writeSignals(row.time, std::get<Unpacked>(content));
        else if (const auto message = payload_.find(row.frame))
            writePayload(row, payload_.messages()[*message]);
        else
            return Taken::PassedOver;
        return Taken::Written;
    }

    bool write(const EstimateRow& row) override
    {
        if (what_ != ExportKind::Estimates) return false;
        for (const RecordedSide& side :
             recordedSides(row.estimate.onePlane, session_.scene(row.scene)))
            writeSide(row, side);
        return true;
    }

    bool write(const EventRow& row) override
    {
        if (what_ != ExportKind::Events) return false;
        out_ << csvLine({moment(row.time), row.id, name(row.kind), row.subject, row.text,
                         row.number ? numberText(*row.number) : "", row.estimate, row.proposal,
                         row.shown});
        return true;
    }

private:
    void writeSide(const EstimateRow& row, const RecordedSide& side)
    {
        const TerrainEstimate& e = row.estimate.side.at(side.index);
        for (std::size_t i = 0; i < kBins; ++i)
            out_ << csvLine({moment(row.time), row.id, row.scene, name(row.role),
                             name(e.settings.method), fixed(binCentre(static_cast<int>(i)), 1),
                             e.height[i], e.mean[i], e.sd[i], e.q10[i], e.q90[i], name(e.origin[i]),
                             std::isfinite(e.ceiling[i]) ? numberText(e.ceiling[i]) : "", e.rhat[i],
                             e.ess[i], side.truth ? numberText(side.truth->at(i)) : "",
                             name(e.touch[i]), side.name});
    }

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

    std::vector<std::string> signalColumns() const
    {
        std::vector<std::string> columns{"__time"};
        for (const FrameLayout& layout : frameLayouts())
            for (const SignalLayout& signal : layout.payload)
                columns.push_back(heading(layout, signal));
        for (const PayloadSignals::Message& message : payload_.messages())
            for (const DbcSignal& signal : message.described->message.payload)
                columns.push_back(headingOf(message, signal));
        return columns;
    }

    void writeSignals(SessionTime time, const Unpacked& content)
    {
        std::vector<std::string> fields{moment(time)};
        const FrameLayout& own = layoutOf(content.kind);
        const auto measured = measuredSignals(content);
        for (const FrameLayout& layout : frameLayouts())
            for (std::size_t i = 0; i < layout.payload.size(); ++i)
                fields.push_back(&layout == &own && measured[i] ? numberText(content.values.at(i))
                                                                : "");
        fields.resize(fields.size() + payload_.signals());
        out_ << csvLine(fields);
    }

    void writePayload(const FrameRow& row, const PayloadSignals::Message& message)
    {
        std::size_t own = 0;
        for (const FrameLayout& layout : frameLayouts()) own += layout.payload.size();
        std::vector<std::string> fields(1 + own + payload_.signals());
        fields.front() = moment(row.time);
        const auto numbers = numbersOf(message.described->message, row.frame);
        std::ranges::copy(
            numbers, fields.begin() + static_cast<std::ptrdiff_t>(1 + own + message.firstSignal));
        out_ << csvLine(fields);
    }

    std::ostream& out_;
    const SessionReader& session_;
    ExportKind what_;
    const PayloadSignals& payload_;
};

}  // namespace

std::unique_ptr<Exporter> csvExporter(std::ostream& out, const SessionReader& session,
                                      ExportKind what, const PayloadSignals& payload)
{
    return std::make_unique<CsvExporter>(out, session, what, payload);
}

}  // namespace terratact
