#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/recording/export/mcap_writer.h"
#include "app/recording/export/session_exporter.h"
#include "app/recording/recorded_sides.h"
#include "app/recording/session_text.h"
#include "core/base/text.h"
#include "core/learn/data/columns.h"
#include "core/robot/robot_model.h"
#include "core/wire/can_codec.h"
#include "core/wire/frame_layout.h"
#include "core/wire/telemetry_listener.h"

namespace terratact {
namespace {

std::string jsonNumbers(std::span<const double> values)
{
    std::string text = "[";
    for (const double value : values)
        text += fmt::format("{}{}", text.size() > 1 ? "," : "", value);
    return text + "]";
}

// Foxglove and Lichtblick refuse a topic whose schema has a list of types, or an object without
// properties. Their numbers may be null.
constexpr const char* kCanSchema =
    R"({"type":"object","title":"CAN frame","properties":{"id":{"type":"integer"},"extended":{"type":"boolean"},)"
    R"("remote":{"type":"boolean"},"error":{"type":"boolean"},"fd":{"type":"boolean"},"sent":{"type":"boolean"},)"
    R"("length":{"type":"integer"},"data":{"type":"array","items":{"type":"integer"}},"name":{"type":"string"},)"
    R"("signals":{"type":"object","properties":{},"additionalProperties":{"type":"number"}}}})";
constexpr const char* kMeasurementSchema =
    R"({"type":"object","title":"line of telemetry; rad, A, N","properties":{"pitch":{"type":"number"},)"
    R"("roll":{"type":"number"},"front_left":{"type":"number"},"front_right":{"type":"number"},)"
    R"("rear_left":{"type":"number"},"rear_right":{"type":"number"},"front_left_current":{"type":"number"},)"
    R"("front_right_current":{"type":"number"},"rear_left_current":{"type":"number"},)"
    R"("rear_right_current":{"type":"number"},"force":{"type":"array","items":{"type":"number"}},)"
    R"("front_left_force":{"type":"array","items":{"type":"number"}},)"
    R"("front_right_force":{"type":"array","items":{"type":"number"}},)"
    R"("rear_left_force":{"type":"array","items":{"type":"number"}},)"
    R"("rear_right_force":{"type":"array","items":{"type":"number"}},)"
    R"("differential":{"type":"number"},"travelled":{"type":"number"},"turned":{"type":"number"},)"
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
        if (hasTwoSides()) {
            sides_[0] =
                add(ExportKind::Estimates, "/estimate/left", "terratact.Estimate", kEstimateSchema);
            sides_[1] = add(ExportKind::Estimates, "/estimate/right", "terratact.Estimate",
                            kEstimateSchema);
        }
        event_ = add(ExportKind::Events, "/event", "terratact.Event", kEventSchema);
        const SessionStart& start = session_.start();
        mcap_.addMetadata("terratact.session", {{"program", start.program},
                                                {"source", start.source},
                                                {"bus", start.bus},
                                                {"robot_sha256", start.robotHash},
                                                {"start", utcText(wallTimeOf(start, 0))}});
    }

