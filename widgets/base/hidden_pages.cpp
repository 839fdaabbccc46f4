#include "widgets/base/hidden_pages.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QEvent>
#include <QPointer>
#include <QStackedWidget>
#include <QStyle>
#include <QTimer>
#include <limits>
#include <utility>

namespace terratact {
namespace {

constexpr int kIdleEvery = 10, kIdleSlice = 4;  // [ms]

class HiddenPages final : public QObject {
public:
    explicit HiddenPages(QApplication& application) : QObject(&application)
    {
        connect(&idle_, &QTimer::timeout, this, [this] { style(kIdleSlice); });
    }

    static QPointer<HiddenPages> only;

    void postpone()
    {
        for (QWidget* widget : QApplication::allWidgets())
            if (const auto* stack = qobject_cast<const QStackedWidget*>(widget);
                stack && stack->window()->isVisible())
                postponePages(*stack);
        if (!waiting_.isEmpty()) idle_.start(kIdleEvery);
    }

    bool style(int most)
    {
        QElapsedTimer since;
        since.start();
        while (!waiting_.isEmpty() && since.elapsed() < most) style(waiting_.takeLast());
        if (waiting_.isEmpty()) idle_.stop();
        return waiting_.isEmpty();
    }

    void stylePage(const QWidget& page)
    {
        for (Waiting& waiting : waiting_)
            if (waiting.widget && (waiting.widget == &page || page.isAncestorOf(waiting.widget)))
                style(std::exchange(waiting, {}));
    }

    bool eventFilter(QObject* object, QEvent* event) override
    {
        if (event->type() != QEvent::Show || waiting_.isEmpty()) return false;
        for (Waiting& waiting : waiting_)
            if (waiting.widget == object) style(std::exchange(waiting, {}));
        return false;
    }

private:
    struct Waiting {
        QPointer<QWidget> widget;  ///< null: nothing to do
        bool wasPolished = false;
    };

    void postponePages(const QStackedWidget& stack)
    {
        for (int i = 0; i < stack.count(); ++i) {
            if (i == stack.currentIndex()) continue;
            postpone(*stack.widget(i));
            for (QWidget* part : stack.widget(i)->findChildren<QWidget*>()) postpone(*part);
        }
    }

    void postpone(QWidget& widget)
    {
        // One that waits already has this attribute.
        if (widget.isVisible() || widget.testAttribute(Qt::WA_SetStyle)) return;
        waiting_ << Waiting{&widget, widget.testAttribute(Qt::WA_WState_Polished)};
        // QApplication::setStyle() uses these two attributes to select the widgets it styles and notifies.
        widget.setAttribute(Qt::WA_WState_Polished, false);
        widget.setAttribute(Qt::WA_SetStyle);
    }

    static void style(const Waiting& waiting)
    {
        QWidget* const widget = waiting.widget;
        if (!widget || !widget->testAttribute(Qt::WA_SetStyle)) return;
        widget->setAttribute(Qt::WA_SetStyle, false);
        if (waiting.wasPolished) {
            widget->style()->polish(widget);
            widget->setAttribute(Qt::WA_WState_Polished);
        }
        QEvent change(QEvent::StyleChange);
        QCoreApplication::sendEvent(widget, &change);
    }

    QList<Waiting> waiting_;
    QTimer idle_;
};

QPointer<HiddenPages> HiddenPages::only;

}  // namespace

void postponeHiddenPages(QApplication& application)
{
    if (!HiddenPages::only) {
        HiddenPages::only = new HiddenPages(application);
        application.installEventFilter(HiddenPages::only);
    }
    HiddenPages::only->postpone();
}

bool styleHiddenPages(int most)
{
    return !HiddenPages::only || HiddenPages::only->style(most);
}

void styleHiddenPages()
{
    (void)styleHiddenPages(std::numeric_limits<int>::max());
}

void styleHiddenPage(QWidget& page)
{
    if (HiddenPages::only) HiddenPages::only->stylePage(page);
}

}  // namespace terratact
