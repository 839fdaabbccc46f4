#pragma once

#include <QObject>
#include <QString>
#include <QTimer>
#include <memory>
#include <optional>
#include <string>

#include "drivers/stop_line.h"
#include "widgets/signals/event_list.h"

namespace terratact {

/// Under which name this program's console, where it commands a robot, takes STOP from windows that it has opened; the
/// same for as long as the program runs.
const std::string& stopLineName();

/// The variable of the environment that tells a program the line of the console that has started it.
inline constexpr const char* kStopLineVariable = "TERRATACT_STOP_LINE";

/// STOP from a window without a robot: to the console that has opened it, where one has.  GUI thread only.
class RemoteStop final : public QObject {
    Q_OBJECT
public:
    explicit RemoteStop(QObject* parent = nullptr);

    bool exists() const { return !line_.empty(); }  ///< a console has opened this program
    /// Sends STOP; said() tells at once what became of it, and again when the console has taken it or has not.
    void press();

    static constexpr int kAnswers = 500;  ///< [ms] the console has to take it

signals:
    void said(const QString& text, terratact::Weight weight);

private:
    void fail(const Error& error);
    void poll();

    std::string line_;
    std::optional<StopCaller> caller_;
    QTimer look_;
    int looks_ = 0;
};

}  // namespace terratact
