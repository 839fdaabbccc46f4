#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

#include "core/log/rows/session_rows.h"
#include "core/log/rows/session_schema.h"
#include "core/store/sha256.h"
#include "core/store/sqlite.h"

namespace terratact {

/// Thrown by readers of rows if a row holds what no session can hold. SessionReader catches it.
class RefusedRow : public Failure {
public:
    using Failure::Failure;
};

inline void require(bool holds, SourceText cause)
{
    if (!holds) throw RefusedRow{cause};
}

/// Reads the current row of a statement column by column, starting at `from`, and checks each
/// value. Throws RefusedRow for a value beyond what a session can hold, SqliteError for a value of
/// another type.
class CheckedRow {
public:
    explicit CheckedRow(const SqliteStatement& statement, int from = 0)
        : statement_(statement), at_(from)
    {
    }
    std::int64_t integer(std::int64_t least, std::int64_t most)
    {
        const std::int64_t value = statement_.integer(at_++);
        require(value >= least && value <= most, TR_NOOP("core", "a number is out of range"));
        return value;
    }
    int small(int least, int most) { return static_cast<int>(integer(least, most)); }
    std::int64_t id() { return integer(1, kMaxCount); }
    std::int64_t idOrNone() { return integer(0, kMaxCount); }
    SessionTime time() { return integer(-kMaxSessionTime, kMaxSessionTime); }
    bool flag() { return integer(0, 1) == 1; }
    double real(double least = -kMaxNumber, double most = kMaxNumber)
    {
        const double value = statement_.real(at_++);
        require(value >= least && value <= most, TR_NOOP("core", "a number is out of range"));
        return value;
    }
    std::optional<double> realOrNone()
    {
        if (!statement_.isNull(at_)) return real();
        ++at_;
        return std::nullopt;
    }
    /// Returns true if the row has a further column: files of version 1 have fewer.
    bool hasMore() const { return at_ < statement_.columns(); }
    /// Returns empty for +infinity, which means "not measured" in a column that is never NULL.
    std::optional<double> realOrInfinite()
    {
        if (statement_.real(at_) < std::numeric_limits<double>::infinity()) return real();
        ++at_;
        return std::nullopt;
    }
    bool isNone() const { return statement_.isNull(at_); }
    /// Requires that the next `count` columns are all NULL (none), or all not NULL. Reading goes on at
    /// the same column.
    void requireNone(bool none, int count, SourceText cause) const
    {
        for (int i = 0; i < count; ++i) require(statement_.isNull(at_ + i) == none, cause);
    }
    void skip(int columns) { at_ += columns; }
    std::string text()
    {
        std::string value = statement_.text(at_++);
        require(value.size() <= kMaxTextBytes, TR_NOOP("core", "a text is too long"));
        return value;
    }
    std::string blob() { return statement_.blob(at_++); }
    std::string hash()
    {
        std::string value = blob();
        require(value.size() == Sha256::kBytes, TR_NOOP("core", "a hash has the wrong length"));
        return value;
    }
    template <class Value>
    Value named(std::optional<Value> (*fromName)(std::string_view))
    {
        const auto value = fromName(text());
        require(value.has_value(), TR_NOOP("core", "an unknown name"));
        return *value;
    }

private:
    static constexpr double kMaxNumber = 1e12;
    static constexpr std::int64_t kMaxCount = std::int64_t{1} << 48;

    const SqliteStatement& statement_;
    int at_;
};

}  // namespace terratact
