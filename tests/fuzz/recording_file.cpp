// Fuzzes recordings of other programs: MCAP, ROS 1 bags and CSV by their content. Every message is of a topic. Every
// listed number is found by its path. Messages about a file are one line.
#include "core/bags/recording.h"

#include <cmath>
#include <cstdint>

#include "core/bags/decompress.h"
#include "core/mapping/mapping_proposal.h"
#include "core/mapping/recording_survey.h"
#include "tests/fuzz/promise.h"
#include "tests/fuzz/scratch_file.h"

using namespace terratact;
using namespace terratact::fuzz;

namespace {

const ScratchFile& recordingFile()
{
    static const ScratchFile scratch("recording");
    return scratch;
}

void promiseNumbers(const FieldValue& message)
{
    std::size_t values = 0;
    eachNumber(message, kMaxSurveyElements, [&](const std::string& path, double) {
        ++values;
        static_cast<void>(numberAt(message, path));
    });
    promise(values <= FieldValue::kMaxValues * kMaxSurveyElements, "a message has bounded values");
    static_cast<void>(stampOf(message));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    recordingFile().write(data, size);
    const std::string& path = recordingFile().path();
    auto recording = openRecording(path);
    if (!recording) return promiseRefusal(recording.error(), path), 0;
    for (RecordedMessage message;;) {
        const auto more = (*recording)->next(message);
        if (!more) return promiseRefusal(more.error(), path), 0;
        if (!*more) break;
        promise(message.topic < (*recording)->topics().size(), "a message has a topic");
        promise(message.data.size() <= kMaxChunkBytes, "a message is no larger than a chunk");
        const auto value = (*recording)->decode(message);
        if (value)
            promiseNumbers(*value);
        else
            promiseRefusal(value.error(), path);
    }
    auto again = openRecording(path);
    promise(static_cast<bool>(again), "a file that was opened is opened again");
    if (const auto surveys = surveyRecording(**again))
        promise(!proposedMapping(*surveys, "f").empty(), "every file has a proposal");
    return 0;
}
