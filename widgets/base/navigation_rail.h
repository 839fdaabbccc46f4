#pragma once

#include <QFrame>
#include <QList>
#include <QStringList>

class QPushButton;
class QVBoxLayout;

namespace terratact {

/// The pages of the console, one button each, at the left edge.  Exactly one is chosen, by click or by its key,
/// which stands below its name where there is the height, and else in its tip.
class NavigationRail final : public QFrame {
    Q_OBJECT
public:
    explicit NavigationRail(QWidget* parent = nullptr);

    /// The first page that is added is the chosen one.
    void addPage(const QString& name, Qt::Key key, const QString& tip);
    void choose(int page);
    int chosen() const { return chosen_; }
    int pages() const { return static_cast<int>(buttons_.size()); }
    int pageOf(int key) const;  ///< −1: the key means no page
    Qt::Key keyOf(int page) const { return static_cast<Qt::Key>(keys_.at(page)); }
    QPushButton* button(int page) const { return buttons_.at(page); }
    /// Puts a button at the lower end, below those put there before.
    void addTool(QPushButton* button);
    /// A page that is not there for the time being is not offered.
    void setOffered(int page, bool offered);
    /// What a page has to tell, in a word or two that stand in place of its key; empty: nothing.  asks: the operator,
    /// which stands out.
    void tell(int page, const QString& what, bool asks);

    QSize minimumSizeHint() const override;  ///< with room for every page

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
    QStringList telling_;  ///< of each page
    bool dense_ = false;
    int chosen_ = -1;
};

}  // namespace terratact
