// Logs of CAN frames: candump and ASC.
#include <fmt/format.h>

#include <ctime>
#include <string>

#include "app/recording/export/session_exporter.h"
#include "app/recording/session_text.h"
#include "core/base/text.h"
#include "core/wire/can_codec.h"
#include "core/wire/logs/candump_log.h"
#include "core/wire/logs/log_text.h"

namespace terratact {
namespace {

constexpr std::int64_t kLogSecond = 1'000'000'000;  // [ns]

/// Returns the bus's name in the form that a log allows.
std::string interfaceName(const SessionStart& start)
{
    std::string name = start.bus.substr(0, 15);
    std::erase_if(name, [](char c) { return c <= ' ' || c > '~'; });
    return name.empty() ? "can0" : name;
}

class CandumpExporter final : public Exporter {
public:
    CandumpExporter(std::ostream& out, const SessionStart& start) : out_(out), start_(start) {}

    Taken write(const FrameRow& row) override
    {
        if (row.frame.isCut) return Taken::Inexpressible;
        const double time = static_cast<double>(wallTimeOf(start_, row.time)) * 1e-9;
        out_ << candumpLine(time, interface_, row.frame) << '\n';
        return Taken::Written;
    }

private:
    std::ostream& out_;
    const SessionStart& start_;
    std::string interface_ = interfaceName(start_);
};

/// Vector's format, as written by log2asc and read by asc2log and python-can.
class AscExporter final : public Exporter {
public:
    AscExporter(std::ostream& out, const SessionStart& start) : out_(out), start_(start) {}

    void end() override
    {
        if (!base_) writeHeader(wallTimeOf(start_, 0));
    }

    Taken write(const FrameRow& row) override
    {
        const CanFrame& frame = row.frame;
        const std::int64_t wall = wallTimeOf(start_, row.time);
        if (!base_) writeHeader(wall);
        const std::int64_t time = wall - *base_;
        if (frame.isCut || time < 0) return Taken::Inexpressible;
        const std::string moment =
            fmt::format("{:4}.{:06}", time / kLogSecond, time % kLogSecond / 1000);
        if (frame.error) {
            out_ << moment << " 1  ErrorFrame\n";
            return Taken::Written;
        }
        const std::string id = fmt::format("{:X}{}", frame.id, frame.extended ? "x" : "");
        if (frame.fd) {
            writeFd(moment, id, row);
            return Taken::Written;
        }
        out_ << fmt::format("{} 1  {:<15} {}   {} {:d}", moment, id, row.sent ? "Tx" : "Rx",
                            frame.remote ? 'r' : 'd', frame.length);
        for (std::size_t i = 0; i < frame.length && !frame.remote; ++i)
            out_ << fmt::format(" {:02X}", frame.data.at(i));
        out_ << '\n';
        return Taken::Written;
    }

private:
    /// Unknown flags are 0; 3000 marks a CAN FD frame with bit rate switching.
    void writeFd(const std::string& moment, const std::string& id, const FrameRow& row)
    {
        unsigned code = 0;
        while (bytesOfCode(code) < row.frame.length) ++code;
        out_ << fmt::format("{} CANFD   1 {:<4} {:>8}  {:>32} 1 0 {:x} {:>2}", moment,
                            row.sent ? "Tx" : "Rx", id, "", code, row.frame.length);
        for (const std::uint8_t byte : bytesOf(row.frame)) out_ << fmt::format(" {:02X}", byte);
        out_ << "        0    0     3000        0        0        0        0        0\n";
    }

    /// Writes the header, whose date has whole seconds. first: [ns] since 1970; a recording may begin before its time
    /// 0.
    void writeHeader(std::int64_t first)
    {
        base_ = std::min(first, wallTimeOf(start_, 0)) / kLogSecond * kLogSecond;
        const std::time_t seconds = *base_ / kLogSecond;
        std::tm when{};
        localtime_r(&seconds, &when);
        constexpr std::array kDays{"Sun", "Mon", "Tue", "Wed", "Thu", "Fri", "Sat"};
        constexpr std::array kMonths{"Jan", "Feb", "Mar", "Apr", "May", "Jun",
                                     "Jul", "Aug", "Sep", "Oct", "Nov", "Dec"};
        out_ << fmt::format("date {} {} {:02} {:02}:{:02}:{:02} {}\n",
                            kDays.at(static_cast<std::size_t>(when.tm_wday)),
                            kMonths.at(static_cast<std::size_t>(when.tm_mon)), when.tm_mday,
                            when.tm_hour, when.tm_min, when.tm_sec, 1900 + when.tm_year)
             << "base hex  timestamps absolute\nno internal events logged\n";
    }

    std::ostream& out_;
    const SessionStart& start_;
    std::optional<std::int64_t> base_;  ///< [ns] since 1970 of the file's time 0
};

}  // namespace

std::unique_ptr<Exporter> candumpExporter(std::ostream& out, const SessionStart& start)
{
    return std::make_unique<CandumpExporter>(out, start);
}

std::unique_ptr<Exporter> ascExporter(std::ostream& out, const SessionStart& start)
{
    return std::make_unique<AscExporter>(out, start);
}

}  // namespace terratact
