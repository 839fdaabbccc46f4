// CSV logs of CAN traffic: of GVRET and SavvyCAN, with or without their heading, of python-can, and
// of `session export --what frames`.
//
//   Time Stamp,ID,Extended,Dir,Bus,LEN,D1,D2,D3,D4,D5,D6,D7,D8        [us], hexadecimal
//   timestamp,arbitration_id,extended,remote,error,dlc,data           [s], 0x123, base 64
//   __time,id,extended,remote,error,fd,sent,local,length,data         [s], decimal, hexadecimal
#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/text.h"
#include "core/store/csv_field.h"
#include "core/wire/logs/log_format.h"
#include "core/wire/logs/log_text.h"

namespace terratact {
namespace {

constexpr std::size_t kMaxColumns = 80;  // 64 of them for bytes

std::optional<bool> truthOf(std::string_view field)
{
    const std::string word = logCsvName(field);
    if (word == "true" || word == "1") return true;
    if (word == "false" || word == "0" || word.empty()) return false;
    return std::nullopt;
}

/// Returns the bytes of base 64 (RFC 4648); empty if it is none.
std::optional<std::vector<std::uint8_t>> bytesOfBase64(std::string_view text)
{
    constexpr std::string_view kAlphabet =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    while (text.ends_with('=')) text.remove_suffix(1);
    std::vector<std::uint8_t> bytes;
    std::uint32_t bits = 0, count = 0;
    for (const char c : text) {
        const std::size_t value = kAlphabet.find(c);
        if (value == std::string_view::npos) return std::nullopt;
        bits = (bits << 6U | static_cast<std::uint32_t>(value)) & 0xFFFFU;
        if ((count += 6) < 8) continue;
        count -= 8;
        bytes.push_back(static_cast<std::uint8_t>(bits >> count));
    }
    return bytes;
}

/// Returns true for "1.67E+08", as a spreadsheet writes the number 166780000 or the identifier 1E5.
bool hasLostDigits(std::string_view field)
{
    const std::size_t mark = field.find("E+");
    return mark != std::string_view::npos && isDigits(field.substr(mark + 2));
}

Error lostDigits(std::string_view field)
{
    return Error{Message(TR_NOOP("core", "%1 has lost its digits in a spreadsheet: export the log "
                                         "again, and keep this column as text"),
                         shown(field))};
}

enum class Dialect : std::uint8_t { Gvret, PythonCan, Own };

class CsvFormat final : public LogFormat {
public:
    explicit CsvFormat(std::string_view heading) : separator_(logCsvSeparator(heading))
    {
        const std::vector<std::string_view> fields = logCsvFields(heading, separator_);
        isFirst_ = !fields.empty() && !isDigits(fields[0].substr(0, 1));
        if (isFirst_) {
            heading_ = heading;
            for (const std::string_view field : fields) columns_.push_back(logCsvName(field));
        } else {
            columns_ = {"timestamp", "id", "extended",
                        fields.size() > 3 && isDigits(fields[3]) ? "bus" : "dir"};
        }
        if (!isFirst_ && columns_.back() == "dir") columns_.emplace_back("bus");
        if (!isFirst_) columns_.emplace_back("len");
        if (has("__time")) dialect_ = Dialect::Own;
        if (has("arbitration_id")) dialect_ = Dialect::PythonCan;
    }

    std::string_view name() const override
    {
        switch (dialect_) {
        case Dialect::Gvret: return "GVRET CSV";
        case Dialect::PythonCan: return "CSV of python-can";
        case Dialect::Own: break;
        }
        return "CSV of session export";
    }

    Result<std::optional<LoggedFrame>> parse(std::string_view line) override
    {
        if (std::exchange(isFirst_, false) || LogWords(line).rest().empty())
            return std::optional<LoggedFrame>{};
        if (line == heading_) return Error{kSecondTable};
        const Fields fields = logCsvFields(line, separator_);
        LoggedFrame logged;
        for (const auto step :
             {&CsvFormat::readTime, &CsvFormat::readKind, &CsvFormat::readId, &CsvFormat::readBus})
            if (const Status done = (this->*step)(fields, logged); !done) return done.error();
        if (const Status done = readBytes(fields, logged); !done) return done.error();
        return std::optional(std::move(logged));
    }

private:
    using Fields = std::vector<std::string_view>;

