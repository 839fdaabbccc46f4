#pragma once

#include <QObject>

namespace terratact {

/// Event filter of the application: the wheel scrolls a page and changes no control under the pointer. A spin box or
/// combo box takes the wheel only with the focus. A click or Tab gives it the focus.
class CalmWheel final : public QObject {
    Q_OBJECT
public:
    using QObject::QObject;

protected:
    bool eventFilter(QObject* object, QEvent* event) override;
};

}  // namespace terratact
