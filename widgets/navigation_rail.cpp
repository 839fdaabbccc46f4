#include "widgets/navigation_rail.h"

#include <QKeySequence>
#include <QPushButton>
#include <QVBoxLayout>

namespace terratact {

NavigationRail::NavigationRail(QWidget* parent) : QFrame(parent)
{
    setObjectName(QStringLiteral("navigationRail"));
    setAccessibleName(tr("Pages"));
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Preferred);  // the longest name fits
    column_ = new QVBoxLayout(this);
    column_->setContentsMargins(6, 10, 6, 10);
    column_->setSpacing(6);
    column_->addStretch(1);
}

void NavigationRail::addPage(const QString& name, Qt::Key key, const QString& tip)
{
    const int page = pages();
    const QString keyName = QKeySequence(key).toString(QKeySequence::NativeText);
    auto* button = new QPushButton(name + QLatin1Char('\n') + keyName, this);
    button->setProperty("role", "page");
    button->setCheckable(true);
    button->setFocusPolicy(Qt::TabFocus);
    button->setAccessibleName(name);
    button->setToolTip(tip);
    column_->insertWidget(page, button);
    buttons_ << button;
    keys_ << key;
    connect(button, &QPushButton::clicked, this, [this, page] { choose(page); });
    if (chosen_ < 0) choose(page);
}

void NavigationRail::choose(int page)
{
    if (page < 0 || page >= pages()) return;
    for (int i = 0; i < pages(); ++i) buttons_[i]->setChecked(i == page);
    if (page == chosen_) return;
    chosen_ = page;
    emit pageChosen(page);
}

void NavigationRail::addTool(QPushButton* button)
{
    button->setParent(this);
    button->setFocusPolicy(Qt::TabFocus);
    column_->addWidget(button);
}

int NavigationRail::pageOf(int key) const
{
    return static_cast<int>(keys_.indexOf(key));
}

}  // namespace terratact
