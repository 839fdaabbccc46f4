#include "app/modelling/training/trail_learning.h"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>
#include <vector>

#include "app/runtime/parallel.h"
#include "core/learn/data/drive_copies.h"
#include "core/learn/data/drive_file.h"
#include "core/learn/data/scene_copies.h"
#include "core/store/file_read.h"
#include "core/store/sha256.h"

namespace terratact {
namespace {

constexpr std::size_t kDrivesAtOnce = 64;

/// Turns drives into rows, some at a time, in the order of the file.
class RowCollector {
public:
    RowCollector(const TrailPlan& plan, bool sides) : plan_(plan), sides_(sides) {}

    /// Adds the drives of a file. Returns notices about it.
    Result<std::vector<Message>> addFile(const std::string& path)
    {
        auto read = readDrives(path, [&](DriveLines&& drive) { add(std::move(drive)); });
        if (read && unfit_)
            return fileError(path,
                             sides_ ? "holds drives of one plane: expected drives on two tracks"
                                    : "holds drives on two tracks: expected drives of one plane");
        return read;
    }

    /// Returns all rows.
    TrailRows finish()
    {
        flush();
        return joined(rows_);
    }
    int drives() const { return drives_; }
    int copies() const { return copies_; }
    /// Returns the number of scenes that repeat a place of an earlier drive.
    int repeats() const { return repeats_; }
    const std::vector<DriveMarks>& marks() const { return known_.drives(); }

private:
    void add(DriveLines&& drive)
    {
        unfit_ = unfit_ || drive.onePlane == sides_;
        if (unfit_) return;
        if (known_.isCopy(drive)) {
            ++copies_;
            return;
        }
        if (sides_)
            countRepeats(trackScenesOf(drive), trackPlaces_);
        else
            countRepeats(planeScenesOf(drive), planePlaces_);
        waiting_.push_back(std::move(drive));
        if (waiting_.size() == kDrivesAtOnce) flush();
    }

    template <class SceneType>
    void countRepeats(const std::vector<SceneType>& scenes, SceneRepeats<SceneType>& places)
    {
        const int begin = scenes_;
        for (const SceneType& scene : scenes)
            if (places.add(scene, scenes_++).first < begin) ++repeats_;
    }

    void flush()
    {
        std::vector<TrailRows> rows(waiting_.size());
        parallelFor(static_cast<int>(waiting_.size()), [&](int k) {
            const auto drive = static_cast<std::size_t>(k);
            rows[drive] =
                trailRows({&waiting_[drive], 1}, drives_ + k, plan_.robot, sides_, plan_.seed);
        });
        for (TrailRows& own : rows) rows_.push_back(std::move(own));
        drives_ += static_cast<int>(waiting_.size());
        waiting_.clear();
    }

    const TrailPlan& plan_;
    bool sides_;
    std::vector<DriveLines> waiting_;
    std::vector<TrailRows> rows_;
    DriveCopies known_;
    SceneRepeats<Scene> planePlaces_;
    SceneRepeats<TwoTrackScene> trackPlaces_;
    int drives_ = 0, copies_ = 0;
    int scenes_ = 0, repeats_ = 0;
    bool unfit_ = false;  ///< a drive of the other kind came
};

Result<TrailNetworks> learnFrom(const std::vector<std::string>& files, bool sides,
                                const TrailPlan& plan,
                                const std::function<void(const std::string&)>& notice)
{
    RowCollector collector(plan, sides);
    for (const std::string& path : files) {
        const auto read = collector.addFile(path);
        if (!read) return read.error();
        for (const Message& sentence : *read) notice(sentence.english());
    }
    const TrailRows rows = collector.finish();
    if (collector.copies() > 0)
        notice(fmt::format("{} drives are there twice: their copies were left out",
                           collector.copies()));
    if (collector.repeats() > 0)
        notice(
            fmt::format("{} scenes repeat a place of an earlier drive within the sensors' noise: "
                        "the networks' errors may be too small",
                        collector.repeats()));
    const std::string name = files.size() == 1
                               ? files.front()
                               : fmt::format("{} and {} more", files.front(), files.size() - 1);
    notice(fmt::format("{}: {} drives, {} rows{}", name, collector.drives(), rows.inputs.cols(),
                       rows.leftOut > 0 ? fmt::format(", {} scenes left out", rows.leftOut) : ""));
    const ForEach sideBySide = [](int count, const std::function<void(int)>& work) {
        parallelFor(count, work);
    };
    TrailOptions options = plan.options;
    options.network.seed = plan.seed;
    try {
        TrailNetworks networks = trainTrail(rows, sides, options, sideBySide);
        networks.drives = collector.marks();
        return networks;
    } catch (const std::invalid_argument& refused) {
        return fileError(files.front(), refused.what());
    }
}

Status learnInto(TrailNetworks& networks, std::string& hash, const std::vector<std::string>& files,
                 bool sides, const TrailPlan& plan,
                 const std::function<void(const std::string&)>& notice)
{
    if (files.empty()) return Done{};
    std::string hashes;
    for (const std::string& path : files) {
        const auto digest = sha256OfFile(path);
        if (!digest) return digest.error();
        hashes += *digest;
    }
    auto learnt = learnFrom(files, sides, plan, notice);
    if (!learnt) return learnt.error();
    networks = std::move(*learnt);
    hash = files.size() == 1 ? hashes : sha256Hex(hashes);
    return Done{};
}

}  // namespace

Result<TrailData> learnTrail(const TrailPlan& plan,
                             const std::function<void(const std::string&)>& notice)
{
    TrailData data;
    data.command = plan.commandLine;
    data.seed = plan.seed;
    if (Status s = learnInto(data.plane, data.planeHash, plan.drives, false, plan, notice); !s)
        return s.error();
    if (Status s = learnInto(data.side, data.sideHash, plan.trackDrives, true, plan, notice); !s)
        return s.error();
    return data;
}

}  // namespace terratact
