#include "app/modelling/trail_learning.h"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>
#include <vector>

#include "app/runtime/parallel.h"
#include "core/learn/data/drive_file.h"
#include "core/store/sha256.h"

namespace terratact {
namespace {

constexpr std::size_t kDrivesAtOnce = 64;

/// Turns drives into rows, some at a time, in the order of the file.
class RowCollector {
public:
    RowCollector(const TrailPlan& plan, bool sides) : plan_(plan), sides_(sides) {}

    void add(DriveLines&& drive)
    {
        if (drive.onePlane == sides_) ++unfit_;
        if (unfit_ > 0) return;
        waiting_.push_back(std::move(drive));
        if (waiting_.size() == kDrivesAtOnce) flush();
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

    /// Returns all rows.
    TrailRows take() { return joined(rows_); }
    int drives() const { return drives_; }
    int unfit() const { return unfit_; }

private:
    const TrailPlan& plan_;
    bool sides_;
    std::vector<DriveLines> waiting_;
    std::vector<TrailRows> rows_;
    int drives_ = 0, unfit_ = 0;
};

Result<TrailNetworks> learnFrom(const std::string& path, bool sides, const TrailPlan& plan,
                                const std::function<void(const std::string&)>& notice)
{
    RowCollector collector(plan, sides);
    const auto read =
        readDrives(path, [&](DriveLines&& drive) { collector.add(std::move(drive)); });
    if (!read) return read.error();
    for (const Message& sentence : *read) notice(sentence.english());
    collector.flush();
    if (collector.unfit() > 0)
        return fileError(path, sides ? "holds drives of one plane: expected drives on two tracks"
                                     : "holds drives on two tracks: expected drives of one plane");
    const TrailRows rows = collector.take();
    notice(fmt::format("{}: {} drives, {} rows{}", path, collector.drives(), rows.inputs.cols(),
                       rows.leftOut > 0 ? fmt::format(", {} scenes left out", rows.leftOut) : ""));
    const ForEach sideBySide = [](int count, const std::function<void(int)>& work) {
        parallelFor(count, work);
    };
    TrailOptions options = plan.options;
    options.network.seed = plan.seed;
    try {
        return trainTrail(rows, sides, options, sideBySide);
    } catch (const std::invalid_argument& refused) {
        return fileError(path, refused.what());
    }
}

Status learnInto(TrailNetworks& networks, std::string& hash, const std::string& path, bool sides,
                 const TrailPlan& plan, const std::function<void(const std::string&)>& notice)
{
    if (path.empty()) return Done{};
    const auto digest = sha256OfFile(path);
    if (!digest) return digest.error();
    auto learnt = learnFrom(path, sides, plan, notice);
    if (!learnt) return learnt.error();
    networks = std::move(*learnt);
    hash = *digest;
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
