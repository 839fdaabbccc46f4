#pragma once

#include <QList>
#include <QPointer>
#include <QSize>
#include <QTimer>
#include <QWidget>
#include <functional>
#include <optional>

#include "app/shell/key_table.h"
#include "widgets/base/palette.h"

class QBoxLayout;
class QLabel;
class QPushButton;
class QScrollArea;
class QStackedWidget;

namespace terratact {

class ElidedLabel;
class NavigationRail;
class PreferenceStore;
class StatusHeader;
class TextSheet;

/// The frame of the program's windows: the header, strips below it, and the rail beside the pages, of which one
/// is seen.  Keys do what the table of the window says, which F1 shows.
///
/// It is never smaller than what it shows needs, and never larger than its screen: there the letters are as large as
/// they can be, which may be smaller than the wanted ones.  Where the smallest are too large, rail and pages scroll;
/// the header with STOP does not.
class ConsoleWindow : public QWidget {
    Q_OBJECT
public:
    StatusHeader* header() const { return header_; }
    NavigationRail* rail() const { return rail_; }
    const KeyTable& keys() const { return keys_; }

    /// Room for the window [px] instead of its screen's, for a picture that needs no screen.
    void setRoom(QSize room);
    /// The letters are being fitted, which may take some turns of the event loop.
    bool isMeasured() const { return !fits_; }
    int bannerLine() const;   ///< [px] that banners need, whether there are any or not
    int bannersTake() const;  ///< [px] that they take from the pages now
    /// Another window's place upon this one: below the header with STOP and a banner's line, and no larger than what is
    /// left there.
    void putBelowHeader(QWidget& other) const;
    QSize roomBelowHeader() const;  ///< [px] for such a window, without the frame the desktop draws
    /// From now on a thin line says so, and how to leave it.  Before the window is shown.
    void saySafeMode();
    /// As a signal wants it, and the end of the application (QEvent::Quit), which wait for no answer.
    void closeUnasked();
    /// [px] of any window, where its screen has that much.
    static constexpr QSize kMin{1200, 680};

protected:
    ConsoleWindow();

    /// The window, which is to be closed, may ask first.
    bool mayAskBeforeClosing() const { return !unasked_; }

    /// A line over the whole width, below those added before.  look: its name in the style sheet.
    QLabel* addStrip(const QString& look);
    /// A line that comes and goes; those that are there at once share one.
    ElidedLabel* addBanner();
    void addPage(QWidget* page, const QString& name, Qt::Key key, const QString& tip);
    /// One that large letters may make larger than its room: then it scrolls.
    void addScrolledPage(QWidget* page, const QString& name, Qt::Key key, const QString& tip);
    QWidget* currentPage() const;                                   ///< as it was added
    QPushButton* addTool(const QString& text, const QString& tip);  ///< to the rail
    /// newWindow: when what needs a new window gets one, in words.
    void addViewTool(PreferenceStore& preferences, const QString& newWindow);
    /// The sheet of the keys, what this program is, and a demonstration to open, where there is that file.
    void addHelpTool(const QString& demonstration = {},
                     std::function<void(const QString& path)> open = {});
    void addBelowPages(QWidget* widget);
    QStackedWidget* pages() const { return pages_; }

    KeyTable& keyTable() { return keys_; }
    void addPageKeys();  ///< of the pages there are
    /// Below the keys in their sheet: what must be known of all of them.
    void setKeysNote(const QString& note) { keysNote_ = note; }
    void addHelpKeys();  ///< F1 and ? show the sheet of the keys, Ctrl+F1 what this program is

    /// For a window without a robot: STOP, button and key, stops that of the console that opened the window, and says
    /// what became of it, loudly.  Without one there is no button, and the key says so.
    void addRemoteStop();

    /// The look from now on; wanted: letters [%].
    void setLook(ThemeName theme, int wanted);
    /// Lays out anew what depends on the letters in force, and as for the smallest window while it is measured.
    virtual void arrange() {}
    /// Another for another arrangement, which may need another room.
    virtual int arrangement() const { return 0; }

    bool event(QEvent* event) override;
    bool eventFilter(QObject* object, QEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    void showKeys();
    void showAbout();
    void showSheet(TextSheet& sheet) const;
    bool pressesStopBesidePopup(const QEvent& event) const;
    QLabel* addStrip(QLabel* strip, const QString& look);
    QSize room() const;
    QSize needs() const;  ///< [px] with a banner, whether there is one or not
    void setLeast(QSize needed);
    void letScroll(bool scrolls);  ///< rail and pages
    QWidget* belowBanners() const;
    void fitLetters();  ///< at once
    void
    fitLettersInTurns();  ///< those of trying_, smaller ones each in a later turn of the event loop
    bool tryLetters();  ///< those of trying_; false: they are too large, and it is what to try next
    void layOutAnew();
    int largestToTry() const;
    /// Styles some widgets of pages that were never seen, so that a page is there at once when it is first chosen.
    void prepareSome();
    void keepOnScreen();

    KeyTable keys_;
    QString keysNote_;
    ThemeName theme_;
    int wanted_;         ///< letters [%]
    QSize room_;         ///< invalid: the screen's
    bool fits_ = false;  ///< the letters have been fitted
    int trying_ = 0;     ///< letters [%] to try
    /// The smallest letters [%] that were too large, and for what: larger ones need not be tried.
    struct TooLarge {
        int percent;
        QSize room;
        int arrangement;
    };
    std::optional<TooLarge> tooLarge_;
    QTimer prepare_, tryLater_;
    QList<QPointer<QWidget>> unprepared_;
    bool unasked_ = false;

    // Qt's parents own the widgets.
    StatusHeader* header_ = nullptr;
    NavigationRail* rail_ = nullptr;
    QStackedWidget* pages_ = nullptr;
    QWidget* below_ = nullptr;       ///< rail and pages
    QScrollArea* scroll_ = nullptr;  ///< null: they have their room
    QBoxLayout* banners_ = nullptr;  ///< side by side
    QBoxLayout* strips_ = nullptr;
    QBoxLayout* right_ = nullptr;
    TextSheet* keySheet_ = nullptr;
    TextSheet* about_ = nullptr;
};

}  // namespace terratact
