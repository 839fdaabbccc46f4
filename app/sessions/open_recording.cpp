#include "app/sessions/open_recording.h"

#include <QWidget>
#include <utility>

#include "app/recording/session_folder.h"
#include "app/recording/session_recorder.h"
#include "app/shell/open_file.h"

namespace terratact {

BrowserWish recordingsOf(const SessionRecorder* recorder, PreferenceStore& store)
{
    BrowserWish wish{.folder =
                         QString::fromStdString(recorder ? recorder->folder() : sessionFolder()),
                     .store = &store};
    if (!recorder) return wish;
    if (RecordingState state = recorder->state(); state.recording)
        wish.recorded = std::move(state.path);
    return wish;
}

void openRecording(QWidget& parent, BrowserWish wish, const std::string& stopLine,
                   const std::function<void(const QString& why)>& failed)
{
    wish.opens = [stopLine, failed](const QString& path) {
        openInAnotherWindow(path, stopLine, failed);
    };
    wish.asksForFile = [&parent, folder = wish.folder, stopLine, failed] {
        askAndOpenInAnotherWindow(parent, folder, stopLine, failed);
    };
    browseSessions(parent, std::move(wish));
}

}  // namespace terratact
