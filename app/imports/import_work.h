#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <cstdint>
#include <functional>
#include <stop_token>
#include <string>
#include <thread>

#include "app/link/robot_file.h"
#include "app/recording/recording_import.h"
#include "core/base/message.h"

namespace terratact {

/// Reads a recording of another program in a thread of its own: one job at a time; a new one cancels the former. The
/// destructor cancels. GUI thread only; the signals arrive there.
class ImportWork final : public QObject {
    Q_OBJECT
public:
    ImportWork(std::string file, RobotFile robot, QObject* parent = nullptr);
    ~ImportWork() override;

    void survey();  ///< ends with surveyed() or failed()
    void
    check(const std::string& mapping);  ///< ends with checked() or failed(); the text of a mapping
    /// Writes a session; ends with imported() or failed(), or with cancelled() and no session.
    void import(const std::string& mapping, const std::string& out);
    void cancel();
    bool isBusy() const { return busy_; }

signals:
    void progressed(int percent, quint64 messages);  ///< percent: -1 where it is not known
    void surveyed(const QString& text, const QString& mapping);
    void checked(const QStringList& doubts);
    void imported(const QString& session, const terratact::ImportedSession& report);
    void failed(const QString& why);
    void cancelled();

private:
    /// Runs a job in the thread; it returns what is emitted at its end.
    using Job = std::function<std::function<void()>(const RecordingWatch& watch)>;
    std::function<void()> refusal(Message why);
    void start(Job job);
    void finish(int job, const std::function<void()>& news);
    RecordingWatch watchOf(const std::stop_token& stop);

    std::string file_;
    RobotFile robot_;
    std::uint64_t bytes_ = 0;  ///< of the file, if its places are bytes
    bool busy_ = false;
    int job_ = 0;
    std::jthread thread_;  // last member: it ends before all others are destroyed
};

}  // namespace terratact
