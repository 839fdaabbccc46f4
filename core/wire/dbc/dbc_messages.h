#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "core/wire/dbc/dbc_file.h"
#include "core/wire/dbc/dbc_scanner.h"

namespace terratact {

/// Collects warnings about skipped parts of a file: lists the first few, and the lines of the others.
class DbcWarnings {
public:
    /// file: must outlive this object.
    explicit DbcWarnings(DbcFile& file) : file_(file) {}

    void add(Message what);  ///< about the whole file: always listed
    void add(int line, const Message& what);
    /// Adds that the entry of that line is left out. failure: names its own line.
    void addEntry(int line, const Message& failure);
    /// Returns readable() of a text, on one line. Adds a warning if the text is cut.
    std::string readableUpTo(std::size_t most, std::string_view text, SourceText what, int line);
    void end();  ///< adds the number of further warnings, and their lines

private:
    void list(int line, Message what);

    DbcFile& file_;
    std::size_t omitted_ = 0;
    std::vector<std::pair<int, int>> lines_;  // first and last line of those in sequence
};

/// Reads messages and their signals (BO_, SG_) into a file, and finds them again for later
/// sections.
class DbcMessages {
public:
    /// Position of a signal: index of its message, and index in that message's payload.
    struct Place {
        std::size_t message = 0, signal = 0;
    };

    /// All arguments must outlive this object.
    DbcMessages(DbcScanner& scan, DbcFile& file, DbcWarnings& warnings)
        : scan_(scan), file_(file), warnings_(warnings)
    {
    }

    void message(int line);  ///< reads what follows BO_
    void signal(int line);   ///< reads what follows SG_
    void endMessage();       ///< ends the signals of the message

    /// Returns the message of the next identifier; null: it is unknown, or was skipped.
    DbcMessage* messageNext(std::size_t* index = nullptr);
    /// Returns the signal of the next identifier and name; empty: it is unknown, or was skipped.
    std::optional<Place> signalNext();
    DbcSignal& at(const Place& place);

    /// Sets the multiplexor of a signal, and the values that select the signal.
    void select(const Place& place, const std::string& multiplexor,
                std::vector<DbcSignal::Selection> ranges, int line);
    void leaveOut(const Place& place);  ///< removes it at the end of the file
    /// Renames a signal at the end of the file, unless another one of its message has the name.
    void rename(const Place& place, std::string longName, int line);

    /// Ends the file: removes signals whose selection is unknown, and assigns long names.
    void finish();

private:
    /// Multiplexing of a signal while its message is read.
    struct Multiplexing {
        int line = 0;
        bool selects = false;  // true: the signal is a multiplexor (M)
    };
    /// Long name of a signal, and its line.
    struct LongName {
        Place place;
        std::string name;
        int line = 0;
    };
    bool mayBe(std::uint64_t id, const DbcMessage& m, int length, int line);
    std::optional<Multiplexing> multiplex(DbcSignal& s, int line);
    void scaleAndRange(DbcSignal& s);
    void range(DbcSignal& s);
    void keep(DbcSignal s, const Multiplexing& multiplexing);
    std::vector<bool> unselectable(std::size_t message) const;
    void assign(LongName longName);
    void finish(std::size_t message, std::vector<bool> isOut);
    void warnOfOverlap(std::size_t message);

    DbcScanner& scan_;
    DbcFile& file_;
    DbcWarnings& warnings_;
    std::unordered_map<std::uint64_t, std::size_t> byId_;
    std::map<std::pair<std::size_t, std::string>, std::size_t> signals_;
    std::vector<int> begins_;  // line of each message
    std::vector<int> lines_;   // line of the first multiplexed signal of each message
    std::map<std::size_t, std::set<std::size_t>> leftOut_;
    std::vector<LongName> longNames_;

    // State of the message that is being read.
    bool isOpen_ = false, keeps_ = false;
    std::set<std::string> names_;
    std::vector<Multiplexing> multiplexing_;  // multiplexing of its signals
};

}  // namespace terratact
