#include "widgets/base/navigation_rail.h"

#include <QApplication>
#include <QEvent>
#include <QFontMetrics>
#include <QKeySequence>
#include <QPushButton>
#include <QStyle>
#include <QVBoxLayout>
#include <algorithm>

#include "widgets/base/palette.h"
#include "widgets/base/style_sheet.h"
#include "widgets/base/tips.h"

namespace terratact {
namespace {

constexpr int kSpacing = 6, kDenseSpacing = 3;  // [px] between two buttons
constexpr int kHeight = 40, kDenseHeight = 26,
              kPadding = 8;  // [px] of one button, equal to the style sheet

QString keyText(Qt::Key key)
{
    return QKeySequence(key).toString(QKeySequence::NativeText);
}

}  // namespace

NavigationRail::NavigationRail(QWidget* parent) : QFrame(parent)
{
    setObjectName(QStringLiteral("navigationRail"));
    setAccessibleName(tr("Pages"));
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Preferred);  // wide enough for the longest name
    column_ = new QVBoxLayout(this);
    column_->setContentsMargins(6, 10, 6, 10);
    column_->setSpacing(kSpacing);
    column_->addStretch(1);
}

void NavigationRail::addPage(const QString& name, Qt::Key key, const QString& tip)
{
    const int page = pages();
    auto* button = new QPushButton(this);
    button->setProperty("role", "page");
    button->setCheckable(true);
    button->setFocusPolicy(Qt::TabFocus);
    button->setAccessibleName(name);
    setTip(*button, QStringLiteral("%1 (%2)").arg(tip, keyText(key)));
    column_->insertWidget(page, button);
    buttons_ << button;
    keys_ << key;
    notes_ << QString();
    connect(button, &QPushButton::clicked, this, [this, page] { choose(page); });
    setDense(dense_);
    if (chosen_ < 0) choose(page);
}

void NavigationRail::showTexts(bool dense)
{
    for (int page = 0; page < pages(); ++page) {
        const QString name = button(page)->accessibleName(), &note = notes_.at(page);
        if (dense)
            button(page)->setText(note.isEmpty() ? name : note);
        else
            button(page)->setText(name + QLatin1Char('\n')
                                  + (note.isEmpty() ? keyText(keyOf(page)) : note));
    }
}

void NavigationRail::setDense(bool dense)
{
    showTexts(dense);
    if (dense == dense_) return;
    dense_ = dense;
    setProperty("dense", dense);
    column_->setSpacing(dense ? kDenseSpacing : kSpacing);
    for (QPushButton* button : buttons_ + tools_) {
        button->style()->unpolish(button);
        button->style()->polish(button);
        QEvent changed(QEvent::StyleChange);  // this event drops the cached size
        QCoreApplication::sendEvent(button, &changed);
    }
    column_->activate();  // lays out in the current height
}

int NavigationRail::heightNeeded(bool dense) const
{
    const QMargins margins = column_->contentsMargins();
    int height = margins.top() + margins.bottom();
    const auto add = [&](int lines) {
        // The numbers equal those of the style sheet.
        const int least = dense ? scaledSmall(kDenseHeight) : scaled(kHeight);
        height += std::max(least, lines * QFontMetrics(QApplication::font()).lineSpacing())
                + kPadding + (dense ? kDenseSpacing : kSpacing);
    };
    for (const QPushButton* page : buttons_)
        if (dense || !page->isHidden()) add(dense ? 1 : 2);
    for (const QPushButton* tool : tools_)
        if (!tool->isHidden()) add(static_cast<int>(tool->text().count(QLatin1Char('\n'))) + 1);
    return height;
}

QSize NavigationRail::minimumSizeHint() const
{
    return {QFrame::minimumSizeHint().width(), heightNeeded(true)};
}

void NavigationRail::fit()
{
    setDense(heightNeeded(false) > height());
}

void NavigationRail::resizeEvent(QResizeEvent* event)
{
    QFrame::resizeEvent(event);
    fit();
}

bool NavigationRail::event(QEvent* event)
{
    const bool handled = QFrame::event(event);
    if (event->type() == QEvent::LayoutRequest) fit();
    return handled;
}

void NavigationRail::setOffered(int page, bool offered)
{
    button(page)->setVisible(offered);
}

void NavigationRail::setNote(int page, const QString& what, bool asks)
{
    if (notes_.at(page) != what) {
        notes_[page] = what;
        showTexts(dense_);
        button(page)->setAccessibleDescription(what);
    }
    QPushButton* const one = button(page);
    if (one->property("asks").toBool() == asks) return;
    one->setProperty("asks", asks);
    one->style()->unpolish(one);
    one->style()->polish(one);
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
    tools_ << button;
}

int NavigationRail::pageOf(int key) const
{
    return static_cast<int>(keys_.indexOf(key));
}

}  // namespace terratact
