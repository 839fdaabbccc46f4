#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/log/session_hash.h"
#include "core/log/session_rows.h"

namespace terratact {

/// A span of time whose rows are not shown, since they are not what was recorded.
struct SessionDamage {
    SessionTime first = 0, last = 0;
    std::string why;
    bool operator==(const SessionDamage&) const = default;
};

/// What verify() found.
struct SessionVerification {
    std::int64_t batches = 0, frames = 0, events = 0;
    std::string chain;                    ///< last link that holds, 64 hexadecimal digits
    std::optional<SessionDamage> broken;  ///< from where on nothing is proven; empty: all holds
    std::vector<SessionDamage> damage;    ///< batches whose rows are not what was recorded
};

/// Reads a session file that may come from anyone (docs/sessions.md): read-only, nothing in it is executed,
/// every value is checked.  A row is handed out only if its batch's hash holds, so that what is shown is a part
/// of what was recorded; what is not is damage().  Memory does not grow with the frames but with the batches, of
/// which there are at most kMaxBatches.  All values that are read in one go are together at most as large as the
/// file, whatever rows share.
///
/// A session that nobody closed is read with its journal, also where its folder cannot be written.  Where the journal
/// is not there, what the file alone holds is read, and damage() says what is missing.
///
/// A file that is still written can be read at the same time: refresh().  Not to be shared between threads.
class SessionReader {
public:
    static constexpr std::int64_t kMaxChecked = std::int64_t{64} << 20U;  ///< bytes: 0.3 s

    /// Errors name the file: no session, of another version, truncated, damaged where its tables are.  Damage of the
    /// structure elsewhere is damage(); it is looked for in files of at most kMaxChecked bytes, and by verify().
    /// atATime: batches whose rows are judged together; what is held of them meanwhile comes on top of 72 bytes
    /// for every batch of the file.
    static Result<SessionReader> open(const std::string& path, std::size_t atATime = kAtATime);

    /// The same of rows that were brought out of a damaged file: the rows of every batch whose rows are what was
    /// recorded, and its frames where they are, also where the chain does not lead to it.
    static Result<SessionReader> openFragments(const std::string& path);

    SessionReader(SessionReader&&) noexcept;
    SessionReader& operator=(SessionReader&&) noexcept;
    ~SessionReader();

    const std::string& path() const;
    const SessionStart& start() const;
    bool sealed() const;        ///< closed by its writer, or recovered
    SessionTime begin() const;  ///< of the first row; 0 where there is none
    SessionTime end() const;    ///< of the last
    std::int64_t frameCount() const;

    // In the order of their ids, which is that of time but for what overlapped.  Estimates come without their
    // draws.
    const std::vector<ModelRow>& models() const;
    const std::vector<SceneRow>& scenes() const;
    const std::vector<EstimateRow>& estimates() const;
    const std::vector<ProposalRow>& proposals() const;
    const std::vector<EventRow>& events() const;
    const std::vector<SessionBatch>& batches() const;

    /// By id; null where there is none.
    const ModelRow* model(std::int64_t id) const;
    const SceneRow* scene(std::int64_t id) const;
    const EstimateRow* estimate(std::int64_t id) const;
    const ProposalRow* proposal(std::int64_t id) const;

    /// What is known to be damaged so far: rows from open() on, frames once they were asked for.
    const std::vector<SessionDamage>& damage() const;

    /// Nobody has closed it, and the journal that belongs to it is not beside it.
    bool lacksJournal() const;

    /// The first batch that ends at `time` or later; batches().size() where none does.
    std::size_t batchAt(SessionTime time) const;

    /// The frames of batches()[batch] in the order in which they were received; empty, and more damage(), where
    /// they are not what was recorded.  Throws std::invalid_argument where there is no such batch.
    std::vector<FrameRow> frames(std::size_t batch);

    /// Draws of an estimate.  Errors name the file.
    Result<std::vector<Heights>> draws(std::int64_t estimate);

    /// What was committed since; whether there was any.  Errors name the file.
    Result<bool> refresh();

    /// Reads everything.  progress(share of the batches) may end it by returning false.
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
