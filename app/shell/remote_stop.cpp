#include "app/shell/remote_stop.h"

#include <QDir>
#include <QTemporaryDir>
#include <cerrno>
#include <memory>
#include <utility>

#include "app/display/format.h"
#include "app/display/translated.h"

namespace terratact {
namespace {

constexpr int kPollAnswer = 20;  // [ms]

/// Makes a folder for a socket, whose path must be short. Null: none of the places allows it.
std::unique_ptr<QTemporaryDir> socketFolder()
{
    // Of 100 bytes, the folder's own name and the socket's name need the rest.
    constexpr int kMaxPlaceBytes = 70;
    for (const QString& place :
         {qEnvironmentVariable("XDG_RUNTIME_DIR"), QDir::tempPath(), QStringLiteral("/tmp")}) {
        if (place.isEmpty() || place.toUtf8().size() > kMaxPlaceBytes) continue;
        auto folder = std::make_unique<QTemporaryDir>(place + QStringLiteral("/terratact-XXXXXX"));
        if (folder->isValid()) return folder;
    }
    return nullptr;
}

}  // namespace

const std::string& stopLineName()
{
    static const std::unique_ptr<QTemporaryDir> kFolder = socketFolder();
    static const std::string kName =
        kFolder ? kFolder->filePath(QStringLiteral("stop")).toStdString() : std::string();
    return kName;
}

RemoteStop::RemoteStop(QObject* parent)
    : QObject(parent), line_(qgetenv(kStopLineVariable).toStdString())
{
    timer_.setInterval(kPollAnswer);
    connect(&timer_, &QTimer::timeout, this, &RemoteStop::poll);
}

void RemoteStop::press()
{
    timer_.stop();
    if (!caller_) {
        auto opened = StopCaller::open();
        if (!opened) return fail(opened.error());
        caller_.emplace(std::move(*opened));
    }
    if (const Status sent = caller_->press(line_); !sent) return fail(sent.error());
    polls_ = 0;
    timer_.start();
    emit reported(
        TR_NOOP("terratact::RemoteStop", "STOP SENT to the console that opened this window …"),
        EventSeverity::Note);
}

void RemoteStop::fail(const Error& error)
{
    Message why(TR_NOOP("terratact::RemoteStop", "STOP NOT SENT: %1"), error.message);
    if (error.code == ECONNREFUSED)
        why = TR_NOOP("terratact::RemoteStop",
                      "STOP HAS NO EFFECT HERE: the console that opened this window is gone");
    if (error.code == ENOENT)  // the console has quit, or its folder was removed: it may still run
        why = Message(TR_NOOP("terratact::RemoteStop",
                              "STOP NOT SENT: the console's stop line was not found at %1; press "
                              "STOP in the console, or use the robot's own switch"),
                      line_);
    emit reported(why, EventSeverity::Bad);
}

void RemoteStop::poll()
{
    if (caller_->isTaken()) {
        timer_.stop();
        emit reported(
            TR_NOOP("terratact::RemoteStop",
                    "STOP: the console that opened this window has received it; look there "
                    "whether the robot confirms it"),
            EventSeverity::Note);
    } else if (++polls_ * kPollAnswer >= kAnswers) {
        timer_.stop();
        emit reported(
            TR_NOOP("terratact::RemoteStop",
                    "STOP NOT RECEIVED: the console that opened this window does not answer; use "
                    "the robot's own switch"),
            EventSeverity::Bad);
    }
}

}  // namespace terratact
