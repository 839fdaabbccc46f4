#include "app/short_notice.h"

#include <QLabel>

namespace terratact {

ShortNotice::ShortNotice(QLabel& banner) : banner_(banner)
{
    banner_.hide();
}

void ShortNotice::say(const QString& text, double now)
{
    banner_.setText(text);
    banner_.show();
    until_ = now + kFor;
}

void ShortNotice::look(double now)
{
    if (now >= until_) banner_.hide();
}

}  // namespace terratact
