#pragma once

#include "app/link/robot_file.h"
#include "app/shell/console_window.h"

namespace terratact {

class ImportPage;

/// Makes a session of another program's recording. It has no source, so it cannot command a robot. A made session
/// opens in a window of its own.
class ImportWindow final : public ConsoleWindow {
    Q_OBJECT
public:
    /// folder: where a session is proposed to be written.
    ImportWindow(const QString& file, const RobotFile& robot, const QString& folder);

    ImportPage* page() const { return page_; }

signals:
    void sessionMade(const QString& path);

private:
    ImportPage* page_ = nullptr;
};

}  // namespace terratact
