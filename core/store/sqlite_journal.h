#pragma once

#include <array>
#include <cstdint>
#include <fstream>
#include <optional>
#include <string>

namespace terratact {

/// Reads a write-ahead journal frame by frame (sqlite.org/fileformat2.html §4). A frame is a page in
/// a newer state. SQLite reads the frames up to the first that is not intact, and ignores the rest.
/// This reader goes on behind it.
class JournalFrames {
public:
    /// A file that cannot be opened, or is no regular file, has no bytes.
    explicit JournalFrames(const std::string& path);

    /// Returns true if the file has bytes but no intact header. SQLite ignores such a journal.
    bool hasDamagedHeader() const { return hasBytes_ && !hasHeader_; }

    std::uint32_t pageSize() const { return pageSize_; }  ///< [bytes]; 0: the header gives none

    /// Moves to the next frame. Returns false at the end of the file, also within a frame.
    bool next();

    // The frame that next() has read.
    std::uint64_t at() const { return at_; }  ///< [bytes] from the beginning of the journal
    std::uint64_t pageAt() const;             ///< the same of its page
    std::uint32_t page() const;               ///< number of its page, from 1
    bool commits() const;                     ///< a transaction ends with it

    /// Returns true if all salts and checksums up to here are right. SQLite reads such frames up to
    /// the last that commits.
    bool isIntact() const { return isIntact_; }
    /// Returns true if it has the salts of the header: it was written since the last restart. After
    /// a checkpoint the writer restarts: it overwrites the journal from the beginning.
    bool isCurrent() const;
    /// Returns true if it was written before the last restart. A restart adds 1 to the first salt.
    bool isOlder() const;
    /// Returns true if it has neither salts nor checksums yet. In a transaction that does not fit
    /// into memory, SQLite adds them at the commit.
    bool isUnfinished() const;
    /// Returns true if it and all bytes behind it are zeros: a power loss leaves blocks that were not
    /// written yet as zeros.
    bool isUnwritten() const { return at_ >= contentEnd_; }

private:
    bool continuesChain();

    std::ifstream in_;
    std::string header_, frame_;
    std::uint64_t at_ = 0, next_ = 0;
    std::uint64_t contentEnd_ = 0;  ///< [bytes] behind the last byte that is not 0
    std::uint32_t pageSize_ = 0;
    std::array<std::uint32_t, 2> sum_{};  ///< running checksum
    bool isBig_ = false;                  ///< checksums are those of big-endian words
    bool hasBytes_ = false, hasHeader_ = false, isIntact_ = false;
};

/// Place from which SQLite does not read a journal any further, although more was written.
struct JournalDamage {
    std::uint64_t at = 0;      ///< [bytes] first frame that is not intact; 0: the header is damaged
    std::uint64_t frames = 0;  ///< frames that are not read, for at > 0
    bool operator==(const JournalDamage&) const = default;
};

/// Returns the damage of a journal; empty: none, or the file has no bytes. Not damage are:
///   - older frames behind the intact ones, which the writer would have overwritten next;
///   - frames of a transaction that was not committed;
///   - frames of a last transaction that are not whole, as a writer or a power loss leaves them: a
///     transaction is on the disk before the next one begins;
///   - zeros up to the end of the file behind a transaction that is read: blocks of such a last one;
///   - an end of the file within a frame.
/// A journal that is being written meanwhile is not called damaged.
std::optional<JournalDamage> journalDamage(const std::string& journal);

}  // namespace terratact
