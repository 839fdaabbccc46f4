#pragma once

#include <QString>
#include <memory>
#include <span>
#include <vector>

#include "app/display/signal_row.h"
#include "app/display/trace_text.h"
#include "app/link/dbc_book.h"
#include "app/link/tapped_frame.h"

namespace terratact {

/// Returns the rows of the signal table: signals and commands of the robot, DBC signals, unknown kinds. protocol:
/// result of readProtocolDbc(), which explains the robot's signals. If it is empty, the rows have no explanations.
std::vector<SignalRow> signalRows(const std::vector<TappedFrame>& frames,
                                  std::span<const DbcMessage> protocol = {});

/// Returns "Attitude", "error frame", "unknown". book: null: no DBC files.
QString frameName(const CanFrame& frame, const DbcBook* book);

/// Returns the texts of any frame of the bus.
TraceText traceText(const CanFrame& frame, const std::shared_ptr<const DbcBook>& book);

}  // namespace terratact
