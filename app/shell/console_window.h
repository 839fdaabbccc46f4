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

/// The frame of all windows: a header, strips below it, and a rail beside the visible page. Keys follow the window's
/// key table, which F1 shows.
///
/// The window is never smaller than its content needs and never larger than its screen. The font shrinks until the
/// window fits the screen. If the smallest font is too large, rail and pages scroll; the header with STOP does not.
class ConsoleWindow : public QWidget {
    Q_OBJECT
public:
    StatusHeader* header() const { return header_; }
    NavigationRail* rail() const { return rail_; }
    const KeyTable& keys() const { return keys_; }

    /// Sets the available size [px] instead of the screen's, for pictures without a screen.
    void setRoom(QSize room);
    /// Returns true while the font is being fitted, which takes some turns of the event loop.
    bool isFittingFont() const { return !fits_; }
    /// Ends the fitting at once, if it is under way. Nothing in the window is painted before its end.
    void finishFitting();
    int bannerLine() const;     ///< [px] height of a banner, shown or not
    int bannersHeight() const;  ///< [px] height that shown banners take from the pages
    /// Places another window on this one: below the header with STOP and a banner's line, clamped to the room there.
    void putBelowHeader(QWidget& other);
    /// Returns the room [px] for such a window, without its desktop frame. Ends the fitting of the font first, because
    /// the header changes its height then.
    QSize roomBelowHeader();
    /// Shows a widget below all pages while the window has height to spare. No page gets smaller
    /// than it needs; null: nothing. Its former parent gives it away.
    void setDock(QWidget* docked);
    bool isDockShown() const { return dock_ && dock_->isVisible(); }
    int pagesHeight() const;  ///< [px] of the window without the dock
    /// Adds a strip that states safe mode and how to leave it. Call before the window is shown.
    void showSafeMode();
    /// Closes without asking, as for a signal and for QEvent::Quit.
    void closeUnasked();
    /// [px] minimum size of any window, if its screen is large enough.
    static constexpr QSize kMin{1200, 680};

protected:
    ConsoleWindow();

    /// Returns true if the closing window may ask first.
    bool mayAskBeforeClosing() const { return !unasked_; }

    /// Adds a line over the full width, below earlier ones. look: its name in the style sheet.
    QLabel* addStrip(const QString& look);
    /// Adds a line that appears and disappears; simultaneous banners share one line.
    ElidedLabel* addBanner();
    void addPage(QWidget* page, const QString& name, Qt::Key key, const QString& tip);
    /// Adds a page that scrolls if a large font makes it larger than its room.
    void addScrolledPage(QWidget* page, const QString& name, Qt::Key key, const QString& tip);
    QWidget* currentPage() const;                                   ///< the page as added
    QPushButton* addTool(const QString& text, const QString& tip);  ///< adds a button to the rail
    /// Adds the view menu. newWindow: text on when changes that need a new window take effect.
    void addViewTool(PreferenceStore& preferences, const QString& newWindow);
    /// Adds the help button with the key sheet, the about text, and the demonstrations whose file exists. The order is
    /// one plane, two tracks.
    void addHelpTool(const QStringList& demonstrations = {},
                     const std::function<void(const QString& path)>& open = {});
    void addBelowPages(QWidget* widget);
    QStackedWidget* pages() const { return pages_; }

    KeyTable& keyTable() { return keys_; }
    void addPageKeys();  ///< keys for the pages added so far
    /// Sets a note below the key sheet that applies to all keys.
    void setKeysNote(const QString& note) { keysNote_ = note; }
    void addFullScreenKey();  ///< F11: full screen, and back to the former state
    void addHelpKeys();       ///< F1 and ? show the key sheet, Ctrl+F1 the about text

    /// Adds STOP to a window without a robot. Button and key stop the robot of the console that opened the window, and
    /// a banner reports the result. Without such a console there is no button, and the key shows a notice.
    void addRemoteStop();

    /// Applies the theme. wanted: font scale [%].
    void setLook(ThemeName theme, int wanted);
    /// Returns true if this theme and font scale are those of the last setLook().
    bool hasLook(ThemeName theme, int wanted) const { return theme == theme_ && wanted == wanted_; }
    /// Arranges everything that depends on the font; while it is being fitted, as for the smallest window.
    virtual void arrange() {}
    /// Returns a number that differs between arrangements of different size.
    virtual int arrangement() const { return 0; }

    bool event(QEvent* event) override;
    bool eventFilter(QObject* object, QEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    void showKeys();
    void showAbout();
    void showSheet(TextSheet& sheet);
    bool pressesStopBesidePopup(const QEvent& event) const;
    QLabel* addStrip(QLabel* strip, const QString& look);
    /// Returns what the desktop's frame adds [px]; zero until the desktop has added it.
    QSize frame() const;
    /// Fits the window again after its frame has changed, as on full screen and back.
    void fitToFrame();
    QSize room() const;
    QSize needs() const;  ///< [px] minimum size including a banner, shown or not
    void setLeast(QSize needed);
    void letScroll(bool scrolls);  ///< rail and pages
    QWidget* belowBanners() const;
    void fitFont();  ///< fits the font at once
    /// Fits the font from trying_ down. Each scale takes several turns of the event loop:
    /// font, hidden pages, layout.
    void fitFontInTurns();
    void fitInThisTurn();
    void fitAtOnce();   ///< fits the font from trying_ down; trying_ is applied
    void applyTried();  ///< applies trying_
    /// Lays out with trying_, which is applied. Returns false if it is too large, and sets trying_ to the next scale.
    bool triedFits();
    void layOutAnew();
    int largestToTry() const;
    /// Styles some widgets of pages that were never visible, so that a page opens without delay.
    void prepareSome();
    void keepOnScreen();
    void placeDock();  ///< sizes the dock, or hides it without room

    KeyTable keys_;
    QString keysNote_;
    ThemeName theme_;
    int wanted_;         ///< font scale [%]
    QSize room_;         ///< invalid: the screen's
    QSize frame_{0, 0};  ///< the frame for which the window was fitted last
    bool fits_ = false;  ///< the font is fitted
    int trying_ = 0;     ///< font scale to try [%]
    /// The smallest font scale [%] that was too large, with its conditions; larger ones need no trial.
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
    QScrollArea* scroll_ = nullptr;  ///< null: the content fits
    QBoxLayout* banners_ = nullptr;  ///< side by side
    QBoxLayout* strips_ = nullptr;
    QBoxLayout* right_ = nullptr;
    QWidget* dock_ = nullptr;    ///< below the pages; null: it was never used
    QWidget* docked_ = nullptr;  ///< in the dock; null: nothing
    TextSheet* keySheet_ = nullptr;
    TextSheet* about_ = nullptr;
};

}  // namespace terratact
