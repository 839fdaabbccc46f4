#include "core/wire/logs/log_format.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/base/text.h"
#include "core/store/content_kind.h"
#include "core/wire/logs/log_text.h"

namespace terratact {
namespace {

bool isNumber(std::string_view word)
{
    return !word.empty() && word.front() >= '0' && word.front() <= '9'
        && word.find_first_not_of("0123456789.") == std::string_view::npos;
}

/// Returns the fields as CsvFormat needs them.
std::vector<std::string> plainFieldsOf(std::string_view line)
{
    std::vector<std::string> fields;
    for (const std::string_view field : logCsvFields(line, logCsvSeparator(line)))
        fields.push_back(logCsvName(field));
    return fields;
}

/// Returns true for a GVRET line without a heading: "1000000,00000500,false,0,3,DD,FF,01,". A
/// spreadsheet may have written its time as 1E+06.
bool isGvretLine(std::string_view line)
{
    const std::vector<std::string> fields = plainFieldsOf(line);
    return fields.size() >= 5 && isDigits(fields[0].substr(0, 1)) && numberFrom(fields[0])
        && (fields[2] == "false" || fields[2] == "true");
}

bool isCsvHeading(std::string_view line)
{
    const std::vector<std::string> fields = plainFieldsOf(line);
    if (fields.size() < 6) return false;
    return (fields[0] == "timestamp" && (fields[1] == "id" || fields[1] == "arbitration_id"))
        || (fields[0] == "__time" && fields[1] == "id" && fields[2] == "extended");
}

/// Returns true for a line of fields only; candump lines have a # or the length in brackets.
bool isTable(std::string_view line)
{
    return line.find_first_of("#[") == std::string_view::npos && logCsvSeparator(line) != '\t'
        && plainFieldsOf(line).size() >= 4;
}

bool isAscHeading(std::string_view first, std::string_view line)
{
    return first == "date" || first == "base" || line.starts_with("Begin Triggerblock")
        || line.starts_with("begin triggerblock") || line.starts_with("internal events logged")
        || line.starts_with("no internal events logged") || line.starts_with("// version ");
}

/// Returns true for "0.100000 1 500 ..." or "0.100000 CANFD ...": a Vector log without its heading.
bool isAscLine(std::string_view first, std::string_view second)
{
    return isNumber(first) && first.find('.') != std::string_view::npos
        && (isDigits(second) || second == "CANFD");
}

bool isTrcLine(std::string_view first)
{
    return first.size() > 1 && first.ends_with(')') && isDigits(first.substr(0, first.size() - 1));
}

/// Returns true for a line of slcan: "t12380011223344556677", with or without a time of 16 bits.
bool isSlcanLine(std::string_view line)
{
    constexpr std::size_t kTime = 4;
    const std::string_view digits = line.substr(std::min<std::size_t>(1, line.size()));
    const std::size_t id = line.starts_with('t') || line.starts_with('r') ? 3
                         : line.starts_with('T') || line.starts_with('R') ? 8
                                                                          : digits.size();
    if (digits.size() <= id || digits.find_first_not_of("0123456789ABCDEFabcdef") < digits.size())
        return false;
    const auto length = integerFrom<std::size_t>(digits.substr(id, 1));
    if (!length || *length > kClassicBytes) return false;
    const bool isRemote = line.starts_with('r') || line.starts_with('R');
    const std::size_t bytes = digits.size() - id - 1, expected = isRemote ? 0 : 2 * *length;
    return bytes == expected || bytes == expected + kTime;
}

Message convert(SourceText kind)
{
    return {TR_NOOP("core", "is %1; expected a log of candump, .asc, .trc, or CSV of GVRET or "
                            "python-can: export it as one of them"),
            kind};
}

/// Returns why a kind of file is no log, and what to do. Empty: this kind alone does not say.
Message refusalAsLog(ContentKind kind)
{
    switch (kind) {
    case ContentKind::Zip: return TR_NOOP("core", "is a ZIP archive: unpack it");
    case ContentKind::OldWorkbook:
        return convert(TR_NOOP("core", "a workbook of an office program"));
    case ContentKind::Pdf: return convert(TR_NOOP("core", "a PDF file"));
    case ContentKind::Sqlite:
    case ContentKind::Session:
        return TR_NOOP("core", "is a session or another SQLite file; expected a log of CAN frames: "
                               "session export makes one of a session");
    case ContentKind::Plain:
    case ContentKind::Utf16:
    case ContentKind::Utf32:
    case ContentKind::Gzip:
    case ContentKind::Journal: break;
    }
    return {};
}

/// Returns the kind of another text by its beginning; empty if none is known.
Message otherKindOf(std::string_view line, std::string_view first)
{
    if (line.starts_with("***BUSMASTER")) return convert(TR_NOOP("core", "a log of BusMaster"));
    if (first == "Microchip") return convert(TR_NOOP("core", "a log of Microchip"));
    if (line.starts_with("Time,") || line.starts_with("Time;"))
        return convert(TR_NOOP("core", "a table, no known log"));
    if (isCsvHeading(line)) return {};
    const bool isDate = line.size() > 10 && line[4] == '-' && line[7] == '-' && line[10] == 'T';
    if (isDate && isTable(line)) return convert(TR_NOOP("core", "a log of NMEA 2000 of canboat"));
    if (line.starts_with("BO_ ") || line.starts_with("VERSION \""))
        return TR_NOOP("core", "is a DBC file, which --dbc reads; expected a log of CAN traffic");
    LogWords words(line);
    (void)words.next();
    const std::string_view second = words.next();
    if (isSlcanLine(first) && second.empty())
        return TR_NOOP("core",
                       "is a log of slcan, which is not read: record the bus with candump -l");
    const bool isCrtd = isNumber(first) && second.size() >= 3
                     && (second.ends_with("R11") || second.ends_with("R29")
                         || second.ends_with("T11") || second.ends_with("CXX"));
    if (isCrtd) return convert(TR_NOOP("core", "a log of CRTD"));
    if (line.starts_with("{") || line.starts_with("<?xml"))
        return convert(TR_NOOP("core", "JSON or XML, no known log"));
    if (isTable(line)) return convert(TR_NOOP("core", "a table, no known log"));
    return {};
}

/// What to do with a file of a kind.
enum class Cure { Convert, AsText, Said };

struct Magic {
    std::string_view begin;
    SourceText kind;
    Cure cure = Cure::Convert;
};

}  // namespace

Message LogFormat::consumeRemark()
{
    return std::exchange(remark_, {});
}

std::optional<LoggedFrame> LogFormat::passOver()
{
    ++passed_;
    return std::nullopt;
}

Result<std::unique_ptr<LogFormat>> formatOfLine(std::string_view line)
{
    LogWords words(line);
    const std::string_view begin = words.rest(), first = words.next(), second = words.next();
    if (first.starts_with('(')) return candumpFormat();
    if (first.starts_with(';')) return trcFormat();
    if (isTrcLine(first)) return trcFormat();
    if (isAscHeading(first, begin) || isAscLine(first, second)) return ascFormat();
    // A spreadsheet may write "sep=;" above its heading.
    if (first.starts_with('#') || first.starts_with("//") || first.starts_with("sep="))
        return std::unique_ptr<LogFormat>();
    if (isCsvHeading(begin) || isGvretLine(begin)) return csvFormat(begin);
    if (Message other = otherKindOf(begin, first); !other.empty()) return Error{std::move(other)};
    if (!isUtf8(begin) || begin.find('\0') != std::string_view::npos)
        return Error{convert(TR_NOOP("core", "no text in UTF-8"))};
    return candumpFormat();
}

Message binaryKindOf(std::string_view begin)
{
    using namespace std::string_view_literals;
    constexpr std::array kKinds{
        Magic{"LOGG"sv, TR_NOOP("core", "a binary log of Vector (.blf)"), Cure::AsText},
        Magic{"MDF     "sv, TR_NOOP("core", "a measurement file (.mf4, .mdf)"), Cure::AsText},
        Magic{"\x89MCAP0"sv, TR_NOOP("core", "an MCAP file")},
        Magic{"\x0A\x0D\x0D\x0A"sv, TR_NOOP("core", "a capture of Wireshark (.pcapng)")},
        Magic{"\xD4\xC3\xB2\xA1"sv, TR_NOOP("core", "a capture of tcpdump (.pcap)")},
        Magic{"\xA1\xB2\xC3\xD4"sv, TR_NOOP("core", "a capture of tcpdump (.pcap)")},
        Magic{"\xFD"
              "7zXZ"sv,
              TR_NOOP("core", "is packed by xz: unpack it (xz -d)"), Cure::Said},
        Magic{"\x28\xB5\x2F\xFD"sv, TR_NOOP("core", "is packed by zstd: unpack it (zstd -d)"),
              Cure::Said},
        Magic{"#ROSBAG V"sv, TR_NOOP("core", "a bag of ROS")},
        Magic{"BZh"sv, TR_NOOP("core", "is packed by bzip2: unpack it (bzip2 -d)"), Cure::Said},
    };
    constexpr std::size_t kTarMagic = 257;
    if (begin.size() > kTarMagic && begin.substr(kTarMagic).starts_with("ustar"))
        return TR_NOOP("core", "is a tar archive: unpack it (tar -xf)");
    for (const auto& [magic, kind, cure] : kKinds) {
        if (!begin.starts_with(magic)) continue;
        if (cure == Cure::Said) return kind;
        if (cure == Cure::Convert) return convert(kind);
        return {TR_NOOP("core", "is %1; expected a log as text: can_logconvert of python-can makes "
                                "one"),
                kind};
    }
    return refusalAsLog(contentKind(begin));
}

}  // namespace terratact
