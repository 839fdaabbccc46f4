#include "app/mission/trail_networks.h"

#include <filesystem>
#include <system_error>
#include <tuple>
#include <utility>

#include "app/display/format.h"
#include "app/display/translated.h"
#include "app/runtime/resources.h"
#include "core/store/sha256.h"
#include "core/trail/trail_file.h"

namespace terratact {
namespace {

auto shapeOf(const FlipperGeometry& f)
{
    return std::tie(f.pivot, f.pivotRadius, f.tipRadius, f.axleDistance, f.mass, f.comDistance);
}

bool isShipped(const std::string& path)
{
    std::error_code none;
    return std::filesystem::equivalent(path, shippedTrailPath(), none);
}

LoadedTrail noTrail(Message why)
{
    return {.about = {.trouble = std::move(why)}};
}

}  // namespace

bool fitSameNetworks(const RobotModel& a, const RobotModel& b)
{
    const auto key = [](const RobotModel& r) {
        return std::tie(r.baseHeight, r.imu, r.trackAxle, r.trackRadius, r.trackZ, r.body,
                        r.bodyMass, r.bodyCom, r.elementShare, r.rearElementShare,
                        r.torquePerAmpere, r.lateral, r.differential.locked);
    };
    return key(a) == key(b) && shapeOf(a.front) == shapeOf(b.front)
        && shapeOf(a.rear) == shapeOf(b.rear);
}

LoadedTrail trailBeside(const std::string& modelPath, const RobotModel& robot)
{
    const std::string path = trailPathBeside(modelPath);
    const QString name = format::fileName(QString::fromStdString(path));
    std::error_code none;
    if (!std::filesystem::exists(path, none))
        return noTrail(Message(TR_NOOP("terratact::Estimation",
                                       "the model has no networks for it (%1 is not beside it)"),
                               verbatim(name)));
    if (isShipped(path)) {
        const auto shipped = readRobotModel(resourcePath("robots/absolem.toml"));
        if (!shipped) return noTrail(shipped.error().message);
        if (!fitSameNetworks(*shipped, robot))
            return noTrail(Message(
                TR_NOOP("terratact::Estimation", "the networks %1 learnt from another robot"),
                verbatim(name)));
    }
    auto stored = readTrail(path);
    if (!stored) return noTrail(stored.error().message);
    LoadedTrail loaded{.model = std::make_shared<const TrailModel>(std::move(stored->data))};
    loaded.about.name = name;
    if (const auto hash = sha256OfFile(path)) loaded.about.hash = QString::fromStdString(*hash);
    return loaded;
}

}  // namespace terratact
