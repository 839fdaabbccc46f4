#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "app/cli/session/session_commands.h"
#include "app/recording/recording_import.h"
#include "app/recording/session_text.h"
#include "app/recording/survey_text.h"
#include "app/runtime/print_text.h"
#include "app/runtime/text_output.h"
#include "core/mapping/mapping_proposal.h"
#include "core/mapping/recording_check.h"
#include "core/mapping/recording_survey.h"
#include "core/store/file_read.h"
#include "core/store/file_write.h"

namespace terratact {

namespace {

/// Prints what is damaged or missing, on the standard error.
void printRemarks(const std::string& file, const std::vector<std::string>& remarks)
{
    for (const std::string& remark : remarks)
        printText(stderr, "terratact: {}: {}\n", file, remark);
}

Status probeRecording(const ImportOptions& options)
{
    CsvTime csv;
    if (!options.mapping.empty()) {
        const auto mapping = readMapping(options.mapping);
        if (!mapping) return mapping.error();
        csv = mapping->csv;
    }
    const auto recording = openRecording(options.file, csv);
    if (!recording) return recording.error();
    const auto surveys = surveyRecording(**recording);
    if (!surveys) return surveys.error();
    std::uint64_t messages = 0;
    for (const TopicSurvey& survey : *surveys) messages += survey.messages;
    printText("{}", Lines(surveyText(**recording, *surveys)));
    printRemarks(options.file, (*recording)->consumeRemarks());
    if (messages == 0) return fileError(options.file, "holds no message");
    const std::string name = std::filesystem::path(options.file).stem().string();
    printText("\n# ---- proposed mapping ----\n{}", Lines(proposedMapping(*surveys, name)));
    return Done{};
}

Status checkMapped(const ImportOptions& options)
{
    const auto mapping = readMapping(options.mapping);
    if (!mapping) return mapping.error();
    const auto robot = readRobotModel(options.robot);
    if (!robot) return robot.error();
    const auto findings = checkRecording(options.file, *mapping, *robot);
    if (!findings) return findings.error();
    for (const std::string& finding : *findings) printText("{}: {}\n", options.file, finding);
    if (findings->empty()) {
        printText("{}: nothing is doubtful\n", options.file);
        return Done{};
    }
    return fileError(options.file,
                     fmt::format("{} doubt{}", findings->size(), findings->size() == 1 ? "" : "s"));
}

/// Checks that the scenes can be written, so that no session is left if they cannot.
Status checkScenes(const std::string& path)
{
    if (path.empty() || isStandardOutput(path) || isStream(path)) return Done{};
    const auto scenes = NewFile::begin(path);  // leaves no file
    return scenes ? Status(Done{}) : scenes.error();
}

Status writeSession(const ImportOptions& options)
{
    if (const Status s = checkScenes(options.scenes); !s) return s;
    const auto done = importRecording({.file = options.file,
                                       .mapping = options.mapping,
                                       .robot = options.robot,
                                       .out = options.out});
    if (!done) return done.error();
    printRemarks(options.file, done->remarks);
    printText(
        "{} lines of telemetry in {:.3f} s, {} frames and {} scenes of {} written to {}; last "
        "link {}\n",
        done->lines, done->seconds, done->frames, done->scenes, options.file, options.out,
        done->chain);
    if (options.scenes.empty()) return Done{};
    return exportScenes({.files = {options.out}, .out = options.scenes});
}

}  // namespace

Status importOrProbe(const ImportOptions& options)
{
    if (options.probe) return probeRecording(options);
    return options.check ? checkMapped(options) : writeSession(options);
}

}  // namespace terratact
