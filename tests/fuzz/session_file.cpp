// Fuzzes session files as bytes. Only recorded values are returned, whatever was flipped, cut or inserted.
#include "core/log/session_reader.h"

#include <cstdint>

#include "tests/fuzz/in_place.h"
#include "tests/fuzz/promise.h"
#include "tests/fuzz/scratch_file.h"
#include "tests/support/sessions/sessions.h"

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

/// Returns the estimate that was recorded: the second one has two sides.
TwoTrackEstimate recorded(const EstimateRow& row)
{
    return row.id == 1 ? someEstimate(1, row.time).estimate : someSides(row.id, row.time).estimate;
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
            promise((*draws)[0] == recorded(row).side[0].draws
                        && (*draws)[1] == recorded(row).side[1].draws,
                    "draws that are shown were recorded");
}

}  // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t most, unsigned seed)
{
    return mutateInPlace(realSession(), data, size, most, seed);
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
