#pragma once

#include <QAbstractTableModel>
#include <QTableView>
#include <cstddef>
#include <optional>
#include <vector>

#include "app/modelling/scene_error.h"
#include "app/shell/page.h"
#include "core/infer/verdict/verdict.h"
#include "core/learn/data/two_track_scene.h"

class QLabel;

namespace terratact {

/// What is known of a scene once it was estimated.
struct SceneResult {
    StepVerdict verdict = StepVerdict::CannotTell;
    std::optional<SceneError> error{};  ///< empty: the truth is unknown
    Message trouble{};                  ///< why there is no estimate
};

/// The scenes of a file as a table model, a row for each.
class SceneRows final : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Column { Number, Drive, Time, Pitch, Roll, Truth, Median, Mean, Answer, kColumns };
    /// scenes must outlive this object.
    SceneRows(const std::vector<TwoTrackScene>& scenes, QObject* parent);

    void setResult(std::size_t scene, SceneResult result);
    const std::optional<SceneResult>& result(std::size_t scene) const { return results_[scene]; }
    void forget();  ///< removes all results
    /// Returns the next scene without a result from `from` on, around the end; empty: all have one.
    std::optional<std::size_t> nextWithout(std::size_t from) const;
    std::size_t known() const { return known_; }  ///< number of results

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    QVariant data(const QModelIndex& index, int role) const override;

private:
    QString text(std::size_t scene, int column) const;

    const std::vector<TwoTrackScene>& scenes_;
    std::vector<std::optional<SceneResult>> results_;
    std::size_t known_ = 0;
};

/// The list of a file's scenes. Enter or a double click shows one; typing a number goes to it.
class ScenesPage final : public Page {
    Q_OBJECT
public:
    ScenesPage(SceneRows& rows, QWidget* parent);

    void refresh(double /*now*/) override {}
    void showSummary();  ///< call after a new result
    void choose(std::size_t scene);
    QTableView* table() const { return table_; }
    QLabel* summary() const { return summary_; }

signals:
    void wanted(std::size_t scene);

protected:
    void changeEvent(QEvent* event) override;
    void showEvent(QShowEvent* event) override;  ///< the keys go to the table

private:
    void resizeToFont();

    SceneRows& rows_;
    QLabel* summary_ = nullptr;
    QTableView* table_ = nullptr;
};

}  // namespace terratact
