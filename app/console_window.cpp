#include "app/console_window.h"

#include <QApplication>
#include <QLabel>
#include <QPushButton>
#include <QStackedWidget>
#include <QVBoxLayout>

#include "app/view_menu.h"
#include "widgets/navigation_rail.h"
#include "widgets/status_header.h"

namespace terratact {

ConsoleWindow::ConsoleWindow()
{
    setFocusPolicy(Qt::StrongFocus);  // so that no button has the focus before somebody tabs to it
    resize(1440, 900);
    setMinimumSize(1200, 680);
    header_ = new StatusHeader(this);
    rail_ = new NavigationRail(this);
    pages_ = new QStackedWidget(this);
    connect(rail_, &NavigationRail::pageChosen, pages_, &QStackedWidget::setCurrentIndex);
    connect(header_, &StatusHeader::helpRequested, this, &ConsoleWindow::showHelp);

    right_ = new QVBoxLayout;
    right_->setSpacing(0);
    right_->addWidget(pages_, 1);
    auto* below = new QHBoxLayout;
    below->setSpacing(0);
    below->addWidget(rail_);
    below->addLayout(right_, 1);
    strips_ = new QVBoxLayout;
    strips_->setSpacing(0);
    auto* all = new QVBoxLayout(this);
    all->setContentsMargins(0, 0, 0, 0);
    all->setSpacing(0);
    all->addWidget(header_);
    all->addLayout(strips_);
    all->addLayout(below, 1);
    qApp->installEventFilter(this);
}

QLabel* ConsoleWindow::addStrip(const QString& look)
{
    auto* strip = new QLabel(this);
    strip->setObjectName(look);
    strips_->addWidget(strip);
    return strip;
}

void ConsoleWindow::addPage(QWidget* page, const QString& name, Qt::Key key, const QString& tip)
{
    pages_->addWidget(page);
    rail_->addPage(name, key, tip);
}

QPushButton* ConsoleWindow::addTool(const QString& text, const QString& tip)
{
    auto* button = new QPushButton(text, rail_);
    button->setAccessibleName(text);
    button->setToolTip(tip);
    rail_->addTool(button);
    return button;
}

void ConsoleWindow::addViewTool(PreferenceStore& preferences)
{
    QPushButton* view = addTool(tr("View"), tr("Layout, colours and size of the letters"));
    view->setMenu(new ViewMenu(preferences, view));
}

void ConsoleWindow::addHelpTool()
{
    rail_->addTool(header_->helpButton());
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
                   [this, page] { rail_->choose(page); }});
}

void ConsoleWindow::addHelpKey(const QString& footer)
{
    footer_ = footer;
    keys_.add({{Qt::Key_F1, Qt::Key_Question}, tr("this sheet"), [this] { showHelp(); }});
}

void ConsoleWindow::showHelp()
{
    if (!help_) {
        help_ = new QLabel(this, Qt::Tool);
        help_->setWindowTitle(tr("Keys"));
        help_->setTextFormat(Qt::RichText);
        help_->setMargin(18);
    }
    help_->setText(keys_.html() + footer_);
    help_->resize(help_->sizeHint());  // adjustSize() ends at two thirds of the screen and cuts
    help_->show();
    help_->raise();
}

bool ConsoleWindow::eventFilter(QObject* object, QEvent* event)
{
    return keys_.filter(*this, *object, *event);
}

}  // namespace terratact
