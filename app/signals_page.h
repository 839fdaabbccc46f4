#pragma once

#include <vector>

#include "app/bus_tap.h"
#include "app/can_source.h"
#include "app/page.h"
#include "widgets/signal_table.h"

class QLabel;

namespace terratact {

class Acquisition;
class CanSource;
class RawTrace;

/// Rows of the table: a robot's signals and commands as the DBC has them, then kinds that it has not.
std::vector<SignalRow> signalRows(const std::vector<TappedFrame>& frames);

/// "load 10.9 to 13.1 % of 500 kbit/s (without stuff bits, with all there can be)"; without a bit rate "---".
QString loadWords(const BusLoad& load, const BitRate& bitrate);

/// What is on the bus: its load, every signal, and the newest frames as they were.
class SignalsPage final : public Page {
    Q_OBJECT
public:
    /// link: null where the source is no bus.  Both must outlive it.
    SignalsPage(const Acquisition& acquisition, CanSource* link, QWidget* parent = nullptr);
    void refresh(double now) override;

    SignalTable* table() const { return table_; }
    RawTrace* trace() const { return trace_; }
    QString headline() const;

private:
    void refreshBus(double now);
    void refreshMeasurement(double now);

    const Acquisition& acquisition_;
    CanSource* link_;
    QLabel* headline_ = nullptr;
    SignalTable* table_ = nullptr;
    RawTrace* trace_ = nullptr;              ///< null without a bus
    double shownAt_ = 0.0, tracedAt_ = 0.0;  ///< [s]
};

}  // namespace terratact
