#include "core/store/sqlite_journal.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstring>
#include <filesystem>
#include <string_view>
#include <system_error>

#include "core/store/content_kind.h"

namespace terratact {
namespace {

constexpr std::size_t kJournalHead = 32, kFrameHead = 24;  // [bytes]

std::uint32_t wordAt(std::string_view bytes, std::size_t at, bool isBig = true)
{
    std::uint32_t word = 0;
    std::memcpy(&word, bytes.data() + at, sizeof word);
    const bool swaps = isBig == (std::endian::native == std::endian::little);
    return swaps ? __builtin_bswap32(word) : word;
}

/// Adds bytes to a checksum (ibid. §4.2).
void addToSum(std::array<std::uint32_t, 2>& sum, std::string_view bytes, bool isBig)
{
    for (std::size_t at = 0; at + 8 <= bytes.size(); at += 8) {
        sum[0] += wordAt(bytes, at, isBig) + sum[1];
        sum[1] += wordAt(bytes, at + 4, isBig) + sum[0];
    }
}

/// Returns true if this checksum is stored there.
bool hasSum(std::string_view bytes, std::size_t at, const std::array<std::uint32_t, 2>& sum)
{
    return wordAt(bytes, at) == sum[0] && wordAt(bytes, at + 4) == sum[1];
}

/// Returns the place behind the last byte of a file that is not 0.
std::uint64_t contentEnd(std::ifstream& file)
{
    std::array<char, 8192> block{};
    file.seekg(0, std::ios::end);
    auto end = static_cast<std::uint64_t>(std::max<std::streamoff>(file.tellg(), 0));
    while (end > 0) {
        const std::uint64_t begin = (end - 1) / block.size() * block.size();
        file.seekg(static_cast<std::streamoff>(begin));
        file.read(block.data(), static_cast<std::streamsize>(end - begin));
        const std::string_view bytes(block.data(), static_cast<std::size_t>(file.gcount()));
        const std::size_t last = bytes.find_last_not_of('\0');
        if (last != std::string_view::npos) return begin + last + 1;
        end = begin;
    }
    return 0;
}

}  // namespace

JournalFrames::JournalFrames(const std::string& path)
    : header_(kJournalHead, '\0'), next_(kJournalHead)
{
    std::error_code none;
    if (!std::filesystem::is_regular_file(path, none)) return;  // a pipe would block
    in_.open(path, std::ios::binary);
    in_.read(header_.data(), kJournalHead);
    hasBytes_ = in_.gcount() > 0;
    const std::uint32_t size = wordAt(header_, 8);
    if (!in_ || size < 512 || size > 65'536 || !std::has_single_bit(size)) return;
    pageSize_ = size;
    frame_.resize(kFrameHead + size);
    isBig_ = (wordAt(header_, 0) & 1U) != 0;
    addToSum(sum_, std::string_view(header_).substr(0, 24), isBig_);
    hasHeader_ = contentKind(header_) == ContentKind::Journal && hasSum(header_, 24, sum_);
    isIntact_ = hasHeader_;
    contentEnd_ = contentEnd(in_);
    in_.seekg(kJournalHead);
}

bool JournalFrames::next()
{
    if (pageSize_ == 0) return false;
    in_.read(frame_.data(), static_cast<std::streamsize>(frame_.size()));
    if (!in_) return false;
    at_ = next_;
    next_ += frame_.size();
    isIntact_ = isIntact_ && continuesChain();
    return true;
}

bool JournalFrames::continuesChain()
{
    const std::string_view frame = frame_;
    addToSum(sum_, frame.substr(0, 8), isBig_);
    addToSum(sum_, frame.substr(kFrameHead), isBig_);
    return isCurrent() && page() != 0 && hasSum(frame, 16, sum_);
}

std::uint64_t JournalFrames::pageAt() const
{
    return at_ + kFrameHead;
}
std::uint32_t JournalFrames::page() const
{
    return wordAt(frame_, 0);
}
bool JournalFrames::commits() const
{
    return wordAt(frame_, 4) != 0;
}

bool JournalFrames::isCurrent() const
{
    return frame_.compare(8, 8, header_, 16, 8) == 0;
}

bool JournalFrames::isOlder() const
{
    const std::uint32_t restarts = wordAt(header_, 12);
    const std::uint32_t age = wordAt(header_, 16) - wordAt(frame_, 8);
    return age > 0 && age <= restarts;
}

bool JournalFrames::isUnfinished() const
{
    return page() != 0 && frame_.find_first_not_of('\0', 8) >= kFrameHead;
}

namespace {

/// Returns the damage as the file is at this moment.
std::optional<JournalDamage> damageNow(const std::string& journal)
{
    JournalFrames frame(journal);
    if (frame.hasDamagedHeader()) return JournalDamage{};
    std::uint64_t at = 0, open = 0, broken = 0;  // open: since the last commit
    bool isRead = false;                         // a transaction is read
    bool isStrange = false, hasCommit = false, isCommitted = false;
    while (frame.next()) {
        if (frame.isIntact()) {
            open = frame.commits() ? 0 : open + 1;
            isRead = isRead || frame.commits();
            continue;
        }
        if (frame.isOlder()) break;
        if (broken++ == 0) at = frame.at();
        const bool isEnd = isRead && frame.isUnwritten();
        isCommitted = isCommitted || ((frame.isCurrent() || isEnd) && hasCommit);
        hasCommit = hasCommit || (frame.isCurrent() && frame.commits());
        isStrange = isStrange || (!frame.isCurrent() && !frame.isUnfinished() && !isEnd);
    }
    if (!isStrange && !isCommitted) return std::nullopt;
    return JournalDamage{at, open + broken};
}

}  // namespace

std::optional<JournalDamage> journalDamage(const std::string& journal)
{
    const auto damage = damageNow(journal);
    // A writer that restarts the journal changes the header before this has read all frames.
    return damage && damageNow(journal) == damage ? damage : std::nullopt;
}

}  // namespace terratact
