#pragma once

#include <QObject>
#include <thread>

#include "app/display/event_severity.h"
#include "core/base/message.h"
#include "core/robot/robot_model.h"

namespace terratact {

class Exploration;

/// Writes the strip of felt ground of the running drive to a file that the operator names. The file is a picture, a
/// profile or a point cloud (app/figures/report/strip_file.h). It holds the strip at the time of naming the file. A
/// separate thread writes one file at a time, so that the console keeps running. No file is replaced.
class StripExport final : public QObject {
    Q_OBJECT
public:
    /// Both must outlive the object.
    StripExport(const Exploration& exploration, const RobotModel& robot, QWidget& window);

    void ask();  ///< asks for the file, without blocking
    void write(const QString& path);
    bool isWriting() const { return isWriting_; }

signals:
    void refused(const terratact::Message& why);  ///< nothing was written
    void wrote(const terratact::Message& text);

private:
    void finish(const QString& path, const QString& trouble);

    const Exploration& exploration_;
    const RobotModel& robot_;
    QWidget& window_;
    bool isWriting_ = false;
    std::jthread thread_;  // last member: it ends before all others are destroyed
};

}  // namespace terratact
