#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "app/recording/session_exporter.h"
#include "app/recording/session_text.h"
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

}  // namespace

std::unique_ptr<Exporter> csvExporter(std::ostream& out, const SessionReader& session,
                                      ExportKind what, const PayloadSignals& payload)
{
    return std::make_unique<CsvExporter>(out, session, what, payload);
}

}  // namespace terratact
