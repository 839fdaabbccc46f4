#pragma once

#include <QWidget>
#include <optional>

#include "core/atem/contact_watch.h"
#include "widgets/base/palette.h"

namespace terratact {

/// Force elements of the flippers, the left row above the right one, as seen from above with the front at the right. An
/// element is a box with its number: filled where it touches the ground, with a bar of its force where it does not, and
/// crossed out where it is not known. The rear elements are shown if they are known. Takes values, emits nothing.
class ContactMap final : public QWidget {
    Q_OBJECT
public:
    explicit ContactMap(QWidget* parent = nullptr);

    void setContacts(const std::optional<FlipperContacts>& state);  ///< empty: nothing is known
    void setFill(const Fill& fill);  ///< colours of the cell around it
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    bool hasRear() const;
    void drawElement(QPainter& painter, const QRectF& box, int number,
                     const FlipperContacts::Element& element) const;

    std::optional<FlipperContacts> state_;
    Fill fill_;
};

}  // namespace terratact