    bool has(std::string_view column) const
    {
        return std::find(columns_.begin(), columns_.end(), column) != columns_.end();
    }

    /// Returns the field of a column; empty if there is no such column.
    std::string_view field(const Fields& fields, std::string_view column) const
    {
        const auto found = std::find(columns_.begin(), columns_.end(), column);
        const auto at = static_cast<std::size_t>(found - columns_.begin());
        return at < fields.size() && found != columns_.end() ? fields[at] : std::string_view();
    }

    Status readTime(const Fields& fields, LoggedFrame& logged) const
    {
        constexpr double kMicroseconds = 1e6;
        const std::string_view text =
            field(fields, dialect_ == Dialect::Own ? "__time" : "timestamp");
        if (hasLostDigits(text)) return lostDigits(text);
        const bool isWhole = text.find_first_of(".,") == std::string_view::npos;
        const Result<double> time =
            logSeconds(text, dialect_ == Dialect::Gvret && isWhole ? kMicroseconds : 1.0);
        if (!time) return time.error();
        logged.time = *time;
        return Done{};
    }

    Status readKind(const Fields& fields, LoggedFrame& logged) const
    {
        CanFrame& frame = logged.frame;
        using Flag = std::pair<std::string_view, bool*>;
        bool sent = false;
        for (const auto& [column, flag] :
             std::array{Flag{"extended", &frame.extended}, Flag{"remote", &frame.remote},
                        Flag{"error", &frame.error}, Flag{"fd", &frame.fd}, Flag{"sent", &sent}}) {
            const auto truth = truthOf(field(fields, column));
            if (!truth)
                return expectedInLog(TR_NOOP("core", "true or false"), field(fields, column));
            *flag = *truth;
        }
        if (frame.error && (frame.remote || frame.fd))
            return Error{TR_NOOP("core", "an error frame cannot be of another kind, too")};
        if (frame.remote && frame.fd)
            return Error{TR_NOOP("core", "a CAN FD frame cannot be a remote frame")};
        if (frame.error) frame.extended = false;
        const std::string_view direction = field(fields, "dir");
        if (direction == "Tx" || sent) logged.direction = LogDirection::Sent;
        if (direction == "Rx") logged.direction = LogDirection::Received;
        return Done{};
    }

    Status readId(const Fields& fields, LoggedFrame& logged) const
    {
        CanFrame& frame = logged.frame;
        std::string_view digits =
            field(fields, dialect_ == Dialect::PythonCan ? "arbitration_id" : "id");
        if (hasLostDigits(digits)) return lostDigits(digits);
        if (digits.starts_with("0x")) digits.remove_prefix(2);
        frame.extended = frame.extended || frame.error;  // an error class also has 29 bits
        Status done = setFrameId(frame, digits, dialect_ == Dialect::Own ? 10 : 16);
        frame.extended = frame.extended && !frame.error;
        return done;
    }

    Status readBus(const Fields& fields, LoggedFrame& logged) const
    {
        const std::string_view text = field(fields, "bus");
        const auto bus = isDigits(text) ? integerFrom<std::uint8_t>(text) : std::nullopt;
        if (!bus && !text.empty())
            return expectedInLog(TR_NOOP("core", "the number of a bus"), text);
        logged.interface = interfaceOfBus(bus ? *bus + 1U : 1U);
        return Done{};
    }

