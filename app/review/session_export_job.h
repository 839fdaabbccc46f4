#pragma once

#include <QObject>
#include <atomic>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "app/recording/session_export.h"

namespace terratact {

/// Writes one file of a session in a thread of its own, with a reader of its own.  The signals come from that
/// thread.  Its destruction cancels what is not done.
class SessionExportJob final : public QObject {
    Q_OBJECT
public:
    struct Wish {
        std::string session, out;
        std::optional<ExportFormat> format{};  ///< empty: the report of a scene
        ExportSelection selection{};
        std::int64_t scene = 0;          ///< of the report
        std::vector<std::string> dbc{};  ///< files; selection.book is made of them
    };
    explicit SessionExportJob(Wish wish);
    ~SessionExportJob() override;

    void start();   ///< once, when whoever wants to know is connected
    void cancel();  ///< ended() follows, and where it came in time there is no file
    bool cancelled() const { return cancelled_; }

signals:
    void progressed(double share);  ///< 0 … 1
    /// trouble: empty where the file is written.  leftOut: frames that the format cannot hold.  damaged: places of
    /// the session of which nothing was written.  withoutColumns: messages of DBC files that found no room.
    void ended(const QString& trouble, qulonglong leftOut, int damaged, int withoutColumns);

private:
    void run();
    Result<ExportCounts> write(SessionReader& session);
    bool goOn(double share);

    Wish wish_;
    std::atomic<bool> cancelled_ = false;
    int percent_ = -1;     ///< that was told
    std::jthread thread_;  // last: it ends before all else
};

}  // namespace terratact
