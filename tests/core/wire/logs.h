#pragma once

#include <sstream>
#include <string>
#include <vector>

#include "core/wire/logs/log_reader.h"

namespace terratact {

using Bytes = std::vector<std::uint8_t>;

inline CanFrame data(std::uint32_t id, const Bytes& bytes, bool extended = false)
{
    CanFrame frame{.id = id,
                   .extended = extended,
                   .fd = bytes.size() > 8,
                   .length = static_cast<std::uint8_t>(bytes.size())};
    std::copy(bytes.begin(), bytes.end(), frame.data.begin());
    return frame;
}

struct Log {
    std::vector<LoggedFrame> frames;
    std::vector<double> elapsed;
    std::vector<std::string> remarks;
    std::string format, error;
    bool isTorn = false;
};

inline Log read(const std::string& content)
{
    LogReader reader("a.log", std::make_unique<std::istringstream>(content));
    Log log;
    for (;;) {
        const auto next = reader.next();
        for (const Message& remark : reader.consumeRemarks())
            log.remarks.push_back(remark.english());
        if (!next) log.error = next.error().text;
        if (!next || !*next) break;
        log.frames.push_back(**next);
        log.elapsed.push_back(reader.elapsed());
    }
    log.format = reader.format();
    log.isTorn = reader.isTorn();
    return log;
}

inline const std::string kTwo = "(1000.000000) can0 500#DDFF01\n(1000.100000) can0 500#DDFF02\n";

/// A log in the format of Vector's tools.
inline const std::string kAsc =
    "date Thu Jan 01 00:16:40 1970\n"
    "base hex  timestamps absolute\n"
    "no internal events logged\n"
    "// version 9.0.0\n"
    "Begin Triggerblock Thu Jan 01 00:16:40 1970\n"
    "   0.000000 Start of measurement\n"
    "   0.015991 1  Statistic: D 0 R 0 XD 0 XR 0 E 0 O 0 B 0.00%\n"
    "   0.100000 1  500             Rx   d 3 DD FF 01  Length = 0 BitCount = 0\n"
    "   0.200000 2  18FEF1FEx       Tx   d 8 01 02 03 04 05 06 07 08\n"
    "   0.300000 1  123             Rx   r Length = 1704000 BitCount = 145\n"
    "   0.310000 1  123             Rx   r 4 Length = 1704000 BitCount = 145\n"
    "   0.320000 1  123             TxRq d 1 00\n"
    "   0.400000 2  ErrorFrame\n"
    "   0.500000 CANFD   1 Rx        50B                                   1 0 a "
    "16 00 01 02 03 04 05 06 07 08 09 0A 0B 0C 0D 0E 0F   130000  130     3000 0\n"
    "   0.600000 CANFD   2 Tx   18FEF1FEx  Name_of_it   0 0 2  2 AA BB  0 0 3000 0\n"
    "   0.700000 CANFD   2 Tx        7FF  0 0 2  2 AA BB  0 0 0 0\n"
    "End TriggerBlock\n";

}  // namespace terratact
