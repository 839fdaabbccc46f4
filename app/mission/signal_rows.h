#pragma once

#include <QString>
#include <memory>
#include <span>
#include <vector>

#include "app/link/dbc_book.h"
#include "app/link/tapped_frame.h"
#include "widgets/signals/raw_trace.h"
#include "widgets/signals/signal_table.h"

namespace terratact {

/// Rows of the table: a robot's signals and commands, then what DBC files describe, then kinds that nobody knows.
/// protocol: readProtocolDbc(), for what the robot's signals mean; empty: nothing is said of that.
std::vector<SignalRow> signalRows(const std::vector<TappedFrame>& frames,
                                  std::span<const DbcMessage> protocol = {});

/// "Attitude", "error frame", "unknown".  book: null: no DBC files.
QString frameName(const CanFrame& frame, const DbcBook* book);

/// Of any frame of the bus.
TraceWords traceWords(const CanFrame& frame, const std::shared_ptr<const DbcBook>& book);

}  // namespace terratact
