// Fuzzes point clouds and poses: PCD, PLY, text, TUM and CSV by their content. Blocks are bounded, points are finite,
// and messages about a file are one line.
#include <cmath>
#include <cstdint>

#include "core/clouds/cloud_reader.h"
#include "core/clouds/pose_track.h"
#include "tests/fuzz/promise.h"
#include "tests/fuzz/scratch_file.h"

using namespace terratact;
using namespace terratact::fuzz;

namespace {

const ScratchFile& cloudFile()
{
    static const ScratchFile scratch("cloud");
    return scratch;
}

void readCloud(const std::string& path)
{
    auto cloud = openCloud(path);
    if (!cloud) return promiseRefusal(cloud.error(), path);
    std::uint64_t points = 0;
    for (std::vector<CloudPoint> block;;) {
        const auto more = (*cloud)->next(block);
        if (!more) return promiseRefusal(more.error(), path);
        if (!*more) break;
        promise(block.size() <= kCloudBlock, "a block is bounded");
        points += block.size();
        for (const CloudPoint& p : block)
            promise(std::abs(p.x) <= kFarthestPoint && std::abs(p.y) <= kFarthestPoint
                        && std::abs(p.z) <= kFarthestPoint,
                    "a point is finite and near");
    }
    promise(points + (*cloud)->leftOut() == (*cloud)->points(), "every point is counted once");
}

void readTracks(const std::string& path)
{
    const auto tracks = readPoses(path, {});
    if (!tracks) return promiseRefusal(tracks.error(), path);
    for (const auto& [run, track] : *tracks) {
        promise(track.at(track.begin()).has_value(), "the first pose is found");
        const auto middle = track.at(0.5 * (track.begin() + track.end()));
        promise(!middle || middle->place.allFinite(), "a pose is finite");
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    cloudFile().write(data, size);
    readCloud(cloudFile().path());
    readTracks(cloudFile().path());
    return 0;
}
