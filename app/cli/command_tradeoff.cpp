#include <filesystem>
#include <string>
#include <vector>

#include "app/cli/commands.h"
#include "app/figures/tradeoff_figure.h"
#include "app/modelling/evaluation/tradeoff_measurement.h"
#include "app/modelling/tradeoff_csv.h"
#include "app/runtime/print_text.h"
#include "core/store/file_group.h"
#include "core/store/file_read.h"
#include "core/store/file_write.h"

namespace terratact {

std::vector<std::string> tradeoffFiles()
{
    return {"tradeoff.csv", "presets.csv", "tradeoff.png", "tradeoff.svg"};
}

Status tradeoff(const TradeoffOptions& options)
{
    const auto bundle = openEstimatorBundle(options.robot, options.model);
    if (!bundle) return bundle.error();
    const auto scenes = tradeoffScenes(options.data);
    if (!scenes) return scenes.error();
    const std::filesystem::path out(options.out);
    if (Status made = makeDirectory(options.out); !made) return made;

    std::vector<TradePoint> points;
    std::string references;
    for (const Method method : options.methods) {
        const MethodTradeoff more =
            measureTradeoff(method, *scenes, **bundle, options.referenceDraws, options.seed);
        points.insert(points.end(), more.points.begin(), more.points.end());
        references += referenceText(more);
    }
    if (points.empty()) return fileError(options.data, "no method has an estimate of any scene");
    FileGroup group;
    if (Status s = group.add((out / "tradeoff.csv").string(), tradeoffCsv(points)); !s) return s;
    if (Status s = group.add((out / "presets.csv").string(),
                             presetsCsv((*bundle)->model.contentHash, points));
        !s)
        return s;
    for (const char* file : {"tradeoff.png", "tradeoff.svg"})
        if (Status s = writeTradeoffFigure((out / file).string(), points, group.writer()); !s)
            return s;
    if (Status s = group.commit(); !s) return s;
    printText("{} scenes; the long runs, over all scenes and sampled bins:\n{}\n{}\nwritten to "
              "{}: tradeoff as CSV, "
              "PNG and SVG; presets.csv\n",
              scenes->size(), Lines(references), Lines(tradeoffTable(points)), options.out);
    return Done{};
}

}  // namespace terratact
