#pragma once

#include <QStringList>
#include <array>
#include <cstdint>
#include <optional>

#include "app/recording/export/session_export.h"

namespace terratact {

/// Source of an export's data.
enum class ExportSource : std::uint8_t { Picture, Numbers, Report, Mission, Strip, Rows };

struct ExportChoice {
    const char* name;
    const char* part;     ///< part of the file name
    QStringList formats;  ///< file endings
    ExportSource from = ExportSource::Rows;
    std::optional<ExportKind> rows{};  ///< empty: all rows that the format supports
};

/// Returns the choices in the order of the list.
const std::array<ExportChoice, 10>& exportChoices();

}  // namespace terratact
