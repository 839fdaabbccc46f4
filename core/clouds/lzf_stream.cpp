#include "core/clouds/lzf_stream.h"

#include <fmt/format.h>

#include <algorithm>

namespace terratact {
namespace {

unsigned byteOf(const std::string& text, std::size_t at)
{
    return static_cast<unsigned char>(text[at]);
}

}  // namespace

LzfStream::LzfStream(CloudFile file, std::uint64_t packed) : file_(std::move(file)), left_(packed)
{
}

Error LzfStream::damaged(std::string_view what) const
{
    return file_.error(
        fmt::format("the compressed points {} at byte {}: the file is cut or damaged; "
                    "write it again, or as DATA binary",
                    what, file_.at()));
}

bool LzfStream::take(std::size_t count, std::string& into)
{
    if (count > left_ || file_.read(count, into) != count) return false;
    left_ -= count;
    return true;
}

Status LzfStream::decodeOne()
{
    if (!take(1, packed_)) return damaged("end too early");
    const unsigned control = byteOf(packed_, 0);
    if (control < 32) {
        if (!take(control + 1, packed_)) return damaged("end within a literal");
        out_ += packed_;
        return Done{};
    }
    std::size_t length = (control >> 5U) + 2;
    if (!take(control >> 5U == 7 ? 2 : 1, packed_)) return damaged("end within a copy");
    if (packed_.size() == 2) length += byteOf(packed_, 0);
    const std::size_t back =
        (static_cast<std::size_t>(control & 31U) << 8U) + byteOf(packed_, packed_.size() - 1) + 1;
    if (back > out_.size()) return damaged("copy from before their beginning");
    const std::size_t from = out_.size() - back;
    out_.reserve(out_.size() + length);
    for (std::size_t i = 0; i < length; ++i) out_ += out_[from + i];  // they may overlap
    return Done{};
}

Status LzfStream::read(std::size_t count, std::string& into)
{
    into.clear();
    while (into.size() < count) {
        if (read_ == out_.size()) {
            if (out_.size() > std::size_t{16} * kWindow) {
                out_.erase(0, out_.size() - kWindow);
                read_ = out_.size();
            }
            if (Status done = decodeOne(); !done) return done;
        }
        const std::size_t part = std::min(count - into.size(), out_.size() - read_);
        into.append(out_, read_, part);
        read_ += part;
    }
    return Done{};
}

Status LzfStream::skip(std::uint64_t count)
{
    std::string passed;
    while (count > 0) {
        const auto part = static_cast<std::size_t>(std::min<std::uint64_t>(count, kWindow));
        if (Status done = read(part, passed); !done) return done;
        count -= part;
    }
    return Done{};
}

}  // namespace terratact
