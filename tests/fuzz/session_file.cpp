// Session files as bytes: what is shown was recorded, whatever was flipped, cut or put in.
#include "core/log/session_reader.h"

#include <algorithm>
#include <cstdint>
#include <random>

#include "tests/fuzz/promise.h"
#include "tests/fuzz/scratch_file.h"
#include "tests/support/sessions.h"

using namespace terratact;
using namespace terratact::fuzz;

namespace {

constexpr std::int64_t kFrames = 40;

const ScratchFile& file()
{
    static const ScratchFile scratch("session.tts");
    return scratch;
}

const std::string& realSession()
{
    static const std::string bytes = [] {
        std::filesystem::remove(file().path());
        auto writer = someSession(file().path(), kFrames);
        promise(writer && writer->seal(), "a session can be written");
        return file().read();
    }();
    return bytes;
}

void promiseShown(SessionReader& session)
{
    for (std::size_t i = 0; i < session.batches().size(); ++i)
        for (const FrameRow& frame : session.frames(i))
            promise(frame.time >= 0 && frame == someFrame(frame.time / 1'000'000),
                    "a frame that is shown was recorded");
    for (const EventRow& event : session.events())
        if (event.kind == EventKind::Decision)
            promise(event == someDecision(event.time), "a decision that is shown was made");
    for (const EstimateRow& row : session.estimates())
        if (const auto draws = session.draws(row.id))
            promise(*draws == someEstimate(row.id, row.time).estimate.draws,
                    "draws that are shown were recorded");
}

}  // namespace

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t most, unsigned seed)
{
    const std::string& real = realSession();
    if (size != real.size() && real.size() <= most) {
        std::copy(real.begin(), real.end(), data);
        return real.size();
    }
    if (size == 0) return LLVMFuzzerMutate(data, size, most);
    std::minstd_rand rng(seed);
    constexpr std::size_t kMostChanged = 64;  // bytes
    const std::size_t at = std::uniform_int_distribution<std::size_t>(0, size - 1)(rng);
    const std::size_t length = std::min(kMostChanged, size - at);
    LLVMFuzzerMutate(data + at, std::uniform_int_distribution<std::size_t>(1, length)(rng), length);
    return size;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    static_cast<void>(realSession());
    file().write(data, size);
    auto session = SessionReader::open(file().path());
    if (!session) return promiseRefusal(session.error(), file().path()), 0;
    promiseShown(*session);
    static_cast<void>(session->verify());
    return 0;
}
