#include "core/wire/logs/log_bytes.h"

#include <fcntl.h>
#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <system_error>
#include <utility>

#include "core/base/system_message.h"
#include "core/store/content_kind.h"
#include "core/store/file_read.h"

namespace terratact {
namespace {

constexpr std::size_t kBlock = std::size_t{16} * 1024;
/// gzip shrinks a log with times to a twentieth. It shrinks equal bytes to a thousandth, so that a
/// small file could take minutes to read.
constexpr std::uint64_t kMaxGrowth = 200;
constexpr std::uint64_t kSmall = std::uint64_t{64} << 20;  // [bytes] unpacked, whatever the growth

/// Descriptor that its destructor closes, unless it is standard input.
class LogFile {
public:
    explicit LogFile(const std::string& path)
        : isInput_(path == "-"),
          fd_(isInput_ ? STDIN_FILENO : ::open(path.c_str(), O_RDONLY | O_CLOEXEC))
    {
    }
    ~LogFile()
    {
        if (!isInput_ && fd_ >= 0) ::close(fd_);
    }
    LogFile(const LogFile&) = delete;
    LogFile& operator=(const LogFile&) = delete;
    int fd() const { return fd_; }

private:
    bool isInput_;
    int fd_;
};

}  // namespace

/// State of the gzip decoder.
struct LogBytes::Packed {
    Packed() { isReady = ::inflateInit2(&stream, 15 + 16) == Z_OK; }  // gzip only
    ~Packed()
    {
        if (isReady) ::inflateEnd(&stream);
    }
    Packed(const Packed&) = delete;
    Packed& operator=(const Packed&) = delete;

    z_stream stream{};
    std::array<char, 2 * kBlock> input{};  // begins with the bytes that begin() has read
    std::uint64_t packedBytes = 0, unpackedBytes = 0;
    bool isReady = false, isWhole = false, isTorn = false, isFollowed = false;

