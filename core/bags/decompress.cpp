#include "core/bags/decompress.h"

#include <bzlib.h>
#include <fmt/format.h>
#include <lz4frame.h>
#include <zstd.h>

#include <algorithm>
#include <array>
#include <memory>

#include "core/base/text.h"

namespace terratact {
namespace {

using Piece = std::array<char, std::size_t{64} * 1024>;

/// Decompressed bytes, with an upper bound.
class Expanded {
public:
    Expanded(std::string& into, std::size_t packed)
        : into_(into),
          most_(std::min(kMaxChunkBytes, std::max(kSmallChunkBytes, kMaxExpansion * packed)))
    {
    }

    /// Adds the output of one step. Returns false if it exceeds the bound.
    bool add(const char* piece, std::size_t size)
    {
        if (size > most_ - into_.size()) return false;
        into_.append(piece, size);
        return true;
    }

    Error tooLarge() const
    {
        return Error{fmt::format("is larger than {} bytes, decompressed", most_)};
    }

private:
    std::string& into_;
    std::size_t most_;
};

Error cutChunk(std::string_view method)
{
    return Error{fmt::format("ends within its {} bytes", method)};
}

Status fromLz4(std::string_view bytes, Expanded& into)
{
    LZ4F_dctx* raw = nullptr;
    if (LZ4F_isError(LZ4F_createDecompressionContext(&raw, LZ4F_VERSION)) != 0)
        throw std::bad_alloc();
    const std::unique_ptr<LZ4F_dctx, LZ4F_errorCode_t (*)(LZ4F_dctx*)> context(
        raw, LZ4F_freeDecompressionContext);
    const auto piece = std::make_unique<Piece>();
    std::size_t wanted = 1;  // 0: a frame is complete
    while (!bytes.empty()) {
        std::size_t produced = piece->size(), consumed = bytes.size();
        wanted = LZ4F_decompress(context.get(), piece->data(), &produced, bytes.data(), &consumed,
                                 nullptr);
        if (LZ4F_isError(wanted) != 0)
            return Error{fmt::format("is no LZ4: {}", LZ4F_getErrorName(wanted))};
        if (!into.add(piece->data(), produced)) return into.tooLarge();
        bytes.remove_prefix(consumed);
        if (consumed == 0 && produced == 0) break;
    }
    // The last bytes may have more output than one piece.
    while (wanted != 0) {
        std::size_t produced = piece->size(), consumed = 0;
        wanted =
            LZ4F_decompress(context.get(), piece->data(), &produced, nullptr, &consumed, nullptr);
        if (LZ4F_isError(wanted) != 0 || produced == 0) return cutChunk("LZ4");
        if (!into.add(piece->data(), produced)) return into.tooLarge();
    }
    return Done{};
}

Status fromZstd(std::string_view bytes, Expanded& into)
{
    const std::unique_ptr<ZSTD_DCtx, std::size_t (*)(ZSTD_DCtx*)> context(ZSTD_createDCtx(),
                                                                          ZSTD_freeDCtx);
    if (!context) throw std::bad_alloc();
    // The library allocates the window that a frame declares. 2^24 bytes: kSmallChunkBytes.
    constexpr int kMaxWindow = 24;
    ZSTD_DCtx_setParameter(context.get(), ZSTD_d_windowLogMax, kMaxWindow);
    const auto piece = std::make_unique<Piece>();
    ZSTD_inBuffer in{bytes.data(), bytes.size(), 0};
    for (;;) {
        ZSTD_outBuffer out{piece->data(), piece->size(), 0};
        const std::size_t wanted = ZSTD_decompressStream(context.get(), &out, &in);
        if (ZSTD_isError(wanted) != 0)
            return Error{fmt::format("is no Zstandard: {}", ZSTD_getErrorName(wanted))};
        if (!into.add(piece->data(), out.pos)) return into.tooLarge();
        if (in.pos < in.size) continue;
        if (wanted == 0) return Done{};  // the frame is complete, and all of it came out
        if (out.pos < out.size) return cutChunk("Zstandard");
    }
}

Status fromBzip2(std::string_view bytes, Expanded& into)
{
    bz_stream stream{};
    if (BZ2_bzDecompressInit(&stream, 0, 0) != BZ_OK) throw std::bad_alloc();
    const std::unique_ptr<bz_stream, int (*)(bz_stream*)> guard(&stream, BZ2_bzDecompressEnd);
    const auto piece = std::make_unique<Piece>();
    std::string copy(bytes);  // the library takes no const bytes
    stream.next_in = copy.data();
    stream.avail_in = static_cast<unsigned>(copy.size());
    for (;;) {
        stream.next_out = piece->data();
        stream.avail_out = static_cast<unsigned>(piece->size());
        const int state = BZ2_bzDecompress(&stream);
        const std::size_t produced = piece->size() - stream.avail_out;
        if (!into.add(piece->data(), produced)) return into.tooLarge();
        if (state == BZ_STREAM_END) return Done{};
        if (state != BZ_OK) return Error{"is no bzip2"};
        if (stream.avail_in == 0 && produced == 0) return cutChunk("bzip2");
    }
}

}  // namespace

Status decompress(std::string_view method, std::string_view bytes, std::string& into)
{
    into.clear();
    Expanded out(into, bytes.size());
    if (bytes.size() > kMaxChunkBytes) return out.tooLarge();
    if (method.empty() || method == "none") {
        into.assign(bytes);
        return Done{};
    }
    if (method == "lz4") return fromLz4(bytes, out);
    if (method == "zstd") return fromZstd(bytes, out);
    if (method == "bz2") return fromBzip2(bytes, out);
    return Error{
        fmt::format("has the compression {}, expected none, lz4, zstd or bz2", shown(method))};
}

ChunkUnpacker::ChunkUnpacker(std::uint64_t recordingBytes)
    : most_(std::max(kSmallRecordingBytes, kMaxRecordingExpansion * recordingBytes)), left_(most_)
{
}

Status ChunkUnpacker::unpack(std::string_view method, std::string_view bytes, std::string& into)
{
    into.clear();
    Status done = left_ > 0 ? decompress(method, bytes, into) : Status(Done{});
    if (left_ > 0 && into.size() <= left_) {
        left_ -= into.size();
        return done;
    }
    left_ = 0;
    into.clear();
    return Error{fmt::format("is beyond the {} bytes that this recording may expand to", most_)};
}

}  // namespace terratact
