#include "app/shell/second_press.h"

#include <QPushButton>

namespace terratact {
namespace {

constexpr int kAnswerWithin = 8000,
              kReadFor = 700;  // [ms] the same as for closing an armed robot's window

}  // namespace

SecondPress::SecondPress(QPushButton& button, const QString& question)
    : QObject(&button), button_(button), text_(button.text()), question_(question)
{
    asked_.setSingleShot(true);
    asked_.setInterval(kAnswerWithin);
    connect(&asked_, &QTimer::timeout, this, &SecondPress::showText);
    connect(&button, &QPushButton::clicked, this, &SecondPress::press);
}

void SecondPress::press()
{
    if (!asked_.isActive()) {
        asked_.start();
        return showText();
    }
    if (asked_.remainingTime() > kAnswerWithin - kReadFor) return;
    asked_.stop();
    showText();
    emit confirmed();
}

void SecondPress::cancel()
{
    asked_.stop();
    showText();
}

void SecondPress::showText()
{
    button_.setText(asked_.isActive() ? question_ : text_);
}

}  // namespace terratact