    Status readBytes(const Fields& fields, LoggedFrame& logged)
    {
        CanFrame& frame = logged.frame;
        constexpr std::array kLengths{"len", "dlc", "length"};
        const std::string_view text =
            field(fields, kLengths.at(static_cast<std::size_t>(dialect_)));
        const auto length = isDigits(text) ? integerFrom<unsigned>(text) : std::nullopt;
        frame.fd = frame.fd || (dialect_ != Dialect::Own && length.value_or(0) > kClassicBytes);
        if (Status done = setFrameLength(frame, length.value_or(kFdBytes + 1), text); !done)
            return done;
        if (frame.remote) return Done{};
        if (dialect_ == Dialect::Gvret) return readColumns(fields, frame);
        if (dialect_ == Dialect::Own) return readDigits(field(fields, "data"), frame);
        const auto bytes = bytesOfBase64(field(fields, "data"));
        if (!bytes || bytes->size() != frame.length)
            return expectedInLog(TR_NOOP("core", "as many bytes in base 64 as dlc says"),
                                 field(fields, "data"));
        std::copy(bytes->begin(), bytes->end(), frame.data.begin());
        return Done{};
    }

    Status readColumns(const Fields& fields, CanFrame& frame)
    {
        const auto len = std::find(columns_.begin(), columns_.end(), "len");
        const auto first = static_cast<std::size_t>(len - columns_.begin()) + 1;
        for (std::size_t i = 0; i < frame.length; ++i) {
            std::string_view digits =
                first + i < fields.size() ? fields[first + i] : std::string_view();
            if (digits.starts_with("0x")) digits.remove_prefix(2);
            // A spreadsheet drops leading zeros.
            if (Status done = setFrameByte(frame, i, digits, 16, 1); !done) return done;
        }
        countLonger(fields, first + frame.length);
        return Done{};
    }

    /// Some programs fill all columns of bytes with zeros.
    void countLonger(const Fields& fields, std::size_t behind)
    {
        for (std::size_t i = behind; i < fields.size(); ++i) {
            const bool isByte = i >= columns_.size() || columns_[i].starts_with('d');
            if (!isByte || fields[i].find_first_not_of("0x") == std::string_view::npos) continue;
            ++longer_;
            return;
        }
    }

    static Status readDigits(std::string_view digits, CanFrame& frame)
    {
        if (digits.size() < std::size_t{2} * frame.length)
            frame.isCut = frame.length > kClassicBytes;
        const std::size_t known = bytesOf(frame).size();
        if (digits.size() != 2 * known)
            return expectedInLog(TR_NOOP("core", "as many bytes as the length says"), digits);
        for (std::size_t i = 0; i < known; ++i)
            if (Status done = setFrameByte(frame, i, digits.substr(2 * i, 2)); !done) return done;
        return Done{};
    }

    char separator_;
    std::string heading_{};  ///< empty: the log has none
    std::vector<std::string> columns_;
    Dialect dialect_ = Dialect::Gvret;
    bool isFirst_ = true;  ///< the heading is next
};

}  // namespace

char logCsvSeparator(std::string_view line)
{
    const auto count = [line](char c) { return std::count(line.begin(), line.end(), c); };
    const auto commas = count(','), semicolons = count(';'), tabs = count('\t');
    if (commas >= semicolons && commas >= tabs) return ',';
    return semicolons >= tabs ? ';' : '\t';
}

std::vector<std::string_view> logCsvFields(std::string_view line, char separator)
{
    std::vector<std::string_view> fields;
    while (fields.size() < kMaxColumns) {
        const std::size_t end = line.find(separator);
        std::string_view field = withoutBlanks(line.substr(0, end), kLogBlanks);
        const bool isQuoted = field.size() > 1 && field.starts_with('"') && field.ends_with('"');
        if (isQuoted) field = withoutBlanks(field.substr(1, field.size() - 2), kLogBlanks);
        fields.push_back(field);
        if (end == std::string_view::npos) break;
        line.remove_prefix(end + 1);
    }
    return fields;
}

std::string logCsvName(std::string_view field)
{
    std::string name;
    for (const char c : field)
        if (c != ' ') name += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return name;
}

std::unique_ptr<LogFormat> csvFormat(std::string_view heading)
{
    return std::make_unique<CsvFormat>(heading);
}

}  // namespace terratact
