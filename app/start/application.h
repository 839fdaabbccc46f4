#pragma once

#include <QApplication>
#include <optional>
#include <string>

#include "app/shell/preferences/preferences.h"
#include "app/start/console_options.h"
#include "core/base/result.h"

namespace terratact {

class ConsoleWindow;

/// A QApplication that ends in order if an event handler of its thread throws. Qt forbids exceptions through its event
/// loop. notify() prints describeFailure() of the first std::exception and delivers no further event; exec() returns
/// EXIT_FAILURE. The windows are then destroyed as usual: the robot is halted and the recording closed. Outside exec()
/// and in other threads the exception propagates.
class GuardedApplication final : public QApplication {
public:
    using QApplication::QApplication;
    bool notify(QObject* receiver, QEvent* event) override;

private:
    bool hasFailed_ = false;
};

/// Creates the QApplication only when the first window opens, so that earlier errors need no display.
class Application {
public:
    /// The arguments are QApplication's and must outlive it.
    Application(int& argc, char** argv) : argc_(argc), argv_(argv) {}

    /// Creates the application with the preferred language and theme. `pictures`: without a display.
    Status start(const Preferences& preferences, bool pictures);

private:
    int& argc_;
    char** argv_;
    std::optional<GuardedApplication> application_;
};

/// Shows a window with the reason that no other opens, until it is closed. file: the file to open, or empty. Call after
/// Application::start().
void printRefusal(const std::string& file, const Message& why);

/// Shows a window in the size of the command line, else as last saved (QWidget::saveGeometry()), else in a default
/// size. SIGTERM and similar signals close it without asking: the robot is halted and the recording closed.
void showWindow(ConsoleWindow& window, const ConsoleOptions& options, const QByteArray& left = {});

}  // namespace terratact
