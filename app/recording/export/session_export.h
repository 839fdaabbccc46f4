#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "app/link/dbc_book.h"
#include "core/base/result.h"
#include "core/log/session_reader.h"

namespace terratact {

/// Export formats of a session.
///   Candump  log of can-utils and python-can, one frame per line, times since 1970
///   Asc      Vector's format, one frame per line, times since the session's start
///   Csv      first column __time [s since 1970]: PlotJuggler, pandas; columns: csv_exporter.cpp
///   Mcap     JSON messages with schemas, in indexed chunks: Foxglove, Lichtblick, PlotJuggler
enum class ExportFormat : std::uint8_t { Candump, Asc, Csv, Mcap };
std::optional<ExportFormat> exportFormatFromName(std::string_view text);
/// Returns the format for a file ending: .log, .asc, .csv, .mcap.
std::optional<ExportFormat> exportFormatOf(const std::string& path);

/// Kinds of exported rows. Signals are decoded values of valid frames (resources/dbc/terratact.dbc), and of frames
/// described by DBC files.
enum class ExportKind : std::uint8_t { Frames, Signals, Estimates, Events };
std::optional<ExportKind> exportKindFromName(std::string_view text);

struct ExportSelection {
    /// Empty: all kinds that the format supports; frames for CSV.
    std::optional<ExportKind> what{};
    double from = -std::numeric_limits<double>::infinity();  ///< [s] since the session's start
    double to = std::numeric_limits<double>::infinity();
    std::shared_ptr<const DbcBook> book{};  ///< describes frames outside the protocol; null: none

    bool covers(SessionTime time) const { return secondsOf(time) >= from && secondsOf(time) <= to; }
};

struct ExportCounts {
    std::uint64_t frames = 0;        ///< frames written
    std::uint64_t others = 0;        ///< estimates and events written
    std::uint64_t leftOut = 0;       ///< frames that the format cannot express
    std::size_t withoutColumns = 0;  ///< DBC messages beyond the bound of PayloadSignals
};

/// Writes the export through TextOutput. Damaged rows are omitted; session.damage() lists them afterwards.
/// progress(share of the batches) cancels by returning false, which is an Error and leaves no file. Returns an Error
/// without a file if it cannot be written or the format cannot hold the selection. The same holds if nothing in the
/// selection can be expressed.
Result<ExportCounts> writeExport(SessionReader& session, const std::string& path,
                                 ExportFormat format, const ExportSelection& selection,
                                 const std::function<bool(double)>& progress = {});

}  // namespace terratact
