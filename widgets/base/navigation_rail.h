#pragma once

#include <QFrame>
#include <QList>
#include <QStringList>

class QPushButton;
class QVBoxLayout;

namespace terratact {

/// The page buttons of the console at the left edge. Exactly one page is chosen, by click or by its key. The key is
/// shown below the name if the height allows, otherwise in the tip.
class NavigationRail final : public QFrame {
    Q_OBJECT
public:
    explicit NavigationRail(QWidget* parent = nullptr);

    /// The first added page is chosen.
    void addPage(const QString& name, Qt::Key key, const QString& tip);
    void choose(int page);
    int chosen() const { return chosen_; }
    int pages() const { return static_cast<int>(buttons_.size()); }
    int pageOf(int key) const;  ///< −1 if the key belongs to no page
    Qt::Key keyOf(int page) const { return static_cast<Qt::Key>(keys_.at(page)); }
    QPushButton* button(int page) const { return buttons_.at(page); }
    /// Adds a button at the lower end, below earlier tools.
    void addTool(QPushButton* button);
    /// Hides or shows the button of a page that is temporarily unavailable.
    void setOffered(int page, bool offered);
    /// Shows a short status instead of the page's key; empty: the key again. asks: the status needs an answer and is
    /// highlighted.
    void setNote(int page, const QString& what, bool asks);

    QSize minimumSizeHint() const override;  ///< fits all pages

signals:
    void pageChosen(int page);

protected:
    void resizeEvent(QResizeEvent* event) override;
    bool event(QEvent* event) override;

private:
    void fit();
    void setDense(bool dense);
    void showTexts(bool dense);
    int heightNeeded(bool dense) const;

    QVBoxLayout* column_ = nullptr;
    QList<QPushButton*> buttons_, tools_;
    QList<int> keys_;
    QStringList notes_;  ///< status per page
    bool dense_ = false;
    int chosen_ = -1;
};

}  // namespace terratact
