#pragma once

#include <QObject>
#include <atomic>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "app/recording/export/session_export.h"

namespace terratact {

/// Writes one export of a session in its own thread with its own reader. Signals are emitted in that thread. The
/// destructor cancels an unfinished export.
class SessionExportJob final : public QObject {
    Q_OBJECT
public:
    struct Wish {
        std::string session, out;
        bool strip = false;                    ///< the strip of felt ground, else as follows
        std::optional<ExportFormat> format{};  ///< empty: a report
        ExportSelection selection{};
        std::int64_t scene = 0;          ///< scene of the report; 0: the mission report
        std::vector<std::string> dbc{};  ///< DBC files from which selection.book is made
    };
    explicit SessionExportJob(Wish wish);
    ~SessionExportJob() override;

    void start();  ///< call once, after connecting the signals
    /// ended() follows. A cancelled export leaves no file.
    void cancel();
    bool cancelled() const { return cancelled_; }

signals:
    void progressed(double share);  ///< 0 … 1
    /// trouble: error text; empty: the file was written. leftOut: frames the format cannot express. damaged: damaged
    /// ranges that were omitted. withoutColumns: DBC messages beyond the bound.
    void ended(const QString& trouble, qulonglong leftOut, int damaged, int withoutColumns);

private:
    void run();
    Result<ExportCounts> write(SessionReader& session);
    bool goOn(double share);

    Wish wish_;
    std::atomic<bool> cancelled_ = false;
    int percent_ = -1;     ///< last emitted progress
    std::jthread thread_;  // last member: it ends before all others are destroyed
};

}  // namespace terratact
