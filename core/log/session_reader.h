#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/log/rows/session_hash.h"
#include "core/log/rows/session_rows.h"

namespace terratact {

/// Time span whose rows are hidden, because they are not what was recorded.
struct SessionDamage {
    SessionTime first = 0, last = 0;
    Message why;
    bool operator==(const SessionDamage&) const = default;
};

/// Result of verify().
struct SessionVerification {
    std::int64_t batches = 0, frames = 0, events = 0;
    std::string chain;  ///< last valid link, 64 hexadecimal digits
    /// Span from which nothing is proven; empty: the whole chain is valid.
    std::optional<SessionDamage> broken;
    std::vector<SessionDamage> damage;  ///< batches whose rows are not what was recorded
};

/// Reads a session file from an untrusted source (docs/sessions.md). The file is opened read-only,
/// nothing in it is executed, and every value is checked. Rows are hash-chained: a row is returned
/// only if its batch's hash is valid. All other rows are reported by damage().
/// Memory grows with the batches, at most kMaxBatches, and not with the frames. All values of one
/// pass are together at most as large as the file, even if rows share pages.
///
/// A session that was not closed is read with its journal, even if its folder is write-protected.
/// If the journal is missing, only the file is read, and damage() names what is missing. A damaged
/// journal is read up to its damage, which damage() names.
///
/// refresh() reads new rows of a file that is still being written. One thread at a time may use a
/// reader.
class SessionReader {
public:
    static constexpr std::int64_t kMaxChecked = std::int64_t{64} << 20U;  ///< bytes: 0.3 s

    /// Opens a session. Errors name the file: it is no session, has another version, is truncated,
    /// or its tables are damaged. Other structural damage is reported by damage(). It is searched
    /// for in files of at most kMaxChecked bytes, and by verify().
    /// atATime: number of batches that are judged together. Their rows are held in memory
    /// meanwhile, in addition to 72 bytes for every batch of the file.
    static Result<SessionReader> open(const std::string& path, std::size_t atATime = kAtATime);

    /// Opens rows that were salvaged from a damaged file. It returns the rows of every batch whose
    /// hash is valid, and its frames if theirs is. The chain need not lead to the batch.
    static Result<SessionReader> openFragments(const std::string& path);

    SessionReader(SessionReader&&) noexcept;
    SessionReader& operator=(SessionReader&&) noexcept;
    ~SessionReader();

    const std::string& path() const;
    const SessionStart& start() const;
    bool sealed() const;        ///< closed by its writer, or recovered
    SessionTime begin() const;  ///< time of the first row; 0: there is none
    SessionTime end() const;    ///< time of the last row
    std::int64_t frameCount() const;

    // Rows in the order of their ids. That is the order of time, except for overlapping ones.
    // Estimates come without their draws.
    const std::vector<ModelRow>& models() const;
    const std::vector<SceneRow>& scenes() const;
    const std::vector<EstimateRow>& estimates() const;
    const std::vector<ProposalRow>& proposals() const;
    const std::vector<EventRow>& events() const;
    const std::vector<SessionBatch>& batches() const;

    /// Return the row of that id; null if there is none.
    const ModelRow* model(std::int64_t id) const;
    const SceneRow* scene(std::int64_t id) const;
    const EstimateRow* estimate(std::int64_t id) const;
    const ProposalRow* proposal(std::int64_t id) const;

    /// Returns the damage found so far: that of rows since open(), that of frames once they were
    /// read.
    const std::vector<SessionDamage>& damage() const;

    /// Returns true if the session was not closed and its journal is missing.
    bool lacksJournal() const;

    /// Returns the first batch that ends at `time` or later; batches().size() if there is none.
    std::size_t batchAt(SessionTime time) const;

    /// Returns the frames of batches()[batch] in the order of reception. It returns none and adds
    /// to damage() if they are not what was recorded. Throws std::invalid_argument if there is no
    /// such batch.
    std::vector<FrameRow> frames(std::size_t batch);

    /// Returns the draws of both sides of an estimate; those of one plane are equal. Errors name the
    /// file.
    Result<SideDraws> draws(std::int64_t estimate);

    /// Reads what was committed since the last call. Returns true if there was anything. Errors
    /// name the file.
    Result<bool> refresh();

    /// Reads and checks the whole file. progress(share of the batches) ends it by returning false.
    SessionVerification verify(const std::function<bool(double)>& progress = {});

private:
    struct Impl;
    static constexpr std::size_t kAtATime = 65'536;
    static Result<SessionReader> open(const std::string& path, std::size_t atATime,
                                      bool chainCounts);
    explicit SessionReader(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

}  // namespace terratact
