#pragma once

#include <QDialog>
#include <functional>
#include <memory>

#include "app/sessions/session_reading.h"

class QLabel;
class QLineEdit;
class QPushButton;

namespace terratact {

class PreferenceStore;
class SearchedSessions;
class SessionDetails;
class SessionList;
class SessionListView;

/// What a window that opens recordings knows.
struct BrowserWish {
    QString folder;                    ///< shown if the operator has chosen none, or it is gone
    std::string recorded{};            ///< file that this program is recording; empty: none
    PreferenceStore* store = nullptr;  ///< remembers the folder; must outlive the browser
    /// Called with the chosen recording; the browser closes then.
    std::function<void(const QString& path)> opens = {};
    std::function<void()> asksForFile = {};  ///< asks for any other file with a file dialog
};

/// Window with the recordings of a folder. It blocks no other window. A thread reads the files, each for reading only;
/// closing ends it. Enter opens the chosen recording, / goes to the search, Esc closes.
class SessionBrowser final : public QDialog {
    Q_OBJECT
public:
    SessionBrowser(BrowserWish wish, QWidget* parent);
    ~SessionBrowser() override;

    void showFolder(const QString& folder);
    const QString& folder() const { return folder_; }

    SessionListView* table() const { return table_; }
    QLineEdit* searchEdit() const { return search_; }
    QPushButton* openButton() const { return open_; }
    QPushButton* otherButton() const { return other_; }
    QPushButton* folderButton() const { return choose_; }
    QLabel* stateLabel() const { return state_; }
    SessionDetails* details() const { return details_; }
    const SearchedSessions& sessions() const { return *sessions_; }
    bool isRead() const { return read_.ended; }  ///< every file was read

protected:
    bool eventFilter(QObject* object, QEvent* event) override;

private:
    QWidget* top();
    QWidget* buttons();
    void consume();
    void chooseFirst();
    void showState();
    void showChosen();
    void openChosen();
    void chooseFolder();

    BrowserWish wish_;
    QString folder_;
    bool follows_ = true;        ///< the choice stays at the first row
    bool choosesFirst_ = false;  ///< the program is choosing a row, not the operator
    SessionReading::News read_;  ///< without the sessions
    std::unique_ptr<SessionReading> reading_;

    // Qt's parents own these.
    SessionList* list_ = nullptr;
    SearchedSessions* sessions_ = nullptr;
    QLineEdit* search_ = nullptr;
    QLabel* where_ = nullptr;
    SessionListView* table_ = nullptr;
    QLabel* state_ = nullptr;
    SessionDetails* details_ = nullptr;
    QPushButton* open_ = nullptr;
    QPushButton* other_ = nullptr;
    QPushButton* choose_ = nullptr;
};

/// Shows the browser of a window below its header, so that STOP can be clicked. It is made here, and deleted when it is
/// closed. If it is open, it is raised instead.
void browseSessions(QWidget& parent, BrowserWish wish);

}  // namespace terratact
