#pragma once

#include <QWidget>
#include <optional>

class QLabel;

namespace terratact {

struct ListedSession;
struct LastEstimate;

/// The chosen recording below the list: a larger thumbnail, its file, source and program, its verdicts and notes.
class SessionDetails final : public QWidget {
    Q_OBJECT
public:
    explicit SessionDetails(QWidget* parent = nullptr);
    ~SessionDetails() override;

    void show(const ListedSession& session);
    void showNothing(const QString& why);
    QString text() const;

protected:
    void changeEvent(QEvent* event) override;

private:
    class Picture;
    void resizeToFont();

    Picture* picture_ = nullptr;
    QLabel* heading_ = nullptr;
    QLabel* text_ = nullptr;
};

}  // namespace terratact
