#pragma once

#include <memory>
#include <optional>
#include <ostream>

#include "app/recording/export/payload_signals.h"
#include "app/recording/export/session_export.h"
#include "core/log/session_reader.h"

namespace terratact {

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
    virtual Taken write(const FrameRow&) { return Taken::PassedOver; }
    /// Returns false if this kind of row was not selected.
    virtual bool write(const EstimateRow&) { return false; }
    virtual bool write(const EventRow&) { return false; }
    virtual void end() {}
};

// One exporter for each format. out, session and payload must outlive it.
std::unique_ptr<Exporter> candumpExporter(std::ostream& out, const SessionStart& start);
std::unique_ptr<Exporter> ascExporter(std::ostream& out, const SessionStart& start);
std::unique_ptr<Exporter> csvExporter(std::ostream& out, const SessionReader& session,
                                      ExportKind what, const PayloadSignals& payload);
/// what: empty for all kinds.
std::unique_ptr<Exporter> mcapExporter(std::ostream& out, const SessionReader& session,
                                       std::optional<ExportKind> what,
                                       const PayloadSignals& payload);

}  // namespace terratact
