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
    announce(banner_);
}

void ShortNotice::poll(double now, bool hasRoom)
{
    banner_.setVisible(hasRoom && now < until_);
}

}  // namespace terratact
