#include "app/letters.h"

#include <QCoreApplication>
#include <QLayout>
#include <QWidget>
#include <algorithm>

#include "app/preferences.h"
#include "widgets/look.h"

namespace terratact {
namespace {

struct Letters {
    Q_DECLARE_TR_FUNCTIONS(Letters)
};

}  // namespace

int lettersThatFit(int wanted, QSize room, const std::function<QSize(int)>& needs)
{
    int percent = std::max(wanted, kSmallestFont);
    while (percent > kSmallestFont && needs(percent).expandedTo(room) != room)
        percent = std::max(percent - kLetterStep, kSmallestFont);
    return percent;
}

void forgetSizes(QWidget& widget)
{
    for (QWidget* part : widget.findChildren<QWidget*>()) part->updateGeometry();
    for (QLayout* layout : widget.findChildren<QLayout*>()) layout->invalidate();
}

QString lettersNote(int wanted)
{
    const int inForce = lookInForce().fontScale;
    if (inForce >= wanted) return {};
    return Letters::tr("%1 % wanted, %2 % fits this screen").arg(wanted).arg(inForce);
}

}  // namespace terratact
