#pragma once

#include <QObject>
#include <QString>
#include <QTimer>
#include <memory>
#include <optional>
#include <string>

#include "core/base/message.h"
#include "drivers/stop_line.h"
#include "widgets/signals/event_list.h"

namespace terratact {

/// Returns the path at which this program's console accepts STOP from windows it has opened. It is constant for the
/// process. Its folder below the temporary one is for this user alone, and goes with the process unless that is killed.
/// Empty: the folder could not be made.
const std::string& stopLineName();

/// Environment variable with the line of the console that started this program.
inline constexpr const char* kStopLineVariable = "TERRATACT_STOP_LINE";

/// Sends STOP from a window without a robot to the console that opened it, if any. GUI thread only.
class RemoteStop final : public QObject {
    Q_OBJECT
public:
    explicit RemoteStop(QObject* parent = nullptr);

    bool exists() const { return !line_.empty(); }  ///< a console has opened this program
    /// Sends STOP. reported() gives the result at once, and again when the console has received it or is gone.
    void press();

    static constexpr int kAnswers = 500;  ///< [ms] time limit for the console's answer

signals:
    void reported(const terratact::Message& text, terratact::EventSeverity severity);

private:
    void fail(const Error& error);
    void poll();

    std::string line_;
    std::optional<StopCaller> caller_;
    QTimer timer_;
    int polls_ = 0;
};

}  // namespace terratact
