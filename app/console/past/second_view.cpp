#include "app/console/past/second_view.h"

#include <QApplication>
#include <QKeyEvent>
#include <QPushButton>
#include <QScreen>
#include <QTimer>
#include <QVBoxLayout>

#include "app/shell/console_window.h"
#include "widgets/base/palette.h"
#include "widgets/base/plain_label.h"
#include "widgets/base/theme.h"
#include "widgets/control/atem_panel.h"
#include "widgets/terrain/readings/estimate_strip.h"
#include "widgets/terrain/readings/verdict_strip.h"
#include "widgets/terrain/terrain_profile_view.h"

namespace terratact {
namespace {

/// Returns another screen than that of a window; its own if there is no other.
const QScreen* otherScreen(const QWidget& window)
{
    for (const QScreen* screen : QApplication::screens())
        if (screen != window.screen()) return screen;
    return window.screen();
}

}  // namespace

SecondView::SecondView(const RobotModel& robot, const QString& source, QWidget& console)
    : QWidget(&console, Qt::Window)
{
    setWindowTitle(tr("%1 — view only — Terratact").arg(source));
    setAttribute(Qt::WA_ShowWithoutActivating);
    setAutoFillBackground(true);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    banner_ = new PlainLabel(this);
    banner_->setObjectName(QStringLiteral("banner"));
    banner_->setWordWrap(true);
    banner_->hide();
    column->addWidget(banner_);
    page_ = new TerrainPage(robot, this);
    column->addWidget(page_, 1);
    away_ = new QWidget(this);
    away_->hide();
    forbid();
    arrange();
    resize(scaled(1000), scaled(640));
}

/// Takes away what commands the robot or changes what the console shows.
void SecondView::forbid()
{
    page_->atemPanel()->forbidCommands();
    page_->lower()->setParent(away_);
    page_->decisions()->setParent(away_);
    page_->viewButton()->hide();
    page_->terrain()->setFocusPolicy(Qt::StrongFocus);
    const VerdictStrip& verdict = *page_->verdict();
    for (QPushButton* const button : {verdict.raiseButton(), verdict.lowerButton()}) button->hide();
    QPushButton* const cancel = page_->strip()->cancelButton();
    cancel->setEnabled(false);
    cancel->setMaximumSize(0, 0);  // the strip shows it while an estimate runs
}

void SecondView::show(const TerrainViewState& viewState, double stepLimit, double threshold,
                      const QString& banner)
{
    if (threshold != threshold_) page_->setThreshold(threshold);
    threshold_ = threshold;
    if (stepLimit != page_->verdict()->limit()) page_->verdict()->setLimit(stepLimit);
    page_->setViewState(viewState);
    if (banner != banner_->text()) banner_->setText(banner);
    banner_->setVisible(!banner.isEmpty());
}

void SecondView::open()
{
    if (isVisible()) return raise();
    const QScreen* const screen = otherScreen(*parentWidget());
    if (screen && screen != parentWidget()->screen())
        move(screen->availableGeometry().center() - rect().center());
    else if (auto* const console = qobject_cast<ConsoleWindow*>(parentWidget())) {
        setWindowState(windowState() & ~Qt::WindowFullScreen);
        console->putBelowHeader(*this);
    }
    QWidget::show();
}

/// Fills a screen of its own; on the console's screen only the room below the header, which has STOP.
void SecondView::fillScreen()
{
    auto* const console = qobject_cast<ConsoleWindow*>(parentWidget());
    if (!console || screen() != console->screen()) return showFullScreen();
    resize(console->roomBelowHeader());
    console->putBelowHeader(*this);
}

void SecondView::arrange()
{
    page_->arrange(Layout::Review, lookInForce().fontScale);
    page_->lower()->setParent(away_);
    page_->decisions()->setParent(away_);
}

void SecondView::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    // Arranges later, because the style sheet sets the fonts of the parts after this event.
    if (event->type() == QEvent::StyleChange && page_)
        QTimer::singleShot(0, this, [this] { arrange(); });
}

void SecondView::keyPressEvent(QKeyEvent* event)
{
    const bool closes = event->key() == Qt::Key_Escape
                     || (event->key() == Qt::Key_D && event->modifiers() == Qt::ControlModifier);
    if (closes) return void(close());
    if (event->key() == Qt::Key_F11) return isFullScreen() ? showNormal() : fillScreen();
    QWidget::keyPressEvent(event);
}

}  // namespace terratact
