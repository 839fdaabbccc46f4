#pragma once

#include <optional>
#include <string>

#include "app/shell/console_options.h"
#include "app/shell/preferences.h"
#include "app/shell/watched_application.h"
#include "core/base/result.h"

namespace terratact {

class ConsoleWindow;

/// The QApplication, made when the first window is to be opened: what is wrong before is told without a display.
class Application {
public:
    /// Both are QApplication's, and outlive it.
    Application(int& argc, char** argv) : argc_(argc), argv_(argv) {}

    /// The application in the language and look preferred; `pictures`: without a display.
    Status start(const Preferences& preferences, bool pictures);

private:
    int& argc_;
    char** argv_;
    std::optional<WatchedApplication> application_;
};

/// Says in a window why there will be no other, until that is closed.  file: that was to be opened, or empty.  Not before
/// Application::start().
void tellRefusal(const std::string& file, const std::string& why);

/// Shows a window in the size that the command line says, else as it was left (QWidget::saveGeometry()), else in a
/// usual one.  A polite signal closes it as its user would, and unasked: the robot is halted and the recording closed.
void showWindow(ConsoleWindow& window, const ConsoleOptions& options, const QByteArray& left = {});

}  // namespace terratact
