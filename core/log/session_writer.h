#pragma once

#include <memory>
#include <string>

#include "core/log/session_rows.h"
#include "core/result.h"
#include "core/sqlite.h"

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
    /// Creates the file, which must not exist, in a directory that must.  Errors name it.
    static Result<SessionWriter> create(const std::string& path, const SessionStart& start);

    SessionWriter(SessionWriter&&) noexcept;
    SessionWriter& operator=(SessionWriter&&) noexcept;
    ~SessionWriter();

    // The id of a model, scene, estimate or proposal is larger than any before of its kind, and what they refer to
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
    friend Result<SessionRecovery> recoverSession(const std::string& path);
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

/// Closes a session whose writer died: plays its journal back, says so in an event at its end and seals it.
/// Errors name the file: it is no session, or damaged.
Result<SessionRecovery> recoverSession(const std::string& path);

}  // namespace terratact
