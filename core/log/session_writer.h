#pragma once

#include <cerrno>
#include <memory>
#include <string>

#include "core/base/result.h"
#include "core/log/session_rows.h"
#include "core/store/sqlite.h"

namespace terratact {

enum class SessionRecovery : std::uint8_t;

/// Writes a session file (docs/sessions.md).  Rows are gathered in a transaction; commit() makes a batch of
/// them, with the hashes of core/log/session_hash.h.  What was committed outlives the process, and the power as
/// far as the disk is honest.
///
/// One writer per file, used by one thread.  After an Error of add() or commit() the rows since the last commit
/// are lost and the writer is of no use any more: what was committed is in the file.
class SessionWriter {
public:
    /// Creates the file, which must not exist, in a directory that must, for its owner alone to read (mode 0600).
    /// The file itself says at once what it is and what `start` says; of what follows it has all but the last
    /// kCheckpointBatches batches and kCheckpointBytes, which are in the journal beside it until seal().  Errors
    /// name it, or say that the bus has no name that can be recorded: one with control characters, which would
    /// move the cursor of every terminal that shows it.
    static Result<SessionWriter> create(const std::string& path, const SessionStart& start);

    SessionWriter(SessionWriter&&) noexcept;
    SessionWriter& operator=(SessionWriter&&) noexcept;
    ~SessionWriter();

    static constexpr int kCheckpointBatches = 25;  ///< 5 s of a console
    static constexpr std::size_t kCheckpointBytes = 1'000'000;

    // Texts of rows are cut after kMaxTextBytes.  The id of a model, scene, estimate or proposal is larger than any before of its kind, and what they refer to
    // has been added, and every number is finite; throw std::invalid_argument otherwise, and nothing has happened.
    // Events are numbered here.
    Status add(const FrameRow& row);
    Status add(const ModelRow& row);
    Status add(const SceneRow& row);
    Status add(const EstimateRow& row);
    Status add(const ProposalRow& row);
    Status add(const EventRow& row);

    /// Makes a batch of the rows since the last one and returns once the disk has it; nothing where there are
    /// none.
    Status commit();

    /// Commits, and leaves a single file that can be read from a read-only folder.  The writer is then of no use.
    Status seal();

    std::int64_t frames() const;   ///< committed
    std::int64_t batches() const;  ///< committed
    std::string chain() const;     ///< the last link, 64 hexadecimal digits

    const std::string& path() const;

private:
    friend Result<SessionRecovery> recoverSession(const std::string& path, bool evenAlone);
    struct Impl;
    static Result<SessionRecovery> finish(const std::string& path, SqliteFile file);
    explicit SessionWriter(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

enum class SessionRecovery : std::uint8_t {
    NotNeeded,  ///< it was closed by its writer
    InUse,      ///< somebody has it open, most likely its writer: nothing was done
    Recovered,
};

/// Error::code where a file, or its journal, is a symbolic link.
inline constexpr int kNotFollowed = ELOOP;

/// Closes a session whose writer died: plays its journal back, says so in an event at its end and seals it.
/// evenAlone: also one without its journal beside it, which for that must not come back.
/// Errors name the file: it is no session, damaged, a symbolic link (kNotFollowed), its journal is not beside it, or it
/// cannot be written; it is then as it was.
Result<SessionRecovery> recoverSession(const std::string& path, bool evenAlone = false);

}  // namespace terratact
