#include "app/shell/short_notice.h"

#include <QLabel>

#include "widgets/base/spoken.h"

namespace terratact {

ShortNotice::ShortNotice(QLabel& banner) : banner_(banner)
{
    banner_.hide();
}

void ShortNotice::show(const QString& text, double now)
{
    banner_.setText(text);
    until_ = now + kFor;
    isRefusal_ = false;
    announce(banner_);
}

void ShortNotice::showRefusal(const QString& text, double now)
{
    show(text, now);
    isRefusal_ = true;
}

void ShortNotice::endRefusal()
{
    if (isRefusal_) until_ = 0.0;
}

void ShortNotice::poll(double now, bool hasRoom)
{
    banner_.setVisible(hasRoom && now < until_);
}

}  // namespace terratact
