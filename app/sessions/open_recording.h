#pragma once

#include <functional>
#include <string>

#include "app/sessions/session_browser.h"

namespace terratact {

class SessionRecorder;

/// Returns what the browser of a console needs: the folder and the file of its recorder. recorder: null: none.
BrowserWish recordingsOf(const SessionRecorder* recorder, PreferenceStore& store);

/// Shows the browser of recordings. The chosen recording, or another file of a file dialog, opens in
/// a separate process (app/shell/open_file.h). stopLine, failed: as there.
void openRecording(QWidget& parent, BrowserWish wish, const std::string& stopLine,
                   const std::function<void(const QString& why)>& failed);

}  // namespace terratact
