#include "core/log/rows/page_rows.h"

#include <algorithm>
#include <bit>
#include <filesystem>
#include <system_error>

#include "core/store/sqlite_journal.h"

namespace terratact {
namespace {

constexpr std::size_t kFileHeader = 100;  // bytes
constexpr std::size_t kMaxColumns = 100;

std::uint64_t bigEndianAt(std::string_view bytes, std::size_t at, std::size_t count)
{
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < count; ++i)
        value = value << 8U | static_cast<unsigned char>(bytes[at + i]);
    return value;
}

/// Reads a number of one to nine bytes at `at`, and moves `at` behind it. Returns empty if the
/// bytes end too early.
std::optional<std::uint64_t> variableInteger(std::string_view bytes, std::size_t& at)
{
    std::uint64_t value = 0;
    for (int i = 0; i < 9; ++i) {
        if (at >= bytes.size()) return std::nullopt;
        const auto byte = static_cast<unsigned char>(bytes[at++]);
        if (i == 8) return value << 8U | byte;
        value = value << 7U | (byte & 0x7FU);
        if (byte < 0x80) return value;
    }
    return std::nullopt;
}

/// Returns the size of a value of this serial type [bytes]; empty if there is no such type.
std::optional<std::size_t> sizeOfSerial(std::uint64_t type)
{
    constexpr std::size_t kSizes[]{0, 1, 2, 3, 4, 6, 8, 8, 0, 0};
    if (type < std::size(kSizes)) return kSizes[type];
    if (type < 12) return std::nullopt;
    return static_cast<std::size_t>((type - 12) / 2);
}

StoredValue valueOf(std::uint64_t type, std::string_view bytes)
{
    using Type = StoredValue::Type;
    if (type == 0) return {};
    if (type >= 12) return {.type = type % 2 == 0 ? Type::Blob : Type::Text, .bytes = bytes};
    if (type >= 8) return {.type = Type::Integer, .integer = static_cast<std::int64_t>(type - 8)};
    const std::uint64_t value = bigEndianAt(bytes, 0, bytes.size());
    if (type == 7) return {.type = Type::Real, .real = std::bit_cast<double>(value)};
    const std::size_t spare = 64 - 8 * bytes.size();
    return {.type = Type::Integer, .integer = static_cast<std::int64_t>(value << spare) >> spare};
}

std::uint64_t bytesOf(const std::string& path)
{
    std::error_code none;
    const std::uintmax_t size = std::filesystem::file_size(path, none);
    return none ? 0 : size;
}

/// Opens regular files only: a pipe would block.
std::ifstream opened(const std::string& path)
{
    std::error_code none;
    return std::filesystem::is_regular_file(path, none) ? std::ifstream(path, std::ios::binary)
                                                        : std::ifstream();
}

std::string_view readAt(std::ifstream& file, std::uint64_t at, std::size_t size,
                        std::string& buffer)
{
    buffer.resize(size);
    file.clear();
    file.seekg(static_cast<std::streamoff>(at));
    file.read(buffer.data(), static_cast<std::streamsize>(size));
    return std::string_view(buffer).substr(0, static_cast<std::size_t>(file.gcount()));
}

}  // namespace

PageRows::PageRows(const std::string& path, std::uint32_t pageSize, const std::string& journal)
    : file_(opened(path)), journal_(opened(journal)), fileBytes_(bytesOf(path)),
      journalBytes_(bytesOf(journal))
{
    readHeader(pageSize);
    readJournal(journal);
    bytesLeft_ = 2 * bytes();
}

void PageRows::readHeader(std::uint32_t otherwise)
{
    const std::string_view header = readAt(file_, 0, kFileHeader, buffer_);
    std::uint64_t size = 0, reserved = 0;
    if (header.size() == kFileHeader) {
        size = bigEndianAt(header, 16, 2);
        if (size == 1) size = 65'536;
        reserved = bigEndianAt(header, 20, 1);
        isCut_ = journalBytes_ == 0 && bigEndianAt(header, 28, 4) * size > fileBytes_;
    }
    const bool possible = size >= 512 && std::has_single_bit(size) && size - reserved >= 480;
    pageSize_ = possible ? static_cast<std::uint32_t>(size) : otherwise;
    usable_ = possible ? static_cast<std::uint32_t>(size - reserved) : otherwise;
}

/// Finds the newest state of every page since the journal was reset, also behind a damaged frame.
void PageRows::readJournal(const std::string& path)
{
    JournalFrames frame(path);
    if (frame.pageSize() != pageSize_) return;
    while (frame.next())
        if (frame.isCurrent()) inJournal_[frame.page()] = frame.pageAt();
}

/// Returns the page in its newest state; shorter than a page if it is missing.
std::string_view PageRows::page(std::uint32_t number)
{
    if (number == 0) return {};
    if (const auto found = inJournal_.find(number); found != inJournal_.end())
        return readAt(journal_, found->second, pageSize_, overflow_);
    return readAt(file_, std::uint64_t{number - 1} * pageSize_, pageSize_, overflow_);
}

