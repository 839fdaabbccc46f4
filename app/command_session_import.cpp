#include <fmt/format.h>

#include <cmath>
#include <filesystem>

#include "app/session_commands.h"
#include "core/file_read.h"
#include "core/learn/sha256.h"
#include "core/log/session_writer.h"
#include "core/wire/candump_log.h"

namespace terratact {

namespace {

constexpr int kBatch = 250;  // frames
constexpr std::size_t kMostRobot = std::size_t{64} * 1024;

/// The frames of one interface of a log into a session that is begun with the first.
class Importer {
public:
    Importer(const SessionImportOptions& options, std::string robot)
        : options_(options), robot_(std::move(robot))
    {
    }

    Status run(CandumpReader& log)
    {
        for (;;) {
            const auto logged = log.next();
            if (!logged) return logged.error();
            if (!*logged) break;
            if (!options_.interface.empty() && (*logged)->interface != options_.interface) continue;
            if (Status taken = take(log, **logged); !taken) return taken;
        }
        if (!writer_) return fileError(options_.log, "holds no frame");
        EventRow ended{.id = 2, .time = last_, .kind = EventKind::Session, .subject = "ended"};
        if (log.dropped() > 0) {
            ended.id = 3;
            const EventRow gap{.id = 2,
                               .time = last_,
                               .kind = EventKind::Gap,
                               .subject = "log",
                               .text = "frames that were lost when the log was recorded",
                               .number = static_cast<double>(log.dropped())};
            if (Status told = writer_->add(gap); !told) return told;
        }
        if (Status told = writer_->add(ended); !told) return told;
        if (Status sealed = writer_->seal(); !sealed) return sealed;
        fmt::print("{} frames of {} written to {}; last link {}\n", writer_->frames(), interface_,
                   options_.out, writer_->chain());
        return Done{};
    }

    bool began() const { return writer_.has_value(); }

private:
    Status take(const CandumpReader& log, const LoggedFrame& logged)
    {
        if (!logged.time || *logged.time < 0.0 || *logged.time > 9e9)
            return log.error("has no time that a session could have");
        if (!writer_)
            if (Status begun = begin(logged); !begun) return begun;
        if (logged.interface != interface_)
            return log.error(fmt::format("is of {}, the log began with {}: --interface says which "
                                         "is wanted",
                                         logged.interface, interface_));
        last_ = sessionTimeOf(*logged.time - begin_);
        const FrameRow row{
            .time = last_, .frame = logged.frame, .sent = logged.direction == LogDirection::Sent};
        if (Status added = writer_->add(row); !added) return added;
        return ++count_ % kBatch == 0 ? writer_->commit() : Status(Done{});
    }

    Status begin(const LoggedFrame& first)
    {
        begin_ = *first.time;
        interface_ = first.interface;
        const SessionStart start{.wallTime = sessionTimeOf(begin_),
                                 .program = "terratact session import",
                                 .source = std::filesystem::path(options_.log).filename().string(),
                                 .bus = interface_,
                                 .transmits = false,
                                 .robot = robot_,
                                 .robotHash = sha256Hex(robot_)};
        auto writer = SessionWriter::create(options_.out, start);
        if (!writer) return writer.error();
        writer_ = std::move(*writer);
        return writer_->add(EventRow{.id = 1,
                                     .kind = EventKind::Session,
                                     .subject = "begun",
                                     .text = "from a log of CAN frames"});
    }

    const SessionImportOptions& options_;
    std::string robot_, interface_;
    std::optional<SessionWriter> writer_;
    double begin_ = 0.0;  ///< [s] on the log's clock
    SessionTime last_ = 0;
    std::uint64_t count_ = 0;
};

}  // namespace

Status importLog(const SessionImportOptions& options)
{
    auto robot = readFile(options.robot, kMostRobot);
    if (!robot) return robot.error();
    auto log = CandumpReader::open(options.log);
    if (!log) return log.error();
    Importer importer(options, std::move(*robot));
    Status done = importer.run(*log);
    if (!done && importer.began()) {
        std::error_code ignored;
        for (const char* suffix : {"", "-wal", "-shm"})
            std::filesystem::remove(options.out + suffix, ignored);
    }
    return done;
}

}  // namespace terratact
