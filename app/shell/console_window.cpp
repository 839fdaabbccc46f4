#include "app/shell/console_window.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QFileInfo>
#include <QKeySequence>
#include <QLabel>
#include <QMenu>
#include <QMouseEvent>
#include <QPushButton>
#include <QScreen>
#include <QScrollArea>
#include <QShowEvent>
#include <QStackedWidget>
#include <QTimer>
#include <QVBoxLayout>
#include <QWindow>
#include <algorithm>
#include <array>
#include <utility>

#include "app/display/translated.h"
#include "app/runtime/vector_registers.h"
#include "app/shell/about.h"
#include "app/shell/preferences/preferences.h"
#include "app/shell/remote_stop.h"
#include "app/shell/text_sheet.h"
#include "app/shell/view_menu.h"
#include "widgets/base/calm_wheel.h"
#include "widgets/base/elided_label.h"
#include "widgets/base/hidden_pages.h"
#include "widgets/base/navigation_rail.h"
#include "widgets/base/plain_label.h"
#include "widgets/base/theme.h"
#include "widgets/base/tips.h"
#include "widgets/control/status_header.h"

namespace terratact {
namespace {

const QString kPageArea = QStringLiteral("pageArea");
constexpr QKeyCombination kKeysKey(Qt::Key_F1), kAboutKey(Qt::CTRL, Qt::Key_F1);
constexpr int kAboutWide = 620;    // [px] at 100 %
constexpr int kPrepareEvery = 20;  // [ms]

/// A row that scrolls at its least height. With a height for its width, a scroll area would give it the preferred one.
class LeastRow final : public QHBoxLayout {
public:
    using QHBoxLayout::QHBoxLayout;
    bool hasHeightForWidth() const override { return false; }
};

}  // namespace

ConsoleWindow::ConsoleWindow() : theme_(lookInForce().theme), wanted_(lookInForce().fontScale)
{
    setFocusPolicy(Qt::StrongFocus);  // keeps the focus off the buttons until the user presses Tab
    resize(1440, 900);
    setMinimumSize(kMin);
    header_ = new StatusHeader(this);
    rail_ = new NavigationRail(this);
    pages_ = new QStackedWidget(this);
    connect(rail_, &NavigationRail::pageChosen, this, [this](int page) {
        styleHiddenPage(*pages_->widget(page));
        pages_->setCurrentIndex(page);
    });

    right_ = new QVBoxLayout;
    right_->setSpacing(0);
    right_->addWidget(pages_, 1);
    below_ = new QWidget(this);
    auto* below = new LeastRow(below_);
    below->setContentsMargins(0, 0, 0, 0);
    below->setSpacing(0);
    below->addWidget(rail_);
    below->addLayout(right_, 1);
    strips_ = new QVBoxLayout;
    strips_->setSpacing(0);
    banners_ = new QHBoxLayout;
    banners_->setSpacing(0);
    strips_->addLayout(banners_);
    auto* all = new QVBoxLayout(this);
    all->setContentsMargins(0, 0, 0, 0);
    all->setSpacing(0);
    all->addWidget(header_);
    all->addLayout(strips_);
    all->addWidget(below_, 1);
    // STOP's keys must work in every dialog, so dialogs are Qt's, not the desktop's.
    QCoreApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
    qApp->installEventFilter(this);
    qApp->installEventFilter(new CalmWheel(this));
    connect(&prepare_, &QTimer::timeout, this, &ConsoleWindow::prepareSome);
    tryLater_.setSingleShot(true);
    connect(&tryLater_, &QTimer::timeout, this, &ConsoleWindow::fitInThisTurn);
}

QLabel* ConsoleWindow::addStrip(const QString& look)
{
    return addStrip(new PlainLabel(this), look);
}

QLabel* ConsoleWindow::addStrip(QLabel* strip, const QString& look)
{
    strip->setObjectName(look);
    strips_->addWidget(strip);
    return strip;
}

void ConsoleWindow::showSafeMode()
{
    QLabel* strip = addStrip(new ElidedLabel(this), QStringLiteral("safeStrip"));
    strip->setText(tr("SAFE MODE: default settings; none are read or saved · start without "
                      "--safe-mode to leave it"));
}

void ConsoleWindow::closeUnasked()
{
    unasked_ = true;
    close();
}

ElidedLabel* ConsoleWindow::addBanner()
{
    auto* banner = new ElidedLabel(this);
    banner->setObjectName(QStringLiteral("banner"));
    banner->hide();
    banners_->addWidget(banner, 1);
    return banner;
}

void ConsoleWindow::addPage(QWidget* page, const QString& name, Qt::Key key, const QString& tip)
{
    pages_->addWidget(page);
    rail_->addPage(name, key, tip);
}

void ConsoleWindow::addScrolledPage(QWidget* page, const QString& name, Qt::Key key,
                                    const QString& tip)
{
    auto* area = new QScrollArea(this);
    area->setObjectName(kPageArea);
    area->setFrameShape(QFrame::NoFrame);
    area->setWidgetResizable(true);
    area->setFocusPolicy(Qt::NoFocus);
    area->setWidget(page);
    addPage(area, name, key, tip);
}

QWidget* ConsoleWindow::currentPage() const
{
    QWidget* const shown = pages_->currentWidget();
    const auto* const area = qobject_cast<QScrollArea*>(shown);
    return area && area->objectName() == kPageArea ? area->widget() : shown;
}

QPushButton* ConsoleWindow::addTool(const QString& text, const QString& tip)
{
    auto* button = new QPushButton(text, rail_);
    button->setAccessibleName(text);
    setTip(*button, tip);
    rail_->addTool(button);
    return button;
}

void ConsoleWindow::addViewTool(PreferenceStore& preferences, const QString& newWindow)
{
    QPushButton* view = addTool(tr("View"), tr("Layout, colours and font size"));
    view->setMenu(new ViewMenu(preferences, newWindow, view));
}

void ConsoleWindow::addHelpTool(const QStringList& demonstrations,
                                const std::function<void(const QString& path)>& open)
{
    QPushButton* help = addTool(tr("Help\nF1"), tr("All keys, and about this program"));
    help->setAccessibleName(tr("Help"));
    help->setObjectName(QStringLiteral("help"));
    auto* menu = new QMenu(help);
    const auto offer = [this, menu](const QString& text, QKeyCombination key,
                                    void (ConsoleWindow::*shows)()) {
        const QString keys = QKeySequence(key).toString(QKeySequence::NativeText);
        connect(menu->addAction(text + QLatin1Char('\t') + keys), &QAction::triggered, this, shows);
    };
    offer(tr("Keys"), kKeysKey, &ConsoleWindow::showKeys);
    offer(tr("About Terratact"), kAboutKey, &ConsoleWindow::showAbout);
    const std::array titles{tr("Recorded demonstration"), tr("Recorded demonstration, two tracks")};
    for (qsizetype k = 0; k < std::min<qsizetype>(demonstrations.size(), 2); ++k)
        if (const QString& path = demonstrations[k]; QFileInfo::exists(path))
            connect(menu->addAction(titles.at(static_cast<std::size_t>(k))), &QAction::triggered,
                    this, [path, open] { open(path); });
    help->setMenu(menu);
}

void ConsoleWindow::addBelowPages(QWidget* widget)
{
    right_->addWidget(widget);
}

void ConsoleWindow::addPageKeys()
{
    for (int page = 0; page < rail_->pages(); ++page)
        keys_.add({{static_cast<Qt::Key>(rail_->keyOf(page))},
                   rail_->button(page)->accessibleName(),
                   [this, page] {
                       // A page that is no longer offered is replaced by the first page.
                       rail_->choose(rail_->button(page)->isHidden() ? 0 : page);
                   }});
}

void ConsoleWindow::addFullScreenKey()
{
    keys_.add({{Qt::Key_F11}, tr("full screen, and back"), [this] {
                   setWindowState(windowState() ^ Qt::WindowFullScreen);
               }});
}

void ConsoleWindow::addHelpKeys()
{
    keys_.add({{kKeysKey, Qt::Key_Question}, tr("this sheet"), [this] { showKeys(); }});
    keys_.add({{kAboutKey}, tr("what this program is"), [this] { showAbout(); }});
}

void ConsoleWindow::addRemoteStop()
{
    constexpr int kFor = 8000;  // [ms]
    auto* banner = new PlainLabel(this);
    banner->setObjectName(QStringLiteral("banner"));
    banner->setWordWrap(true);
    banner->hide();
    auto* end = new QTimer(banner);
    end->setSingleShot(true);
    end->setInterval(kFor);
    connect(end, &QTimer::timeout, banner, &QWidget::hide);
    const auto showOn = [this, banner, end](const Message& text) {
        banner->setText(translated(text));
        QRect place = header_->geometry();  // on top of the header, so that nothing moves
        if (const QPushButton& stop = *header_->stopButton(); stop.isVisible())
            place.setRight(place.left() + stop.x()
                           - 1);  // STOP stays free, because it may be needed again
        banner->setGeometry(place);
        banner->raise();
        banner->show();
        end->start();
    };
    auto* remote = new RemoteStop(this);
    connect(remote, &RemoteStop::reported, banner, showOn);
    header_->setStop({.state = StopViewState::State::Elsewhere});
    header_->stopButton()->setVisible(remote->exists());
    connect(header_, &StatusHeader::stopPressed, remote, &RemoteStop::press);
    keys_.add({.keys = kStopKeys,
               .meaning = remote->exists()
                            ? tr("Sends STOP through the console that opened this window")
                            : tr("no STOP: this window has no robot"),
               .pressed =
                   [remote, showOn] {
                       if (remote->exists()) return remote->press();
                       showOn(TR_NOOP("terratact::ConsoleWindow",
                                      "STOP HAS NO EFFECT HERE: this window has no robot. Use the "
                                      "console's own window"));
                   },
               .everywhere = true});
}

void ConsoleWindow::showKeys()
{
    if (!keySheet_) keySheet_ = new TextSheet(tr("Keys"), {Qt::Key_F1, Qt::Key_Question}, this);
    QString html = keys_.html();
    for (const QString& line : {keysNote_, aboutLine()})
        if (!line.isEmpty()) html += QStringLiteral("<p>%1</p>").arg(line.toHtmlEscaped());
    keySheet_->setText(html, roomBelowHeader());
    showSheet(*keySheet_);
}

void ConsoleWindow::showAbout()
{
    if (!about_) {
        about_ = new TextSheet(tr("About Terratact"), {Qt::Key_F1}, this);
        about_->setObjectName(QStringLiteral("about"));
    }
    about_->setText(aboutHtml(), roomBelowHeader(), scaled(kAboutWide));
    showSheet(*about_);
}

void ConsoleWindow::showSheet(TextSheet& sheet)
{
    putBelowHeader(sheet);
    sheet.show();
    sheet.raise();
    sheet.activateWindow();
}

bool ConsoleWindow::event(QEvent* event)
{
    const bool done = QWidget::event(event);
    if (event->type() == QEvent::UpdateRequest)
        clearUpperVectorHalves();  // painting leaves them in use
    if (event->type() == QEvent::Resize && fits_) placeDock();
    fitToFrame();
    if (event->type() != QEvent::LayoutRequest || !fits_) return done;
    placeDock();
    const QSize needed = needs();
    if (needed.expandedTo(size()) == size()) return done;
    // The content needs more than the fitted size.
    const bool isSmallest = lookInForce().fontScale <= kSmallestFont;
    if (needed.expandedTo(room()) != room() && !isSmallest) {
        trying_ = largestToTry();
        fitFontInTurns();
    } else {
        setLeast(needed.expandedTo(minimumSize()));
    }
    return done;
}

void ConsoleWindow::prepareSome()
{
    constexpr qint64 kBudget = 5;  // [ms] too short to notice
    QElapsedTimer since;
    since.start();
    while (!unprepared_.isEmpty() && since.elapsed() < kBudget)
        if (QWidget* const widget = unprepared_.takeLast()) widget->ensurePolished();
    if (unprepared_.isEmpty()) prepare_.stop();
}

void ConsoleWindow::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    if (!prepare_.isActive() && !event->spontaneous()) {
        for (QWidget* widget : pages_->findChildren<QWidget*>())
            if (!widget->isVisible()) unprepared_ << widget;
        prepare_.start(kPrepareEvery);
    }
    if (event->spontaneous() || fits_) return;
    const auto refit = [this] { QTimer::singleShot(0, this, &ConsoleWindow::fitFont); };
    const auto watch = [this, refit](const QScreen* screen) {
        connect(screen, &QScreen::availableGeometryChanged, this, refit);
    };
    connect(windowHandle(), &QWindow::screenChanged, this, [watch, refit](const QScreen* screen) {
        watch(screen);
        refit();
    });
    watch(screen());
    fitFont();
    refit();  // once the frame size is known
}

