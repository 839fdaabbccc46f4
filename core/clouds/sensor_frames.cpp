#include "core/clouds/sensor_frames.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/text.h"
#include "core/mapping/recorded_transforms.h"
#include "core/store/file_read.h"

namespace terratact {

Result<SensorFrames> SensorFrames::read(const std::string& base,
                                        const std::vector<std::string>& clouds,
                                        const std::string& topic,
                                        const std::vector<std::string>& others, double maxGap)
{
    SensorFrames frames(base, maxGap);
    frames.transforms_.want(base);
    std::vector<std::string> sensors, files = others;
    for (const std::string& file : clouds) {
        const auto first = readCloudMessages(file, topic, [&](const CloudMessage& cloud) {
            sensors.push_back(cloud.frame);
            frames.transforms_.want(cloud.frame);
            return false;
        });
        if (!first) return first.error();
        if (std::ranges::find(files, file) == files.end()) files.push_back(file);
    }
    for (const std::string& file : files) {
        const auto recording = openRecording(file);
        if (!recording) return recording.error();
        if (Status read = readTransforms(**recording, frames.transforms_); !read)
            return read.error();
    }
    for (std::size_t i = 0; i < sensors.size(); ++i)
        if (!frames.transforms_.joins(base, sensors[i]))
            return fileError(clouds[i],
                             fmt::format("topic {}: /tf_static and /tf hold no transforms from {} "
                                         "to {}; there are: {}; give --sensor-mount instead",
                                         printable(topic), shown(base), shown(sensors[i]),
                                         frames.transforms_.links()));
    return frames;
}

std::optional<CloudPose> SensorFrames::mountOf(const CloudMessage& cloud) const
{
    return transforms_.at(base_, cloud.frame,
                          static_cast<std::int64_t>(std::llround(1e9 * cloud.stamp)));
}

}  // namespace terratact
