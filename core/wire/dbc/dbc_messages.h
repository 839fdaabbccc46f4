#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "core/wire/dbc/dbc_file.h"
#include "core/wire/dbc/dbc_scanner.h"

namespace terratact {

/// What is left out of a file: the first few are said in it, the others counted.
class DbcWarnings {
public:
    /// file: outlives them.
    explicit DbcWarnings(DbcFile& file) : file_(file) {}

    void add(int line, const std::string& what);
    void add(const std::string& what);  ///< it tells its line itself
    void end();                         ///< says how many more there were

private:
    DbcFile& file_;
    std::size_t unsaid_ = 0;
};

/// Reads messages and their signals (BO_, SG_) into a file, and finds them again for what is said of them later.
class DbcMessages {
public:
    /// Where a signal is: indexes of its message and of its payload.
    struct Place {
        std::size_t message = 0, signal = 0;
    };

    /// All outlive it.
    DbcMessages(DbcScanner& scan, DbcFile& file, DbcWarnings& warnings)
        : scan_(scan), file_(file), warnings_(warnings)
    {
    }

    void message(int line);  ///< what is behind BO_
    void signal(int line);   ///< what is behind SG_
    void endMessage();       ///< no signal of it follows

    /// The message whose identifier is next; null: it is not known, or was left out.
    DbcMessage* messageNext(std::size_t* index = nullptr);
    /// Likewise, of identifier and name; empty for the same reasons.
    std::optional<Place> signalNext();
    DbcSignal& at(const Place& place);

    /// Which multiplexor of its message selects a signal, and with which values.
    void select(const Place& place, const std::string& multiplexor,
                std::vector<DbcSignal::Selection> ranges, int line);
    void leaveOut(const Place& place);  ///< at the end of the file
    void rename(const Place& place, std::string longName);

    /// At the end of the file: takes out the signals of which it is not known when they are there, and gives long names.
    void finish();

private:
    /// Of a signal while its message is read.
    struct Multiplexing {
        int line = 0;
        bool selects = false;  // M
    };
    bool mayBe(std::uint64_t id, const DbcMessage& m, int length, int line);
    std::optional<Multiplexing> multiplex(DbcSignal& s, int line);
    void scaleAndRange(DbcSignal& s);
    void range(DbcSignal& s);
    void keep(DbcSignal s, const Multiplexing& multiplexing);
    std::vector<bool> unselectable(std::size_t message) const;
    void finish(std::size_t message, std::vector<bool> isOut);

    DbcScanner& scan_;
    DbcFile& file_;
    DbcWarnings& warnings_;
    std::unordered_map<std::uint64_t, std::size_t> byId_;
    std::map<std::pair<std::size_t, std::string>, std::size_t> signals_;
    std::vector<int> lines_;  // of the first multiplexed signal of each message
    std::map<std::size_t, std::set<std::size_t>> leftOut_;
    std::vector<std::pair<Place, std::string>> longNames_;

    // Of the message that is being read.
    bool isOpen_ = false, keeps_ = false;
    std::set<std::string> names_;
    std::vector<Multiplexing> multiplexing_;  // of its signals
};

}  // namespace terratact
