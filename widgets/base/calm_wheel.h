#pragma once

#include <QObject>

namespace terratact {

/// Filters the application's events so that the wheel scrolls a page and changes nothing it comes across there: a
/// number or a choice takes it only with the focus, which it gets by a click or by Tab.
class CalmWheel final : public QObject {
    Q_OBJECT
public:
    using QObject::QObject;

protected:
    bool eventFilter(QObject* object, QEvent* event) override;
};

}  // namespace terratact
