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

/// Value of a row as stored in its page.
struct StoredValue {
    enum class Type { None, Integer, Real, Text, Blob } type = Type::None;
    std::int64_t integer = 0;
    double real = 0.0;
    std::string_view bytes{};  ///< text or blob; valid during the call that delivers it
};

struct StoredRow {
    std::optional<std::int64_t> id;  ///< rowid; empty: from a table without one
    std::span<const StoredValue> values;
    std::uint32_t page = 0;  ///< number of its page, from 1
};

/// Reads the pages of an SQLite file, and of a write-ahead journal beside it, one by one
/// (sqlite.org/fileformat2.html). The file may be cut, have holes, zeroed or overwritten pages, or
/// bytes behind its end. It follows no page reference but the overflow pages of a row. All values
/// together are at most twice as large as the files.
class PageRows {
public:
    /// pageSize: used if the file gives no valid page size. A file that cannot be opened has no
    /// pages. journal: its path; empty: none.
    PageRows(const std::string& path, std::uint32_t pageSize, const std::string& journal);

    /// Visits every row of every leaf in page order; rows of the journal come last.
    void forEach(const std::function<void(const StoredRow&)>& visit);

    /// Returns the leaves of the table with this root, as far as its inner pages exist.
    std::set<std::uint32_t> leavesOf(std::uint32_t root);

    std::uint64_t bytes() const { return fileBytes_ + journalBytes_; }
    /// True without a journal if the file is shorter than the size in its header.
    bool isCut() const { return isCut_; }

private:
    enum class Kind : std::uint8_t { TableInner = 5, IndexLeaf = 10, TableLeaf = 13 };
    void readHeader(std::uint32_t otherwise);
    void readJournal(const std::string& path);
    std::string_view page(std::uint32_t number);
    void visitPage(std::uint32_t number, std::string_view bytes,
                   const std::function<void(const StoredRow&)>& visit);
    bool payloadOf(std::string_view bytes, std::size_t at, bool isTable,
                   std::optional<std::int64_t>& id, std::size_t& room);
    bool addOverflow(std::uint32_t next, std::size_t size);
    bool decode();

    std::ifstream file_, journal_;
    std::uint64_t fileBytes_ = 0, journalBytes_ = 0, bytesLeft_ = 0;
    std::uint32_t pageSize_ = 0, usable_ = 0;
    bool isCut_ = false;
    std::map<std::uint32_t, std::uint64_t> inJournal_;  ///< offset of the newest state of each page
    std::string buffer_, overflow_, payload_;
    std::vector<StoredValue> values_;
};

}  // namespace terratact