/// An open menu takes the mouse: a press elsewhere only closes it. This detects a press on STOP beside the menu.
bool ConsoleWindow::pressesStopBesidePopup(const QEvent& event) const
{
    const QWidget* popup = QApplication::activePopupWidget();
    if (event.type() != QEvent::MouseButtonPress || !popup) return false;
    const auto& mouse = static_cast<const QMouseEvent&>(event);
    if (popup->geometry().contains(mouse.globalPosition().toPoint()))
        return false;  // the press is inside the menu
    const QPushButton& stop = *header_->stopButton();
    return mouse.button() == Qt::LeftButton && stop.isVisible()
        && stop.rect().contains(stop.mapFromGlobal(mouse.globalPosition().toPoint()));
}

bool ConsoleWindow::eventFilter(QObject* object, QEvent* event)
{
    if (object == qApp && event->type() == QEvent::Quit)
        unasked_ = true;  // Quit closes all windows
    if (object->isWidgetType() && pressesStopBesidePopup(*event)) {
        emit header_->stopPressed();
        while (QWidget* const popup = QApplication::activePopupWidget()) {
            popup->setAttribute(Qt::WA_NoMouseReplay);  // the press was already delivered to STOP
            if (!popup->close()) break;
        }
        return true;
    }
    return keys_.filter(*this, *object, *event);
}

}  // namespace terratact
