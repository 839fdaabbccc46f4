#pragma once

#include <memory>

#include "core/clouds/cloud_file.h"
#include "core/clouds/cloud_reader.h"

namespace terratact {

// Readers of single formats; openCloud() chooses. `file` is at its beginning.

Result<std::unique_ptr<CloudReader>> openPcd(CloudFile file);
Result<std::unique_ptr<CloudReader>> openPly(CloudFile file);
Result<std::unique_ptr<CloudReader>> openTextCloud(CloudFile file);

}  // namespace terratact
