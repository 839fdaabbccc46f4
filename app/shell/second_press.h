#pragma once

#include <QObject>
#include <QString>
#include <QTimer>

class QPushButton;

namespace terratact {

/// Makes a button act only after a second press within 8 s. A second press within 0.7 s is a double click and is
/// ignored.
class SecondPress final : public QObject {
    Q_OBJECT
public:
    /// question: the button's text while it waits for the second press.
    SecondPress(QPushButton& button, const QString& question);

    void cancel();  ///< forgets a first press; call it if the button's target changes

signals:
    void confirmed();

private:
    void press();
    void showText();

    QPushButton& button_;
    QString text_, question_;
    QTimer asked_;
};

}  // namespace terratact
