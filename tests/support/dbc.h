#pragma once

#include <map>
#include <string>
#include <vector>

namespace terratact {

struct DbcSignal {
    std::string name;
    int start = 0, length = 0;
    bool isSigned = false;
    double scale = 0.0, offset = 0.0, least = 0.0, most = 0.0;
    std::string unit, receiver, comment;
    std::map<int, std::string> words;  ///< of raw values
};

struct DbcMessage {
    unsigned id = 0;
    std::string name, sender, comment;
    int length = 0;
    std::vector<DbcSignal> signals;
    std::map<std::string, int> attributes;

    /// Throws std::out_of_range for none of that name.
    const DbcSignal& signal(const std::string& signalName) const;
};

/// Reads the part of the DBC language that our file uses: little-endian signals without multiplexing.  It
/// knows nothing of the codec.  Throws std::runtime_error with the line for anything else.
std::vector<DbcMessage> readDbc(const std::string& path);

}  // namespace terratact
