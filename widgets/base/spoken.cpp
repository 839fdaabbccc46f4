#include "widgets/base/spoken.h"

#include <QAccessible>
#include <QAccessibleWidget>
#include <QCoreApplication>
#include <QLabel>
#include <QTextDocumentFragment>

namespace terratact {
namespace {

class SpokenLabel final : public QAccessibleWidget {
public:
    explicit SpokenLabel(QLabel* label) : QAccessibleWidget(label, QAccessible::StaticText) {}

    QString text(QAccessible::Text which) const override
    {
        if (which != QAccessible::Name) return QAccessibleWidget::text(which);
        const auto* label = static_cast<const QLabel*>(widget());
        const bool rich =
            label->textFormat() == Qt::RichText
            || (label->textFormat() == Qt::AutoText && Qt::mightBeRichText(label->text()));
        QString says =
            rich ? QTextDocumentFragment::fromHtml(label->text()).toPlainText() : label->text();
        const QString name = label->accessibleName();
        if (name.isEmpty()) return says;
        return says.isEmpty() ? name : QStringLiteral("%1: %2").arg(name, says);
    }
};

QAccessibleInterface* spokenLabel(const QString& /*className*/, QObject* object)
{
    auto* label = qobject_cast<QLabel*>(object);
    return label ? new SpokenLabel(label) : nullptr;
}

}  // namespace

void installSpokenLabels()
{
    QAccessible::installFactory(spokenLabel);  // installing it twice has no effect
}

void announce(QWidget& widget)
{
    for (const QAccessible::Event what : {QAccessible::NameChanged, QAccessible::Alert}) {
        QAccessibleEvent event(&widget, what);
        QAccessible::updateAccessibility(&event);
    }
    QEvent announced(kAnnounced);
    QCoreApplication::sendEvent(&widget, &announced);
}

}  // namespace terratact
