// Fuzzes the files of networks as bytes. Mutants keep the size of a real file, otherwise its header would reject them
// all.
#include "core/trail/trail_file.h"

#include <cstdint>

#include "core/learn/data/drive_copies.h"
#include "core/robot/robot_model.h"
#include "core/sim/ground/random_terrain.h"
#include "core/sim/way_drive.h"
#include "core/trail/trail_training.h"
#include "tests/fuzz/in_place.h"
#include "tests/fuzz/promise.h"
#include "tests/fuzz/scratch_file.h"
#include "tests/support/absolem.h"

using namespace terratact;
using namespace terratact::fuzz;

namespace {

const ScratchFile& file()
{
    static const ScratchFile scratch("small.ttn");
    return scratch;
}

/// Networks of few drives in one plane; those of both sides stay empty.
TrailData smallTrail()
{
    std::vector<DriveLines> drives;
    drives.reserve(21);
    for (std::uint64_t seed = 0; seed < 21; ++seed) {
        std::mt19937_64 rng(seed);
        int skipped = 0;
        const TerrainProfile terrain = randomVariedTerrain(rng);
        const DriveStyle style = randomDriveStyle(rng);
        drives.push_back(driveWay(absolem(), terrain, std::to_string(seed), style,
                                  {.spacing = 0.12}, DriveConditions{}, rng, skipped));
    }
    TrailOptions options;
    options.networks = 1;
    options.network.hidden = {8};
    options.network.epochs = 1;
    options.network.batch = 32;
    TrailData trail;
    trail.plane = trainTrail(trailRows(drives, 0, absolem(), false, 1), false, options);
    for (const DriveLines& drive : drives) trail.plane.drives.push_back(driveMarks(drive));
    trail.command = "terratact train";
    trail.planeHash = std::string(64, 'a');
    return trail;
}

const std::string& realTrail()
{
    static const std::string bytes = [] {
        promise(bool(writeTrail(file().path(), smallTrail())), "networks can be written");
        return file().read();
    }();
    return bytes;
}

}  // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t most, unsigned seed)
{
    return mutateInPlace(realTrail(), data, size, most, seed);
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    file().write(data, size);
    const Result<StoredTrail> trail = readTrail(file().path());
    if (!trail) return promiseRefusal(trail.error(), file().path()), 0;
    promise(bool(writeTrail(file().path(), trail->data)), "what was read can be written");
    const Result<StoredTrail> again = readTrail(file().path());
    promise(again && again->contentHash == trail->contentHash,
            "networks survive being written and read");
    return 0;
}
