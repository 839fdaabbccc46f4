#include "app/shell/font_fit.h"

#include <QCoreApplication>
#include <QLayout>
#include <QWidget>
#include <algorithm>
#include <cmath>

#include "app/shell/preferences/preferences.h"
#include "widgets/base/theme.h"

namespace terratact {
namespace {

struct Letters {
    Q_DECLARE_TR_FUNCTIONS(Letters)
};

}  // namespace

int smallerFont(int percent, QSize needs, QSize room)
{
    const auto share = [](int has, int wants) {
        return static_cast<double>(has) / std::max(wants, 1);
    };
    const double fits =
        percent
        * std::min(share(room.width(), needs.width()), share(room.height(), needs.height()));
    const int steps = static_cast<int>(std::ceil((percent - fits) / kFontStep - 1e-9));
    return std::max(percent - std::max(steps, 1) * kFontStep, kSmallestFont);
}

void forgetSizes(QWidget& widget)
{
    for (QWidget* part : widget.findChildren<QWidget*>()) part->updateGeometry();
    for (QLayout* layout : widget.findChildren<QLayout*>()) layout->invalidate();
}

QString fontNote(int wanted)
{
    const int inForce = lookInForce().fontScale;
    if (inForce >= wanted) return {};
    return Letters::tr("%1 % wanted, %2 % fits this screen").arg(wanted).arg(inForce);
}

}  // namespace terratact
