#pragma once

#include <QString>
#include <QStringList>
#include <QThreadPool>
#include <atomic>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/bus_tap.h"
#include "app/can_source.h"
#include "app/page.h"
#include "app/signal_rows.h"

class QHBoxLayout;
class QLabel;
class QMenu;
class QPushButton;

namespace terratact {

class Acquisition;
class CanSource;
class PreferenceStore;
class RawTrace;

/// "load 10.9 to 13.1 % of 500 kbit/s (without stuff bits, with all there can be)"; without a bit rate "---".
QString loadWords(const BusLoad& load, const BitRate& bitrate);

/// The protocol's DBC file and those of the operator, read.
struct DbcReading {
    std::vector<DbcMessage> protocol;  ///< empty: its file could not be used
    std::shared_ptr<const DbcBook> book;
    std::vector<std::pair<QString, std::optional<std::size_t>>>
        files;                          ///< frames used; empty: none is
    std::vector<std::string> troubles;  ///< a sentence each
};

/// What is on the bus: its load, every signal, and the newest frames as they were.  Preferred DBC files say what
/// frames mean that are not the robot's; what is wrong with them, the page and stderr say.
class SignalsPage final : public Page {
    Q_OBJECT
public:
    /// link: null where the source is no bus.  All must outlive it.
    SignalsPage(const Acquisition& acquisition, CanSource* link, PreferenceStore& preferences,
                QWidget* parent = nullptr);
    ~SignalsPage() override;  ///< waits for the one file that is being read
    void refresh(double now) override;

    SignalTable* table() const { return table_; }
    RawTrace* trace() const { return trace_; }
    QString headline() const;
    QString dbcFiles() const;     ///< which are in use; empty: none
    QString dbcTroubles() const;  ///< a line each; empty: none
    QPushButton* addDbcButton() const { return addDbc_; }
    QPushButton* removeDbcButton() const { return removeDbc_; }

private:
    void addTools(QHBoxLayout& row);
    void readDbc();
    void useDbc(const DbcReading& reading);
    void showDbc(const QStringList& files, const QStringList& troubles);
    void addDbcFile();
    void refreshBus(double now);
    void refreshMeasurement(double now);

    const Acquisition& acquisition_;
    CanSource* link_;
    PreferenceStore& preferences_;
    std::atomic<int> readings_ =
        0;  ///< of the DBC files that were asked for; only the newest counts
    std::vector<DbcMessage> protocol_;  ///< empty: its file could not be used
    std::shared_ptr<const DbcBook> book_;
    QLabel* headline_ = nullptr;
    QLabel *dbcFiles_ = nullptr, *dbcTroubles_ = nullptr;
    QPushButton *addDbc_ = nullptr, *removeDbc_ = nullptr;  ///< null without a bus
    SignalTable* table_ = nullptr;
    RawTrace* trace_ = nullptr;              ///< null without a bus
    double shownAt_ = 0.0, tracedAt_ = 0.0;  ///< [s]
    QThreadPool reader_;  ///< of DBC files, one after the other; waited for before all else goes
};

}  // namespace terratact
