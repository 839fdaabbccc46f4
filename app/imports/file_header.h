#pragma once

#include <QString>

namespace terratact {

class StatusHeader;

/// Shows in a window's header that it has a file and no robot: no link, robot, model, arming, quality and alarms.
void showFileHeader(StatusHeader& header, const QString& source);

}  // namespace terratact