    bool growsTooMuch() const
    {
        return unpackedBytes > kSmall && unpackedBytes / kMaxGrowth > packedBytes;
    }
};

LogBytes::LogBytes(Source source) : source_(std::move(source)) {}
LogBytes::~LogBytes() = default;
LogBytes::LogBytes(LogBytes&&) noexcept = default;
LogBytes& LogBytes::operator=(LogBytes&&) noexcept = default;

Result<LogBytes::Source> LogBytes::sourceOf(const std::string& path)
{
    const auto file = std::make_shared<LogFile>(path);
    if (file->fd() < 0) {
        const int code = errno;
        return fileError(
            path, Message(TR_NOOP("core", "cannot be opened: %1"), systemMessage(code)), code);
    }
    return Source([file](std::span<char> room) -> Result<std::size_t> {
        for (;;) {
            const ssize_t got = ::read(file->fd(), room.data(), room.size());
            if (got >= 0) return static_cast<std::size_t>(got);
            const int code = errno;
            if (code != EINTR)
                return Error{Message(TR_NOOP("core", "cannot be read: %1"), systemMessage(code)),
                             code};
        }
    });
}

bool LogBytes::isPacked() const
{
    return packed_ != nullptr;
}

bool LogBytes::isTorn() const
{
    return packed_ && packed_->isTorn;
}

bool LogBytes::isFollowed() const
{
    return packed_ && packed_->isFollowed;
}

Result<std::string_view> LogBytes::peek(std::size_t least)
{
    if (!hasBegun_)
        if (const Status done = begin(); !done) return done.error();
    while (block_.size() - at_ < least && !hasEnded_) {
        const Result<std::size_t> got = more();
        if (!got) return got.error();
        hasEnded_ = *got == 0;
    }
    return std::string_view(block_).substr(at_);
}

void LogBytes::consume(std::size_t bytes)
{
    at_ += std::min(bytes, block_.size() - at_);
}

/// Detects the encoding by the first bytes: gzip, a byte order mark, or characters of two bytes.
Status LogBytes::begin()
{
    hasBegun_ = true;
    if (const auto first = peek(2); !first) return first.error();
    if (block_.starts_with("\x1F\x8B")) {
        packed_ = std::make_unique<Packed>();
        if (!packed_->isReady)
            return Error{TR_NOOP("core", "cannot be unpacked: there is no memory")};
        std::copy(block_.begin(), block_.end(), packed_->input.begin());
        packed_->stream.next_in = reinterpret_cast<Bytef*>(packed_->input.data());
        packed_->stream.avail_in = static_cast<uInt>(block_.size());
        packed_->packedBytes = block_.size();
        block_.clear();
        hasEnded_ = false;
    }
    if (const auto first = peek(4); !first) return first.error();
    if (packed_ && block_.starts_with("\x1F\x8B"))
        return Error{TR_NOOP("core", "is packed by gzip twice: unpack it once (gzip -d)")};
    if (contentKind(block_) == ContentKind::Utf32)
        return Error{TR_NOOP("core", "is text in UTF-32: save it in UTF-8")};
    if (block_.starts_with("\xEF\xBB\xBF")) consume(3);
    isLowFirst_ = block_.starts_with("\xFF\xFE");
    isWide_ = isLowFirst_ || block_.starts_with("\xFE\xFF");
    const std::size_t mark = isWide_ ? 2 : 0;
    const auto isZero = [this](std::size_t i) { return i < block_.size() && block_[i] == '\0'; };
    if (!isWide_ && block_.size() >= 4 && isZero(0) == isZero(2) && isZero(1) == isZero(3)
        && isZero(0) != isZero(1)) {
        isWide_ = true;
        isLowFirst_ = isZero(1);
    }
    if (isWide_) addWide(std::exchange(block_, {}).substr(mark));
    return Done{};
}

/// Adds characters of UTF-16. Only ASCII characters matter in a log.
void LogBytes::addWide(std::string_view bytes)
{
    half_ += bytes;
    const std::string wide = std::exchange(half_, {});
    const std::size_t whole = wide.size() / 2 * 2;
    for (std::size_t i = 0; i < whole; i += 2) {
        const char low = wide[isLowFirst_ ? i : i + 1], high = wide[isLowFirst_ ? i + 1 : i];
        block_ += high == '\0' && static_cast<unsigned char>(low) < 0x80 ? low : '?';
    }
    half_ = wide.substr(whole);
}

/// Adds available bytes. Returns 0 at the end of the log.
Result<std::size_t> LogBytes::more()
{
    block_.erase(0, at_);
    at_ = 0;
    std::array<char, kBlock> room{};
    Result<std::size_t> got = packed_ ? unpack(room) : source_(room);
    if (!got || *got == 0) return got;
    const std::string_view bytes(room.data(), *got);
    if (isWide_)
        addWide(bytes);
    else
        block_ += bytes;
    return got;
}

/// Unpacks bytes. Several packed pieces in a row are one log.
Result<std::size_t> LogBytes::unpack(std::span<char> room)
{
    Packed& p = *packed_;
    p.stream.next_out = reinterpret_cast<Bytef*>(room.data());
    p.stream.avail_out = static_cast<uInt>(room.size());
    while (p.stream.avail_out == room.size() && !p.isTorn) {
        if (p.stream.avail_in == 0) {
            Result<std::size_t> got = source_(p.input);
            if (!got) return got;
            p.stream.next_in = reinterpret_cast<Bytef*>(p.input.data());
            p.stream.avail_in = static_cast<uInt>(*got);
            p.packedBytes += *got;
            p.isTorn = *got == 0 && !p.isWhole;
            if (*got == 0) break;
        }
        if (std::exchange(p.isWhole, false)) {
            // zeros are padding
            p.isFollowed = *p.stream.next_in != 0x1F && *p.stream.next_in != 0;
            if (*p.stream.next_in != 0x1F) return std::size_t{0};
            ::inflateReset(&p.stream);
        }
        const int result = ::inflate(&p.stream, Z_NO_FLUSH);
        p.isWhole = result == Z_STREAM_END;
        if (result != Z_OK && result != Z_STREAM_END && result != Z_BUF_ERROR)
            return Error{
                TR_NOOP("core", "cannot be unpacked from here on: its packed bytes are damaged")};
    }
    const std::size_t unpacked = room.size() - p.stream.avail_out;
    p.unpackedBytes += unpacked;
    if (p.growsTooMuch())
        return Error{Message(TR_NOOP("core", "unpacks to more than %1 times its size: if it is a "
                                             "log, unpack it first (gzip -d)"),
                             kMaxGrowth)};
    return unpacked;
}

}  // namespace terratact
