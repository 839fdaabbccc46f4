// Fuzzes drives as CSV. Accepted lines are plausible and in the order of time, and survive writing and reading.
#include "core/learn/data/drive_file.h"

#include <cstdint>

#include "tests/fuzz/promise.h"
#include "tests/fuzz/scratch_file.h"

using namespace terratact;
using namespace terratact::fuzz;

namespace {

const ScratchFile& file()
{
    static const ScratchFile scratch("drives.csv");
    return scratch;
}

void promiseDrive(const DriveLines& drive)
{
    promise(!drive.lines.empty(), "a drive holds a line");
    double last = drive.lines.front().line.time;
    for (const DriveLine& line : drive.lines) {
        promise(isPlausible(drive, line), "a line is within its columns");
        promise(line.line.time >= last, "lines are in the order of time");
        last = line.line.time;
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    file().write(data, size);
    const Result<DriveFile> read = readDrives(file().path());
    if (!read) return promiseRefusal(read.error(), file().path()), 0;
    std::string text = drivesHeader(read->drives.front().onePlane, DriveColumns::Measured);
    for (const DriveLines& drive : read->drives) {
        promiseDrive(drive);
        text += driveText(drive, DriveColumns::Measured);
    }
    file().write(reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
    const Result<DriveFile> again = readDrives(file().path());
    promise(again && again->drives.size() == read->drives.size(), "drives are read again");
    std::string second = drivesHeader(read->drives.front().onePlane, DriveColumns::Measured);
    for (const DriveLines& drive : again->drives)
        second += driveText(drive, DriveColumns::Measured);
    promise(second == text, "rounded drives survive being written and read");
    return 0;
}
