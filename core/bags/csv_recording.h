#pragma once

#include <memory>
#include <string>

#include "core/bags/recording.h"

namespace terratact {

/// Name of the only topic of a CSV file; its fields are the columns.
inline constexpr const char* kCsvTopic = "/csv";
/// Encoding of that topic, whose messages are the rows in the order of the file.
inline constexpr const char* kCsvEncoding = "csv";

/// Opens a CSV file of a time series: a line with the names of the columns, then a row for each time. A
/// field that is no number is a text. Times have the unit of `time`, else that in the name of the column, else
/// timeUnitOf() the first rows. A remark names the last if only the steps show it. Errors name the file, and the line
/// or the missing column.
Result<std::unique_ptr<Recording>> openCsvRecording(const std::string& path,
                                                    const CsvTime& time = {});

}  // namespace terratact