    Taken write(const FrameRow& row) override
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
        const auto measured = listener_->receive(row.frame, secondsOf(row.time));
        if (!measured) return taken;
        write(measurement_, row.time, measurementJson(*measured));
        return Taken::Written;
    }
    bool write(const EstimateRow& row) override
    {
        if (estimate_ == 0) return false;
        for (const RecordedSide& side :
             recordedSides(row.estimate.onePlane, session_.scene(row.scene)))
            write(row.estimate.onePlane ? estimate_ : sides_.at(side.index), row.time,
                  estimateJson(row, side));
        return true;
    }
    bool write(const EventRow& row) override
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
            meaning = fmt::format(R"(,"name":{},"signals":{})", jsonText(layoutOf(sound.kind).name),
                                  signalsJson(sound));
        } else if (const auto described = payload_.find(f)) {
            const auto& message = payload_.messages()[*described];
            meaning = fmt::format(R"(,"name":{},"signals":{})", jsonText(message.name),
                                  jsonValuesOf(message.described->message, f));
        }
        return fmt::format(
            R"({{"id":{},"extended":{},"remote":{},"error":{},"fd":{},"sent":{},"length":{},"data":[{}]{}}})",
            f.id, f.extended, f.remote, f.error, f.fd, row.sent, f.length, data, meaning);
    }

    /// A signal that was not measured is null.
    static std::string signalsJson(const Unpacked& content)
    {
        const FrameLayout& layout = layoutOf(content.kind);
        const auto measured = measuredSignals(content);
        std::string text;
        for (std::size_t i = 0; i < layout.payload.size(); ++i)
            text += fmt::format("{}{}:{}", i > 0 ? "," : "", jsonText(layout.payload[i].name),
                                measured[i] ? fmt::format("{}", content.values.at(i)) : "null");
        return "{" + text + "}";
    }

    /// A current that only the other motor of its axle measured is null.
    static std::string measurementJson(const Measurement& m)
    {
        const auto current = [&m](std::size_t motor, double value) {
            return m.missingMotors[motor] ? "null" : fmt::format("{}", value);
        };
        return fmt::format(
            R"({{"pitch":{},"roll":{},"front_left":{},"front_right":{},"rear_left":{},"rear_right":{},)"
            R"("front_left_current":{},"front_right_current":{},"rear_left_current":{},"rear_right_current":{},)"
            R"("force":{},"activity":{},"refusal":{}{}}})",
            m.pitch, m.roll, m.frontLeft, m.frontRight, m.rearLeft, m.rearRight,
            current(0, m.frontLeftCurrent), current(1, m.frontRightCurrent),
            current(2, m.rearLeftCurrent), current(3, m.rearRightCurrent), jsonNumbers(m.force),
            jsonText(describe(m.activity).english), jsonText(describe(m.refusal).english),
            sidesJson(m) + missingJson(m.missing));
    }

    /// Returns the forces of each side, differential and odometry, as far as they are known. A force that
    /// is not known is null.
    static std::string sidesJson(const Measurement& m)
    {
        std::string text;
        const auto add = [&text](const char* name, const auto& forces) {
            if (!std::ranges::any_of(forces, &std::optional<double>::has_value)) return;
            std::string numbers;
            for (const std::optional<double>& force : forces)
                numbers += fmt::format("{}{}", numbers.empty() ? "" : ",",
                                       force ? fmt::format("{}", *force) : "null");
            text += fmt::format(",\"{}\":[{}]", name, numbers);
        };
        add("front_left_force", m.sides.left);
        add("front_right_force", m.sides.right);
        add("rear_left_force", m.rearSides.left);
        add("rear_right_force", m.rearSides.right);
        const auto addNumber = [&text](const char* name, const std::optional<double>& number) {
            if (number) text += fmt::format(",\"{}\":{}", name, *number);
        };
        addNumber("differential", m.differential);
        addNumber("travelled", m.travelled);
        addNumber("turned", m.turned);
        return text;
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

    bool hasTwoSides() const
    {
        return std::ranges::any_of(session_.estimates(),
                                   [](const EstimateRow& row) { return !row.estimate.onePlane; });
    }

    static std::string estimateJson(const EstimateRow& row, const RecordedSide& side)
    {
        const TerrainEstimate& e = row.estimate.side.at(side.index);
        std::string bins, warnings;
        for (std::size_t i = 0; i < kBins; ++i) {
            bins += fmt::format(
                R"({}{{"x":{},"height":{},"mean":{},"sd":{},"q10":{},"q90":{},"source":{},"touch":{})",
                i > 0 ? "," : "", binCentre(static_cast<int>(i)), e.height[i], e.mean[i], e.sd[i],
                e.q10[i], e.q90[i], jsonText(name(e.origin[i])), jsonText(name(e.touch[i])));
            if (std::isfinite(e.ceiling[i])) bins += fmt::format(",\"ceiling\":{}", e.ceiling[i]);
            if (side.truth) bins += fmt::format(",\"truth\":{}", side.truth->at(i));
            bins += "}";
        }
        for (const Message& warning : e.warnings)
            warnings +=
                fmt::format("{}{}", warnings.empty() ? "" : ",", jsonText(warning.english()));
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
    std::array<std::uint16_t, 2> sides_{};  // channels of estimates of two sides
};

}  // namespace

std::unique_ptr<Exporter> mcapExporter(std::ostream& out, const SessionReader& session,
                                       std::optional<ExportKind> what,
                                       const PayloadSignals& payload)
{
    return std::make_unique<McapExporter>(out, session, what, payload);
}

}  // namespace terratact
