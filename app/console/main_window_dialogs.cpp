// Windows that the console's window opens.
#include "app/console/connection/connect_window.h"
#include "app/console/main_window.h"
#include "app/console/pages/settings_page.h"
#include "app/console/settings_files_window.h"
#include "app/display/format.h"
#include "app/recording/session_folder.h"
#include "app/sessions/open_recording.h"
#include "app/shell/dropped_files.h"
#include "app/shell/key_table.h"
#include "app/shell/open_file.h"

namespace terratact {

void MainWindow::addWindowKeys(KeyTable& keys)
{
    openDroppedFiles(*this, [this](const QString& path) {
        openInAnotherWindow(path, sharedStop_->line(), notOpened());
    });
    keys.add({{QKeyCombination(Qt::CTRL, Qt::Key_O)},
              tr("open a session, a log or scenes in another window"),
              [this] { open(); }});
    keys.add({{QKeyCombination(Qt::CTRL, Qt::Key_Comma)},
              tr("profiles, export and import of settings"),
              [this] { showSettingsFiles(); }});
    keys.add({{QKeyCombination(Qt::CTRL, Qt::Key_L)},
              tr("connect to a bus, the simulated robot, a log or a session"),
              [this] { showConnect(); }});
}

void MainWindow::open()
{
    openRecording(*this, recordingsOf(recorder_.get(), *preferences_), sharedStop_->line(),
                  notOpened());
}

std::function<void(const QString&)> MainWindow::notOpened()
{
    return [this](const QString& why) { log(verbatim(why), EventSeverity::Bad); };
}

/// Returns why settings of a file must not come into force; empty: they may.
std::optional<Message> MainWindow::whyNotChangingAll() const
{
    if (auto why = whyNotReopening()) return why;
    using enum RobotActivity;
    const auto moves = [](RobotActivity now) {
        return now == Driving || now == Pressing || now == Probing;
    };
    if (!replayBar_ && moment_.latest && moves(moment_.latest->sample.measurement.activity))
        return TR_NOOP("terratact::MainWindow", "The robot is moving: wait until it stands");
    return std::nullopt;
}

void MainWindow::showConnect()
{
    if (!connectWindow_) {
        const std::string sessions = recorder_ ? recorder_->folder() : sessionFolder();
        connectWindow_ = new ConnectWindow({.inUse = format::sourceName(source_->name()),
                                            .whyNot = [this] { return whyNotChangingAll(); },
                                            .sessions = QString::fromStdString(sessions)},
                                           this);
        connect(connectWindow_, &ConnectWindow::connectionWanted, this,
                [this](const ConnectionWish& wish) {
                    leave();
                    emit connectionWanted(wish);
                });
        connect(connectWindow_, &ConnectWindow::fileWanted, this, [this](const QString& path) {
            openInAnotherWindow(path, sharedStop_->line(), notOpened());
        });
        putBelowHeader(*connectWindow_);
    }
    connectWindow_->show();
    connectWindow_->raise();
    connectWindow_->activateWindow();
}

void MainWindow::showSettingsFiles()
{
    if (!settingsFiles_) {
        settingsFiles_ = new SettingsFilesWindow(
            *preferences_,
            {.folder = preferences_->isSaved() ? profileFolder() : QString(),
             .whyNot = [this] { return whyNotChangingAll(); }},
            this);
        connect(settingsFiles_, &SettingsFilesWindow::applied, this,
                [this](const Message& text) { log(text, EventSeverity::Note); });
        putBelowHeader(*settingsFiles_);
    }
    settingsFiles_->show();
    settingsFiles_->raise();
    settingsFiles_->activateWindow();
}

}  // namespace terratact
