#include "app/modelling/training/training_files.h"

#include "core/learn/data/scene_file.h"
#include "core/learn/data/two_track_scene_file.h"
#include "core/store/sha256.h"

namespace terratact {
namespace {

/// Adds the scenes of one more file.
template <class File, class SceneType>
void addFile(const File& file, const std::string& hash, TrainingScenes<SceneType>& all,
             const NoticeReport& report)
{
    for (const Message& notice : file.notices) report(notice);
    all.begins.push_back(all.scenes.size());
    all.scenes.insert(all.scenes.end(), file.scenes.begin(), file.scenes.end());
    all.hash += hash;
}

}  // namespace

Result<TrainingScenes<Scene>> readPlanes(const std::vector<std::string>& files,
                                         const NoticeReport& report)
{
    TrainingScenes<Scene> all;
    for (const std::string& path : files) {
        auto file = readScenes(path);
        if (!file) return file.error();
        addFile(*file, file->hash, all, report);
    }
    if (files.size() > 1) all.hash = sha256Hex(all.hash);
    return all;
}

Result<TrainingScenes<TwoTrackScene>> readTracks(const std::vector<std::string>& files,
                                                 const NoticeReport& report)
{
    TrainingScenes<TwoTrackScene> all;
    for (const std::string& path : files) {
        auto hash = sha256OfFile(path);
        if (!hash) return hash.error();
        auto file = readTwoTrackScenes(path);
        if (!file) return file.error();
        addFile(*file, *hash, all, report);
    }
    if (files.size() > 1) all.hash = sha256Hex(all.hash);
    return all;
}

}  // namespace terratact
