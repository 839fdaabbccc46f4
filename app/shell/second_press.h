#pragma once

#include <QObject>
#include <QString>
#include <QTimer>

class QPushButton;

namespace terratact {

/// Makes a button ask for a second press within 8 s before it acts. A second press within 0.7 s is a double click and
/// counts for nothing.
class SecondPress final : public QObject {
    Q_OBJECT
public:
    /// question: the button's text while it waits for the second press.
    SecondPress(QPushButton& button, const QString& question);

    void cancel();  ///< forgets a first press; call it when the button would act on another thing

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
