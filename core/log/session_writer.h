#pragma once

#include <cerrno>
#include <memory>
#include <string>

#include "core/base/result.h"
#include "core/log/rows/session_rows.h"
#include "core/store/sqlite.h"

namespace terratact {

enum class SessionRecovery : std::uint8_t;

/// Writes a session file (docs/sessions.md). Rows are collected in a transaction. commit() makes
/// them a batch with the hashes of core/log/rows/session_hash.h. Committed rows survive a crash of the
/// process, and a power failure if the disk flushes when asked.
///
/// One writer per file, used by one thread. After an Error of add() or commit(), the rows since the
/// last commit are lost. The writer cannot be used any more. The committed rows are in the file.
class SessionWriter {
public:
    /// Creates the file for its owner only (mode 0600). The file must not exist, its directory must
    /// exist. The start is in the file at once. The last kCheckpointBatches batches or
    /// kCheckpointBytes are in the journal beside it until seal().
    /// Errors name the file, or report control characters in the bus name, which would move the
    /// cursor of a terminal.
    static Result<SessionWriter> create(const std::string& path, const SessionStart& start);

    SessionWriter(SessionWriter&&) noexcept;
    SessionWriter& operator=(SessionWriter&&) noexcept;
    ~SessionWriter();

    static constexpr int kCheckpointBatches = 25;  ///< 5 s of recording by a console
    static constexpr std::size_t kCheckpointBytes = 1'000'000;

    // Add rows. Texts are cut after kMaxTextBytes; events get their numbers here. They throw
    // std::invalid_argument and change nothing in four cases. An id is not larger than all earlier
    // ids of its kind. A row refers to one that was not added. A number is not finite. The sides of
    // an estimate contradict each other (EstimateRow).
    Status add(const FrameRow& row);
    Status add(const ModelRow& row);
    Status add(const SceneRow& row);
    Status add(const EstimateRow& row);
    Status add(const ProposalRow& row);
    Status add(const EventRow& row);

    /// Makes a batch of the rows since the last one, and returns once it is on the disk. Does
    /// nothing without rows.
    Status commit();

    /// Commits, and leaves a single file that can be read from a read-only folder. The writer
    /// cannot be used after that.
    Status seal();

    std::int64_t frames() const;   ///< number of committed frames
    std::int64_t batches() const;  ///< number of committed batches
    std::string chain() const;     ///< last link, 64 hexadecimal digits

    const std::string& path() const;

private:
    friend Result<SessionRecovery> recoverSession(const std::string& path, bool evenAlone);
    struct Impl;
    static Result<SessionRecovery> finish(const std::string& path, SqliteFile file);
    explicit SessionWriter(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

enum class SessionRecovery : std::uint8_t {
    NotNeeded,  ///< its writer closed it
    InUse,      ///< another process has it open, most likely its writer: nothing was done
    Recovered,
};

/// Error::code if a file or its journal is a symbolic link.
inline constexpr int kNotFollowed = ELOOP;

/// Closes a session whose writer died: replays its journal, adds an event at its end and seals it.
/// evenAlone: also recovers a session whose journal is missing; the journal must then not come
/// back. Errors name the file, which stays as it was, with its journal. It is no session, is damaged,
/// or is a symbolic link (kNotFollowed). Its journal is missing or damaged, or it cannot be written.
Result<SessionRecovery> recoverSession(const std::string& path, bool evenAlone = false);

}  // namespace terratact
