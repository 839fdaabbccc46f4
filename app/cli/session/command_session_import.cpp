#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <optional>
#include <utility>
#include <vector>

#include "app/cli/session/session_commands.h"
#include "app/recording/unfinished_session.h"
#include "app/runtime/print_text.h"
#include "core/log/event_text.h"
#include "core/log/session_writer.h"
#include "core/store/file_read.h"
#include "core/store/sha256.h"
#include "core/wire/logs/log_reader.h"

namespace terratact {

namespace {

constexpr int kBatch = 250;  // frames per batch
constexpr std::size_t kMaxRobot = std::size_t{64} * 1024;

/// Writes the frames of one interface of a log into a session, which begins with the first frame.
class Importer {
public:
    Importer(const SessionImportOptions& options, std::string robot)
        : options_(options), robot_(std::move(robot))
    {
    }

    Status run(LogReader& log)
    {
        for (;;) {
            const auto logged = log.next();
            for (const Message& remark : log.consumeRemarks())
                printText(stderr, "terratact: {}\n", remark.english());
            if (!logged) return logged.error();
            if (!*logged) break;
            const bool isWanted =
                options_.interface.empty() || (*logged)->interface == options_.interface;
            // A step of the clock counts on every interface.
            if (log.stepBack()) stepped(log);
            if (!isWanted) continue;
            if (Status taken = add(log, **logged); !taken) return taken;
        }
        if (!writer_) return fileError(options_.log, "holds no frame" + ofInterface());
        if (Status status = logEnd(log); !status) return status;
        if (Status sealed = writer_->seal(); !sealed) return sealed;
        printText("{} frames of {} written to {}; last link {}\n", writer_->frames(), interface_,
                  options_.out, writer_->chain());
        return Done{};
    }

    bool began() const { return writer_.has_value(); }

private:
    std::string sourceName() const
    {
        return options_.log == "-" ? "standard input"
                                   : std::filesystem::path(options_.log).filename().string();
    }

    std::string ofInterface() const
    {
        return options_.interface.empty() ? "" : " of " + options_.interface;
    }

    Status add(const LogReader& log, const LoggedFrame& logged)
    {
        if (!logged.time)
            return log.error(Message::verbatim("has no time: record with candump -L"));
        if (!writer_)
            if (Status begun = begin(log, logged); !begun) return begun;
        if (logged.interface != interface_)
            return log.error(Message::verbatim(
                fmt::format("is of {}, the log began with {}: choose one with --interface",
                            logged.interface, interface_)));
        last_ = sessionTimeOf(log.elapsed() - begin_);
        if (Status done = logSteps(); !done) return done;
        const FrameRow row{
            .time = last_, .frame = logged.frame, .sent = logged.direction == LogDirection::Sent};
        if (Status added = writer_->add(row); !added) return added;
        return ++count_ % kBatch == 0 ? writer_->commit() : Status(Done{});
    }

    /// Stores a step of the log's clock until the session's next frame.
    void stepped(const LogReader& log)
    {
        constexpr std::size_t kMax = 200;  // bound on steps that are listed one by one
        if (!writer_) return;
        if (loggedSteps_ + steps_.size() >= kMax) {
            ++unlogged_;
            return;
        }
        const double step = *log.stepBack();
        steps_.emplace_back(
            step < 0.0 ? TR_NOOP(
                "core",
                "at line %1 the log's clock was set forward by %2 s; the session continues evenly")
                       : TR_NOOP("core", "at line %1 the log's clock was set back by %2 s; the "
                                         "session continues evenly"),
            log.line(), fixed(std::abs(step), 6));
    }

    EventRow event(EventKind kind, std::string subject, Message text = {})
    {
        return withText(
            {.id = ++events_, .time = last_, .kind = kind, .subject = std::move(subject)},
            std::move(text));
    }

    Status logSteps()
    {
        for (Message& step : std::exchange(steps_, {})) {
            ++loggedSteps_;
            if (Status status = writer_->add(event(EventKind::Gap, "clock", std::move(step)));
                !status)
                return status;
        }
        return Done{};
    }

    Status logEnd(const LogReader& log)
    {
        if (Status status = logSteps(); !status) return status;
        std::vector<EventRow> rows;
        if (unlogged_ > 0)
            rows.push_back(
                event(EventKind::Gap, "clock",
                      {TR_NOOP("core", "the log's clock was set back %1 more times"), unlogged_}));
        if (Message doubt = log.clockDoubt(); !doubt.empty())
            rows.push_back(event(EventKind::Gap, "clock", std::move(doubt)));
        if (log.dropped() > 0) {
            rows.push_back(event(EventKind::Gap, "log",
                                 TR_NOOP("core", "frames that were lost when the log was "
                                                 "recorded")));
            rows.back().number = static_cast<double>(log.dropped());
        }
        if (log.isTorn())
            rows.push_back(
                event(EventKind::Gap, "log", TR_NOOP("core", "the end of the log is torn")));
        rows.push_back(event(EventKind::Session, "ended"));
        for (const EventRow& row : rows)
            if (Status status = writer_->add(row); !status) return status;
        return Done{};
    }

    Status begin(const LogReader& log, const LoggedFrame& first)
    {
        constexpr double kMaxStart = 9e9;  // [s] a session counts nanoseconds since 1970
        if (*first.time > kMaxStart)
            return log.error(Message::verbatim(fmt::format(
                "begins at {:.0f} s since 1970, expected at most {:.0f} s: was the clock set?",
                *first.time, kMaxStart)));
        begin_ = log.elapsed();
        interface_ = first.interface;
        // A double holds a time since 1970 to a quarter of a microsecond.
        const SessionTime microseconds = std::llround(*first.time * 1e6);
        const SessionStart start{.wallTime = microseconds * 1000,
                                 .program = "terratact session import",
                                 .source = sourceName(),
                                 .bus = interface_,
                                 .transmits = false,
                                 .robot = robot_,
                                 .robotHash = sha256Hex(robot_)};
        inProgress_.emplace(options_.out);
        auto writer = SessionWriter::create(options_.out, start);
        if (!writer) return writer.error();
        writer_ = std::move(*writer);
        return writer_->add(
            event(EventKind::Session, "begun", TR_NOOP("core", "from a log of CAN frames")));
    }

    const SessionImportOptions& options_;
    std::string robot_, interface_;
    std::optional<SessionWriter> writer_;
    std::optional<SessionInProgress> inProgress_;
    double begin_ = 0.0;  ///< [s] of the first frame on the log's even clock
    SessionTime last_ = 0;
    std::uint64_t count_ = 0, unlogged_ = 0;
    std::int64_t events_ = 0;
    std::size_t loggedSteps_ = 0;
    std::vector<Message> steps_;  ///< clock steps since the last frame
};

}  // namespace

Status importLog(const SessionImportOptions& options)
{
    auto robot = readFile(options.robot, kMaxRobot);
    if (!robot) return robot.error();
    auto log = LogReader::open(options.log);
    if (!log) return log.error();
    Importer importer(options, std::move(*robot));
    Status done = importer.run(*log);
    if (!done && importer.began()) removeUnfinishedSession(options.out);
    return done;
}

}  // namespace terratact
