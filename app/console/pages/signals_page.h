#pragma once

#include <QString>
#include <memory>
#include <vector>

#include "app/link/can_source.h"
#include "app/link/frame_history.h"
#include "app/mission/signal_rows.h"
#include "app/shell/page.h"

class QHBoxLayout;
class QLabel;

namespace terratact {

class Acquisition;
class CanSource;
struct RobotMoment;
class Card;
class DbcFiles;
class PreferenceStore;
class RawTrace;
class SignalTable;

/// Returns "load 10.9 to 13.1 % of 500 kbit/s (without stuff bits, with all there can be)". "---"
/// stands for an unknown bit rate.
QString busLoadText(const BusLoad& load, const BitRate& bitrate);

/// Shows the bus: its load, every signal, and the newest raw frames. Preferred DBC files describe frames outside the
/// robot's protocol; their errors appear on the page and on stderr.
class SignalsPage final : public Page {
    Q_OBJECT
public:
    /// link: null if the source has no bus. All arguments must outlive the page.
    SignalsPage(const RobotMoment& moment, const Acquisition& acquisition, CanSource* link,
                PreferenceStore& preferences, QWidget* parent = nullptr);
    void refresh(double now) override;

    SignalTable* table() const { return table_; }
    RawTrace* trace() const { return trace_; }
    QString headline() const;
    DbcFiles* dbc() const { return dbc_; }  ///< null without a bus

private:
    void addDbc(Card& card, PreferenceStore& preferences);
    void addTools(QHBoxLayout& row);
    void refreshBus(double now);
    void refreshMeasurement(double now);

    const RobotMoment& moment_;
    const Acquisition& acquisition_;
    CanSource* link_;
    std::vector<DbcMessage> protocol_;  ///< empty: the protocol's file could not be used
    std::shared_ptr<const DbcBook> book_;
    QLabel* headline_ = nullptr;
    DbcFiles* dbc_ = nullptr;  ///< null without a bus
    SignalTable* table_ = nullptr;
    RawTrace* trace_ = nullptr;              ///< null without a bus
    double shownAt_ = 0.0, tracedAt_ = 0.0;  ///< [s]
};

}  // namespace terratact
