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

/// What a session is written as for other programs.
///   Candump  log of can-utils and python-can, one frame per line, times since 1970
///   Asc      the same in Vector's format, times since the session's start
///   Csv      first column __time [s since 1970]: PlotJuggler, pandas
///   Mcap     JSON messages with schemas, in indexed chunks: Foxglove, Lichtblick, PlotJuggler
enum class ExportFormat : std::uint8_t { Candump, Asc, Csv, Mcap };
std::optional<ExportFormat> exportFormatFromName(std::string_view text);
/// By the file's ending: .log, .asc, .csv, .mcap.
std::optional<ExportFormat> exportFormatOf(const std::string& path);

/// Which rows.  Signals are the decoded values of sound frames (resources/dbc/terratact.dbc), and of those that a DBC
/// file describes.
enum class ExportKind : std::uint8_t { Frames, Signals, Estimates, Events };
std::optional<ExportKind> exportKindFromName(std::string_view text);

struct ExportSelection {
    std::optional<ExportKind>
        what{};  ///< empty: everything that the format has room for; CSV: frames
    double from = -std::numeric_limits<double>::infinity();  ///< [s] since the session's start
    double to = std::numeric_limits<double>::infinity();
    std::shared_ptr<const DbcBook> book{};  ///< for frames that are not the protocol's; null: none

    bool covers(SessionTime time) const { return secondsOf(time) >= from && secondsOf(time) <= to; }
};

struct ExportCounts {
    std::uint64_t frames = 0;        ///< written
    std::uint64_t others = 0;        ///< estimates and events that were written
    std::uint64_t leftOut = 0;       ///< frames that the format cannot express
    std::size_t withoutColumns = 0;  ///< messages of DBC files that found no room (PayloadSignals)
};

/// Writes as TextOutput does.  Errors name a file; a selection that the format cannot hold; a selection of which nothing
/// was recorded, or nothing that the format can express: then no file is written.
/// What is damaged is left out: session.damage() afterwards.  progress(share of the batches) may end it by
/// returning false, which is an Error and leaves no file.
Result<ExportCounts> writeExport(SessionReader& session, const std::string& path,
                                 ExportFormat format, const ExportSelection& selection,
                                 const std::function<bool(double)>& progress = {});

}  // namespace terratact
