#pragma once

#include <cstddef>
#include <cstdint>
#include <fstream>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace terratact {

/// A value of a row as its page has it.
struct StoredValue {
    enum class Type { None, Integer, Real, Text, Blob } type = Type::None;
    std::int64_t integer = 0;
    double real = 0.0;
    std::string_view bytes{};  ///< of a text or blob; valid as long as the call that it came with
};

struct StoredRow {
    std::optional<std::int64_t> id;  ///< rowid; empty: of a table without
    std::span<const StoredValue> values;
    std::uint32_t page = 0;  ///< that it stands on, from 1
};

/// The pages of an SQLite file, and of a write-ahead journal beside it, one by one, whatever state the file is in: cut,
/// with holes, with pages that were zeroed or overwritten, with something behind its end
/// (sqlite.org/fileformat2.html).  Nothing is followed but the overflow pages of a row.  All values together are at
/// most twice as large as the files.
class PageRows {
public:
    /// pageSize: where the file itself says none that can be.  A file that cannot be opened has no pages.
    PageRows(const std::string& path, std::uint32_t pageSize);

    /// Every row of every leaf, in the order of the pages; those of the journal last.
    void forEach(const std::function<void(const StoredRow&)>& take);

    /// The leaves of the table with this root, as far as its inner pages are there.
    std::set<std::uint32_t> leavesOf(std::uint32_t root);

    std::uint64_t bytes() const { return fileBytes_ + journalBytes_; }
    /// Without a journal: the file is shorter than its header says.
    bool isCut() const { return isCut_; }

private:
    enum class Kind : std::uint8_t { TableInner = 5, IndexLeaf = 10, TableLeaf = 13 };
    void readHeader(std::uint32_t otherwise);
    void readJournal();
    std::string_view page(std::uint32_t number);
    void takePage(std::uint32_t number, std::string_view bytes,
                  const std::function<void(const StoredRow&)>& take);
    bool payloadOf(std::string_view bytes, std::size_t at, bool isTable,
                   std::optional<std::int64_t>& id, std::size_t& room);
    bool addOverflow(std::uint32_t next, std::size_t size);
    bool decode();

    std::ifstream file_, journal_;
    std::uint64_t fileBytes_ = 0, journalBytes_ = 0, bytesLeft_ = 0;
    std::uint32_t pageSize_ = 0, usable_ = 0;
    bool isCut_ = false;
    std::map<std::uint32_t, std::uint64_t> inJournal_;  ///< where the newest state of a page begins
    std::string buffer_, overflow_, payload_;
    std::vector<StoredValue> values_;
};

}  // namespace terratact
