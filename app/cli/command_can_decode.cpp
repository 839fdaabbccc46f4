#include <fmt/format.h>
#include <fmt/os.h>

#include <map>
#include <memory>
#include <utility>

#include "app/cli/commands.h"
#include "app/link/bus_statistics.h"
#include "app/link/dbc_book.h"
#include "app/runtime/print_text.h"
#include "app/runtime/text_output.h"
#include "core/base/message.h"
#include "core/base/text.h"
#include "core/store/csv_text.h"
#include "core/store/file_read.h"
#include "core/wire/logs/log_reader.h"

namespace terratact {
namespace {

constexpr std::size_t kMaxBuses = 64;

/// State of one interface in the log.
struct Bus {
    std::unique_ptr<FrameReader> reader;
    BusStatistics statistics;
    std::optional<double> first, last;  ///< [s]
};

/// Writes one row per value, or one per frame without values.
class CsvOutput {
public:
    static Result<CsvOutput> begin(const std::string& path)
    {
        Result<TextOutput> out = TextOutput::begin(path);
        if (!out) return out.error();
        CsvOutput csv(*std::move(out));
        csv.out_.stream() << "time_s,interface,id,frame,counter,verdict,signal,value,unit\n";
        return csv;
    }

    void write(const LoggedFrame& logged, const FrameWords& words)
    {
        const auto line = [&](const CsvValue& signal, const CsvValue& value, const CsvValue& unit) {
            out_.stream() << csvLine({logged.time ? fixed(*logged.time, 6) : "", logged.interface,
                                      idText(logged.frame), words.name,
                                      words.counter ? CsvValue(*words.counter) : CsvValue(),
                                      words.verdict, signal, value, unit});
        };
        for (const NamedValue& value : words.values) line(value.name, value.forFiles(), value.unit);
        if (!words.values.empty()) return;
        if (words.counter)
            line("", "", "");
        else
            line("data", bytesText(logged.frame), "");
    }

    Status commit() { return out_.commit(); }

private:
    explicit CsvOutput(TextOutput out) : out_(std::move(out)) {}

    TextOutput out_;
};

class Decoder {
public:
    Decoder(const CanDecodeOptions& options, std::shared_ptr<const DbcBook> book, LogReader log,
            std::optional<CsvOutput> csv)
        : options_(options), book_(std::move(book)), log_(std::move(log)), csv_(std::move(csv))
    {
    }

    /// Decodes the log; after an error the summary still covers the frames before it.
    Status run()
    {
        Status read = readAll();
        summarize();
        if (!read) return read;
        return csv_ ? csv_->commit() : Status(Done{});
    }

private:
    Status readAll()
    {
        for (;;) {
            const auto logged = log_.next();
            showRemarks();
            if (!logged) return logged.error();
            if (!*logged) return ending();
            if (Status done = add(**logged); !done) return done;
        }
    }

    void showRemarks()
    {
        for (const Message& remark : log_.consumeRemarks())
            printText(stderr, "terratact: {}\n", remark.english());
    }

    Status ending() const
    {
        if (!buses_.empty()) return Done{};
        const std::string whose = options_.interface.empty() ? "" : " of " + options_.interface;
        return fileError(options_.log, "holds no frame" + whose);
    }

    Status add(const LoggedFrame& logged)
    {
        if (!options_.interface.empty() && logged.interface != options_.interface) return Done{};
        if (buses_.size() >= kMaxBuses && !buses_.contains(logged.interface))
            return log_.error(Message::verbatim(
                fmt::format("is of the {}th interface: so many are not believed", kMaxBuses + 1)));
        Bus& bus = buses_[logged.interface];
        if (!bus.reader) bus.reader = frameReader(options_.protocol, book_, depth());
        if (logged.time && !begin_) begin_ = logged.time;
        // Uses the log's even clock, because the recording machine's clock may have been set.
        const double now = log_.elapsed();
        if (logged.time && !bus.first) bus.first = now;
        if (logged.time) bus.last = now;
        const FrameWords words = bus.reader->read(logged.frame, now);
        bus.statistics.add(logged.frame, words, now);
        if (csv_) csv_->write(logged, words);
        if (!options_.summaryOnly) print(logged, words);
        return Done{};
    }

    FrameDepth depth() const
    {
        return options_.summaryOnly && !csv_ ? FrameDepth::Name : FrameDepth::Values;
    }

    void print(const LoggedFrame& logged, const FrameWords& words) const
    {
        const std::string time = logged.time ? fmt::format("{:.6f}", log_.elapsed()) : "-";
        const std::string counter = words.counter ? fmt::format("#{:03d}", *words.counter) : "-";
        const std::string content = contentText(logged.frame, words);
        printText(messages_, "{:>12} {:<6} {:<9} {:<26} {:<4}  {}{}{}\n", time, logged.interface,
                  idText(logged.frame), words.name.empty() ? "unknown" : words.name, counter,
                  words.verdict, content.empty() ? "" : "; ", content);
    }

    void summarize() const
    {
        if (begin_ && !options_.summaryOnly)
            printText(messages_, "\ntimes are since {:.6f} s of the log's clock\n", *begin_);
        for (const auto& [name, bus] : buses_) {
            printText(messages_, "\n{} in {}\n", name,
                      options_.log == "-" ? "standard input" : options_.log);
            printText(
                messages_, "{}",
                Lines(summaryText(bus.statistics, bus.first ? std::optional(*bus.last - *bus.first)
                                                            : std::nullopt)));
        }
        if (log_.stepsBack() > 0)
            printText(messages_, "the log's clock is set {} times: the times above go on evenly\n",
                      log_.stepsBack());
        if (log_.dropped() > 0)
            printText(messages_, "{} frames were lost when the log was recorded\n", log_.dropped());
    }

    const CanDecodeOptions& options_;
    std::FILE* messages_ = messagesBeside(options_.csv);
    std::shared_ptr<const DbcBook> book_;
    LogReader log_;
    std::optional<CsvOutput> csv_;
    std::map<std::string, Bus> buses_;
    std::optional<double> begin_;  ///< [s] of the first frame with a time stamp
};

}  // namespace

Status decodeCanLog(const CanDecodeOptions& options)
{
    const auto book = readDbcBook(options.protocol, options.dbc);
    if (!book) return book.error();
    for (const Message& remark : remarksOf(*book))
        printText(stderr, "terratact: {}\n", remark.english());
    Result<LogReader> log = LogReader::open(options.log);
    if (!log) return log.error();
    std::optional<CsvOutput> csv;
    if (!options.csv.empty()) {
        Result<CsvOutput> begun = CsvOutput::begin(options.csv);
        if (!begun) return begun.error();
        csv = *std::move(begun);
    }
    return Decoder(options, *book, *std::move(log), std::move(csv)).run();
}

}  // namespace terratact