void PageRows::forEach(const std::function<void(const StoredRow&)>& visit)
{
    std::string bytes;
    for (std::uint64_t number = 1; number * pageSize_ <= fileBytes_; ++number) {
        readAt(file_, (number - 1) * pageSize_, pageSize_, bytes);
        visitPage(static_cast<std::uint32_t>(number), bytes, visit);
    }
    for (const auto& [number, at] : inJournal_) {
        readAt(journal_, at, pageSize_, bytes);
        visitPage(number, bytes, visit);
    }
}

void PageRows::visitPage(std::uint32_t number, std::string_view bytes,
                         const std::function<void(const StoredRow&)>& visit)
{
    const std::size_t begin = number == 1 ? kFileHeader : 0;
    const auto kind = static_cast<Kind>(bytes[begin]);
    if (kind != Kind::TableLeaf && kind != Kind::IndexLeaf) return;
    const std::size_t cells = bigEndianAt(bytes, begin + 3, 2);
    std::size_t room = usable_;  // overlapping cells must not hold more than the page
    for (std::size_t i = 0; i < cells && begin + 8 + 2 * i + 2 <= usable_; ++i) {
        const std::size_t at = bigEndianAt(bytes, begin + 8 + 2 * i, 2);
        std::optional<std::int64_t> id;
        if (payloadOf(bytes, at, kind == Kind::TableLeaf, id, room) && decode())
            visit({.id = id, .values = values_, .page = number});
    }
}

/// Assembles the payload of a cell (ibid. §1.6). Returns false if it is missing.
bool PageRows::payloadOf(std::string_view bytes, std::size_t at, bool isTable,
                         std::optional<std::int64_t>& id, std::size_t& room)
{
    const std::string_view usable = bytes.substr(0, usable_);
    const auto size = variableInteger(usable, at);
    if (!size || *size > bytesLeft_) return false;
    if (isTable) {
        const auto row = variableInteger(usable, at);
        if (!row) return false;
        id = static_cast<std::int64_t>(*row);
    }
    const std::size_t most = isTable ? usable_ - 35 : (usable_ - 12) * 64 / 255 - 23;
    const std::size_t least = (usable_ - 12) * 32 / 255 - 23;
    std::size_t local = *size;
    if (local > most) {
        local = least + (*size - least) % (usable_ - 4);
        if (local > most) local = least;
    }
    const bool overflows = local < *size;
    if (local > room || at + local + (overflows ? 4 : 0) > usable.size()) return false;
    room -= local;
    bytesLeft_ -= *size;
    payload_.assign(usable.substr(at, local));
    if (!overflows) return true;
    return addOverflow(static_cast<std::uint32_t>(bigEndianAt(usable, at + local, 4)), *size);
}

bool PageRows::addOverflow(std::uint32_t next, std::size_t size)
{
    while (payload_.size() < size) {
        const std::string_view more = page(next);
        if (more.size() < pageSize_) return false;
        next = static_cast<std::uint32_t>(bigEndianAt(more, 0, 4));
        payload_.append(more.substr(4, std::min<std::size_t>(usable_ - 4, size - payload_.size())));
    }
    return true;
}

/// Decodes the values of payload_. Returns false if it is no row.
bool PageRows::decode()
{
    values_.clear();
    std::size_t at = 0;
    const auto headerSize = variableInteger(payload_, at);
    if (!headerSize || *headerSize > payload_.size()) return false;
    const std::string_view header = std::string_view(payload_).substr(0, *headerSize);
    std::string_view body = std::string_view(payload_).substr(*headerSize);
    while (at < header.size()) {
        const auto type = variableInteger(header, at);
        const auto size = type ? sizeOfSerial(*type) : std::nullopt;
        if (!size || *size > body.size() || values_.size() == kMaxColumns) return false;
        values_.push_back(valueOf(*type, body.substr(0, *size)));
        body.remove_prefix(*size);
    }
    return body.empty();
}

std::set<std::uint32_t> PageRows::leavesOf(std::uint32_t root)
{
    std::set<std::uint32_t> seen{root}, leaves;
    std::vector<std::uint32_t> open{root};
    while (!open.empty()) {
        const std::uint32_t number = open.back();
        open.pop_back();
        const std::string bytes(page(number));
        const std::size_t begin = number == 1 ? kFileHeader : 0;
        if (bytes.size() < pageSize_) continue;
        if (static_cast<Kind>(bytes[begin]) == Kind::TableLeaf) leaves.insert(number);
        if (static_cast<Kind>(bytes[begin]) != Kind::TableInner) continue;
        const auto visit = [&](std::uint64_t child) {
            const auto page = static_cast<std::uint32_t>(child);
            const bool isThere = child * pageSize_ <= fileBytes_ || inJournal_.contains(page);
            if (isThere && seen.insert(page).second) open.push_back(page);
        };
        const std::size_t cells = bigEndianAt(bytes, begin + 3, 2);
        for (std::size_t i = 0; i < cells && begin + 12 + 2 * i + 2 <= usable_; ++i)
            if (const std::size_t at = bigEndianAt(bytes, begin + 12 + 2 * i, 2); at + 4 <= usable_)
                visit(bigEndianAt(bytes, at, 4));
        visit(bigEndianAt(bytes, begin + 8, 4));
    }
    return leaves;
}

}  // namespace terratact
