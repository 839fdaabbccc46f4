// Fuzzes the other CSV files. The first byte selects the kind. p: points or heights of a profile. b: its heights as
// blocks. a: readings of the arm. c: an index of classes. l: lines of a ground.
#include <cmath>
#include <cstdint>

#include "core/base/text.h"
#include "core/eval/groups.h"
#include "core/learn/data/ground_file.h"
#include "core/learn/data/probe_file.h"
#include "core/learn/data/profile_file.h"
#include "core/store/csv_text.h"
#include "tests/fuzz/promise.h"

using namespace terratact;
using namespace terratact::fuzz;

namespace {

void promisePoints(const TerrainProfile& profile)
{
    double x = profile.begin();
    for (const Vec2& point : profile.points()) {
        promise(std::isfinite(point.x) && std::isfinite(point.z), "a profile's points are finite");
        promise(point.x >= x, "a profile's x never decreases");
        x = point.x;
    }
    promise(std::isfinite(profile.heightAt((profile.begin() + profile.end()) / 2)),
            "a profile has a height");
}

void promiseProfile(const TerrainProfile& profile)
{
    promisePoints(profile);
    std::string text = "x_m,z_m\n";
    for (const Vec2& point : profile.points())
        text += numberText(point.x) + "," + numberText(point.z) + "\n";
    if (std::abs(profile.begin()) > 1000.0 || std::abs(profile.end()) > 1000.0) return;
    if (profile.points().size() < 2) return;
    const auto again = readProfiles(*CsvReader::over("g", text), 0.1, false);
    promise(again && again->profiles.size() == 1
                && again->profiles.front().points() == profile.points(),
            "a profile survives being written as points and read");
}

void readProfiles(CsvReader csv, bool blocks)
{
    const Result<ProfileFile> file = terratact::readProfiles(std::move(csv), 0.05, blocks);
    if (!file) return promiseRefusal(file.error(), "f");
    promise(!file->profiles.empty(), "a file holds a profile");
    for (const TerrainProfile& profile : file->profiles) promiseProfile(profile);
}

void readLines(CsvReader csv)
{
    const Result<GroundFile> file = readGrounds(std::move(csv), 0.05, false);
    if (!file) return promiseRefusal(file.error(), "f");
    promise(!file->grounds.empty(), "a file holds a ground");
    for (const GroundLines& ground : file->grounds) {
        promise(ground.begin() <= ground.end(), "a ground's lines have a common range");
        // A line alone may be refused: its heights are limited around the first of the ground.
        for (const GroundLine& line : ground.lines()) promisePoints(line.profile);
    }
}

void readArm(CsvReader csv)
{
    const Result<std::vector<ProbeReading>> readings = readProbeReadings(std::move(csv));
    if (!readings) return promiseRefusal(readings.error(), "f");
    std::string text = "place,height_m,truth_m\n";
    for (const ProbeReading& reading : *readings) {
        promise(std::isfinite(reading.height) && (!reading.truth || std::isfinite(*reading.truth)),
                "an arm's reading is finite");
        text += csvField(reading.place) + "," + numberText(reading.height) + ","
              + (reading.truth ? numberText(*reading.truth) : "") + "\n";
    }
    const auto again = readProbeReadings(*CsvReader::over("g", text));
    promise(again && *again == *readings, "readings survive being written and read");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    if (size == 0) return 0;
    Result<CsvReader> csv = CsvReader::over("f", textOf(data + 1, size - 1));
    if (!csv) return promiseRefusal(csv.error(), "f"), 0;
    if (data[0] == 'c') {
        const Result<Classes> classes = readClasses(*std::move(csv), "class");
        if (!classes) promiseRefusal(classes.error(), "f");
        return 0;
    }
    if (data[0] == 'a')
        readArm(*std::move(csv));
    else if (data[0] == 'l')
        readLines(*std::move(csv));
    else
        ::readProfiles(*std::move(csv), data[0] == 'b');
    return 0;
}
