#include "core/store/content_kind.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <utility>

namespace terratact {
namespace {

using namespace std::string_view_literals;

constexpr std::array<std::pair<std::string_view, ContentKind>, 12> kBeginnings{{
    {"\xFF\xFE\0\0"sv, ContentKind::Utf32},  // before the mark of UTF-16, which begins the same way
    {"\0\0\xFE\xFF"sv, ContentKind::Utf32},
    {"\xFF\xFE"sv, ContentKind::Utf16},
    {"\xFE\xFF"sv, ContentKind::Utf16},
    {"PK\x03\x04"sv, ContentKind::Zip},
    {"PK\x05\x06"sv, ContentKind::Zip},
    {"\xD0\xCF\x11\xE0\xA1\xB1\x1A\xE1"sv, ContentKind::OldWorkbook},
    {"\x1F\x8B"sv, ContentKind::Gzip},
    {"%PDF-"sv, ContentKind::Pdf},
    {"SQLite format 3\0"sv, ContentKind::Sqlite},
    {"\x37\x7F\x06\x82"sv, ContentKind::Journal},
    {"\x37\x7F\x06\x83"sv, ContentKind::Journal},
}};

/// Returns the application id: big-endian at byte 68 (sqlite.org/fileformat2.html §1.3).
std::int64_t applicationId(std::string_view head)
{
    std::int64_t id = 0;
    for (std::size_t i = 68; i < kContentHead; ++i)
        id = id << 8 | static_cast<unsigned char>(head[i]);
    return id;
}

/// Returns true for UTF-16 without a byte order mark: plain letters, with NUL as every other byte.
bool looksLikeUtf16(std::string_view head)
{
    const std::string_view letters = head.substr(0, head.size() / 2 * 2);
    if (letters.size() < 4) return false;
    for (const std::size_t first : {std::size_t{0}, std::size_t{1}}) {
        bool alternates = true;
        for (std::size_t i = 0; i < letters.size(); ++i)
            alternates = alternates && (letters[i] == '\0') == (i % 2 == first);
        if (alternates) return true;
    }
    return false;
}

}  // namespace

ContentKind contentKind(std::string_view head)
{
    head = head.substr(0, kContentHead);
    for (const auto& [beginning, kind] : kBeginnings) {
        if (!head.starts_with(beginning)) continue;
        const bool isSession = kind == ContentKind::Sqlite && head.size() == kContentHead
                            && applicationId(head) == kSessionApplicationId;
        return isSession ? ContentKind::Session : kind;
    }
    return looksLikeUtf16(head) ? ContentKind::Utf16 : ContentKind::Plain;
}

ContentKind contentKindOfFile(const std::string& path)
{
    struct stat found {};
    if (::stat(path.c_str(), &found) != 0 || !S_ISREG(found.st_mode)) return ContentKind::Plain;
    const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (file < 0) return ContentKind::Plain;
    std::array<char, kContentHead> head{};
    const ssize_t got = ::read(file, head.data(), head.size());
    ::close(file);
    return contentKind({head.data(), static_cast<std::size_t>(std::max<ssize_t>(got, 0))});
}

}  // namespace terratact
