#include "app/review/what_if_page.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QEvent>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QRegularExpressionValidator>
#include <QTableWidget>
#include <QVBoxLayout>
#include <cmath>
#include <limits>
#include <utility>

#include "app/display/format.h"
#include "app/display/translated.h"
#include "app/recording/what_if.h"
#include "app/runtime/resources.h"
#include "app/shell/file_dialog.h"
#include "core/infer/estimate/quality_preset.h"
#include "core/store/sha256.h"
#include "widgets/base/card.h"
#include "widgets/base/plain_label.h"
#include "widgets/base/plain_table.h"
#include "widgets/base/theme.h"
#include "widgets/base/tips.h"

namespace terratact {
namespace {

bool isTrail(const EstimateRow& row)
{
    return row.estimate.side[0].settings.method == Method::Trail;
}

}  // namespace

WhatIfPage::WhatIfPage(RobotModel robot, QStringList models, QWidget* parent)
    : Page(parent), robot_(std::move(robot)), models_(std::move(models))
{
    auto* card = new Card(tr("What if …"), this);
    what_ = new PlainLabel(card);
    what_->setWordWrap(true);
    result_ = new PlainLabel(card);
    result_->setWordWrap(true);
    result_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    result_->setAccessibleName(tr("What differs"));
    table_ = new HeadedTable(kBins, 8, card);
    table_->setAccessibleName(tr("Recorded estimate and what-if, bin by bin"));
    table_->setHorizontalHeaderLabels({tr("bin [%1]").arg(format::lengthUnit()),
                                       tr("then [%1]").arg(format::lengthUnit()),
                                       tr("now [%1]").arg(format::lengthUnit()), tr("by"),
                                       tr("sd then"), tr("sd now"), tr("q10 by"), tr("q90 by")});
    table_->verticalHeader()->hide();
    table_->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    table_->setAlternatingRowColors(true);
    table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table_->setSelectionMode(QAbstractItemView::NoSelection);
    table_->setTabKeyNavigation(false);
    table_->setFrameShape(QFrame::NoFrame);
    auto* answers = new QVBoxLayout;
    answers->addWidget(result_);
    answers->addWidget(table_, 1);
    auto* columns = new QHBoxLayout;
    columns->setSpacing(18);
    form_ = form();
    columns->addWidget(form_);
    columns->addLayout(answers, 1);
    card->body()->addWidget(what_);
    card->body()->addLayout(columns, 1);
    auto* page = new QVBoxLayout(this);
    page->setContentsMargins(12, 10, 12, 10);
    page->addWidget(card);
    setRecorded(nullptr, nullptr, nullptr);
    drop();
    resizeToFont();
}

WhatIfPage::~WhatIfPage() = default;

void WhatIfPage::changeEvent(QEvent* event)
{
    Page::changeEvent(event);
    if (changesFont(*event) && form_) resizeToFont();
}

void WhatIfPage::resizeToFont()
{
    result_->setMinimumHeight(4 * fontMetrics().lineSpacing());
    form_->setFixedWidth(scaled(360));
    fitRows(*table_, fontMetrics());
    for (QWidget* field :
         std::initializer_list<QWidget*>{method_, quality_, threshold_, seed_, model_, cancel_})
        field->setMinimumHeight(scaled(kTarget));
}

QWidget* WhatIfPage::form()
{
    auto* form = new QWidget(this);
    auto* rows = new QFormLayout(form);
    rows->setContentsMargins(0, 0, 0, 0);
    const auto combo = [&](const QString& label, const QString& tip) {
        auto* box = new QComboBox(form);
        box->setAccessibleName(label);
        setTip(*box, tip);
        box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        addField(*rows, label, box);
        return box;
    };
    method_ = combo(tr("Method"), tr("Which method estimates"));
    for (const Method method : kMethods)
        method_->addItem(format::text(name(method)), static_cast<int>(method));
    quality_ = combo(tr("Quality"), tr("Draws, chains and precision"));
    quality_->addItem(tr("as recorded"));
    for (const QualityPreset preset : kQualityPresets)
        quality_->addItem(translated(describe(preset)));
    threshold_ = new QDoubleSpinBox(form);
    threshold_->setRange(0.1, 50.0);
    threshold_->setSingleStep(0.1);
    threshold_->setDecimals(2);
    threshold_->setSuffix(QStringLiteral(" N"));
    threshold_->setAccessibleName(tr("An element counts as contact above"));
    setTip(*threshold_, tr("Force above which an element counts as contact"));
    addField(*rows, tr("Contact above"), threshold_);
    seed_ = new QLineEdit(form);
    seed_->setAccessibleName(tr("Seed"));
    setTip(*seed_, tr("Seed of the random numbers: a whole number"));
    seed_->setValidator(
        new QRegularExpressionValidator(QRegularExpression(QStringLiteral("[0-9]{1,20}")), seed_));
    addField(*rows, tr("Seed"), seed_);
    model_ = combo(tr("Model"), tr("File of the model"));
    for (const QString& path : std::as_const(models_))
        model_->addItem(format::fileName(path), path);
    model_->addItem(tr("another file …"), QString());
    connect(model_, &QComboBox::activated, this, [this](int index) {
        if (!model_->itemData(index).toString().isEmpty()) return;
        model_->setCurrentIndex(0);
        askForFile(*this, {.title = tr("Model"), .filter = tr("Models (*.ttm)")},
                   [this](const QString& path) {
                       model_->insertItem(0, format::fileName(path), path);
                       model_->setCurrentIndex(0);
                   });
    });
    asRecorded_ = new QPushButton(tr("As recorded"), form);
    estimate_ = new QPushButton(tr("Estimate again (E)"), form);
    estimate_->setProperty("role", "primary");
    for (QPushButton* button : {asRecorded_, estimate_}) {
        button->setFocusPolicy(Qt::TabFocus);
        rows->addRow(button);
    }
    progress_ = new QProgressBar(form);
    progress_->setAccessibleName(tr("Progress of the estimate"));
    progress_->setVisible(false);
    rows->addRow(progress_);
    cancel_ = new QPushButton(tr("Cancel the estimate"), form);
    cancel_->setFocusPolicy(Qt::TabFocus);
    cancel_->setVisible(false);
    rows->addRow(cancel_);
    connect(cancel_, &QPushButton::clicked, this, &WhatIfPage::drop);
    connect(asRecorded_, &QPushButton::clicked, this, &WhatIfPage::asRecorded);
    connect(estimate_, &QPushButton::clicked, this, &WhatIfPage::estimate);
    return form;
}

void WhatIfPage::setRecorded(const std::shared_ptr<const EstimateRow>& estimate,
                             const SceneRow* scene, const ModelRow* model)
{
    if (model) {
        recordedModel_ = format::shownName(model->name);
        recordedHash_ = QString::fromStdString(model->hash);
        recordedTrail_ = model->trailHash;
    }
    const bool same = estimate && recorded_ && estimate->id == recorded_->id;
    if (same || (!estimate && !recorded_ && !what_->text().isEmpty())) return;
    recorded_ = scene ? estimate : nullptr;
    scene_ = scene ? std::optional(*scene) : std::nullopt;
    const QString whyNot = tr("No estimate at this time");
    for (QPushButton* button : {estimate_, asRecorded_}) button->setEnabled(recorded_ != nullptr);
    setTip(*estimate_, recorded_ ? tr("Estimates the recorded scene with these settings") : whyNot);
    setTip(*asRecorded_, recorded_ ? tr("Sets everything to what was recorded") : whyNot);
    what_->setText(
        recorded_ ? tr("Estimate %1 of scene %2 at %3 s, by %4 with the model %5")
                        .arg(recorded_->id)
                        .arg(recorded_->scene)
                        .arg(format::number(secondsOf(recorded_->time), 3),
                             format::text(name(recorded_->estimate.side[0].settings.method)),
                             recordedModel_.isEmpty() ? format::kNothing : recordedModel_)
                  : tr("There was no estimate at this time: go to one (key 4 finds the next)."));
    drop();
    offerMemory();
    if (recorded_) asRecorded();
}

/// Offers the method trail for a scene with a memory alone.
void WhatIfPage::offerMemory()
{
    const int trail = method_->findData(static_cast<int>(Method::Trail));
    const bool isOffered = recorded_ && (scene_->memory || isTrail(*recorded_));
    if (!isOffered && trail >= 0) method_->removeItem(trail);
    if (isOffered && trail < 0)
        method_->addItem(format::text(name(Method::Trail)), static_cast<int>(Method::Trail));
}

void WhatIfPage::drop()
{
    if (worker_) worker_->cancel();
    job_ = 0;
    asked_.reset();
    if (answer_) {
        answer_.reset();
        emit answered();
    }
    showStatus(recorded_
                   ? tr("Change settings, then estimate again: the page Terrain (F2) draws both.")
                   : QString(),
               Tone::Muted);
    showBins(nullptr);
}

void WhatIfPage::asRecorded()
{
    if (!recorded_) return;
    const Settings& s = recorded_->estimate.side[0].settings;
    method_->setCurrentText(format::text(name(s.method)));
    quality_->setCurrentIndex(0);
    threshold_->setValue(s.forceThreshold);
    seed_->setText(QString::number(s.seed));
    std::vector<std::string> paths;
    for (const QString& path : std::as_const(models_)) paths.push_back(path.toStdString());
    ModelRow row;
    row.name = recordedModel_.toStdString();
    row.hash = recordedHash_.toStdString();
    const auto found = modelFileOf(row, paths);
    if (!found) return showStatus(translated(found.error().message), Tone::Warning);
    model_->setCurrentIndex(model_->findData(QString::fromStdString(*found)));
}

Settings WhatIfPage::settings() const
{
    Settings s = recorded_->estimate.side[0].settings;
    s.method = static_cast<Method>(method_->currentData().toInt());
    if (const int quality = quality_->currentIndex(); quality > 0)
        s = withPreset(s, kQualityPresets.at(static_cast<std::size_t>(quality - 1)));
    // The form rounds values; an unchanged field keeps the recorded value.
    if (std::abs(threshold_->value() - s.forceThreshold) > 0.006)
        s.forceThreshold = threshold_->value();
    bool isNumber = false;
    const qulonglong seed = seed_->text().toULongLong(&isNumber);
    if (isNumber) s.seed = seed;
    return s;
}

void WhatIfPage::useModel(const QString& path)
{
    if (worker_ && path == modelPath_) return;
    modelPath_ = path;
    const auto hash = sha256OfFile(path.toStdString());
    modelHash_ = hash ? *hash : std::string();
    const auto trail = sha256OfFile(trailPathBeside(path.toStdString()));
    trailHash_ = trail ? *trail : std::string();
    const ModelLoader loader = modelFileLoader(path.toStdString(), robot_);
    if (worker_) return worker_->load(loader);
    worker_ = std::make_unique<EstimatorWorker>(loader);
    connect(worker_.get(), &EstimatorWorker::estimated, this,
            [this](int job, const TwoTrackEstimate& estimate) { addEstimate(job, estimate); });
    const auto failed = [this](const Message& why) {
        job_ = 0;
        modelPath_.clear();
        showStatus(tr("No estimate: %1").arg(translated(why)), Tone::Bad);
    };
    connect(worker_.get(), &EstimatorWorker::failed, this, [this](int job, const Message& why) {
        if (job != job_) return;
        job_ = 0;
        showStatus(tr("No estimate: %1").arg(translated(why)), Tone::Bad);
    });
    connect(worker_.get(), &EstimatorWorker::modelFailed, this, failed);
    connect(worker_.get(), &EstimatorWorker::modelKept, this, failed);
    worker_->start();
}

void WhatIfPage::estimate()
{
    if (!recorded_ || !scene_) return;
    const QString path = model_->currentData().toString();
    if (path.isEmpty()) return showStatus(tr("No model is chosen"), Tone::Bad);
    if (const Status modest = requireModest(settings()); !modest)
        return showStatus(tr("No estimate: %1").arg(translated(modest.error().message)), Tone::Bad);
    useModel(path);
    asked_ = settings();
    EstimateRequest request{scene_->measurement, recorded_->readings, *asked_};
    request.stepLimit = recorded_->stepLimit;
    request.memory = scene_->memory;
    job_ = worker_->request(request);
    showStatus(tr("Estimating …"), Tone::Muted);
}

void WhatIfPage::addEstimate(int job, const TwoTrackEstimate& estimate)
{
    if (job != job_ || !recorded_) return;
    job_ = 0;
    answer_ = estimate;
    showAnswer();
    emit answered();
}

bool WhatIfPage::isRecordedModel() const
{
    const bool isModel = !modelHash_.empty() && modelHash_ == recordedHash_.toStdString();
    return isModel && (!isTrail(*recorded_) || trailHash_ == recordedTrail_);
}

void WhatIfPage::showAnswer()
{
    const TwoTrackEstimate& before = recorded_->estimate;
    const Differences found =
        differencesBetween(before, *answer_, robot_, scene_->measurement, recorded_->stepLimit);
    const bool asRecorded = *asked_ == before.side[0].settings && isRecordedModel();
    QString text;
    Tone tone = Tone::Plain;
    if (asRecorded && found.match == Match::Identical) {
        text = tr("The recorded settings and model reproduce the recorded estimate bit for bit.");
        tone = Tone::Good;
    } else if (asRecorded && found.match == Match::LastBits) {
        text = tr("The recorded settings and model reproduce the recorded estimate except for "
                  "rounding in the last bits: no number moves by more than a millionth.");
        tone = Tone::Good;
    } else if (asRecorded && before.side[0].ending == Ending::Time) {
        text = tr("A time limit ended the recorded sampling, so it cannot be repeated bit for bit: "
                  "%1 at most, at bin %2.")
                   .arg(format::length(found.largest(), 3), placeName(found));
        tone = Tone::Warning;
    } else if (asRecorded) {
        text = tr("The recorded settings and model do NOT reproduce the recorded estimate: %1 at "
                  "most, at bin %2.")
                   .arg(format::length(found.largest(), 6), placeName(found));
        tone = Tone::Bad;
    } else {
        text = tr("Differs from the recorded estimate by %1 at most, at bin %2.")
                   .arg(format::length(found.largest(), 3), placeName(found));
    }
    showStatus(text + QLatin1Char('\n') + verdictText(found), tone);
    showBins(&found);
}

QString WhatIfPage::placeName(const Differences& found)
{
    QString bin = format::binName(found.largestBin);
    if (found.onePlane) return bin;
    return found.largestSide == 0 ? tr("%1 left").arg(bin) : tr("%1 right").arg(bin);
}

QString WhatIfPage::verdictText(const Differences& found) const
{
    const auto answer = [](StepVerdict verdict, double p) {
        return QStringLiteral("%1 (%2 %)")
            .arg(translated(describe(verdict)), format::number(100.0 * p, 1));
    };
    QString text = tr("Steps of more than %1: %2 then, %3 now.")
                       .arg(format::length(recorded_->stepLimit, 2),
                            answer(found.before.both, answeredBy(found.before).p),
                            answer(found.after.both, answeredBy(found.after).p));
    if (found.onePlane) return text;
    const auto side = [&](const QString& words, std::size_t k) {
        const Verdict &then = found.before.side.at(k), &now = found.after.side.at(k);
        text += QLatin1Char('\n')
              + words.arg(answer(then.stepVerdict, answeredBy(then).p),
                          answer(now.stepVerdict, answeredBy(now).p));
    };
    side(tr("Left: %1 then, %2 now."), 0);
    side(tr("Right: %1 then, %2 now."), 1);
    return text;
}

void WhatIfPage::showBins(const Differences* found)
{
    const bool onePlane = found ? found->onePlane : !recorded_ || recorded_->estimate.onePlane;
    table_->setRowCount(onePlane ? kBins : 2 * kBins);
    showSide(found, 0, onePlane ? QString() : tr("left"));
    if (!onePlane) showSide(found, 1, tr("right"));
}

void WhatIfPage::showSide(const Differences* found, std::size_t side, const QString& name)
{
    const double nothing = std::numeric_limits<double>::quiet_NaN();
    for (int bin = 0; bin < kBins; ++bin) {
        const auto i = static_cast<std::size_t>(bin);
        const TerrainEstimate* before = recorded_ ? &recorded_->estimate.side.at(side) : nullptr;
        const TerrainEstimate* now = found ? &answer_->side.at(side) : nullptr;
        const BinDifference by = found ? found->side.at(side)[i]
                                       : BinDifference{nothing, nothing, nothing, nothing, nothing};
        const QString place = format::signedNumber(binCentre(bin), 1);
        const QStringList cells{name.isEmpty() ? place : place + QLatin1Char(' ') + name,
                                format::signedNumber(before ? before->height[i] : nothing, 3),
                                format::signedNumber(now ? now->height[i] : nothing, 3),
                                format::signedNumber(by.height, 3),
                                format::number(before ? before->sd[i] : nothing, 3),
                                format::number(now ? now->sd[i] : nothing, 3),
                                format::signedNumber(by.q10, 3),
                                format::signedNumber(by.q90, 3)};
        for (int column = 0; column < cells.size(); ++column) {
            auto* item = new QTableWidgetItem(cells[column]);
            item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
            table_->setItem(static_cast<int>(side) * kBins + bin, column, item);
        }
    }
}

void WhatIfPage::showStatus(const QString& text, Tone tone)
{
    result_->setText(text);
    setTone(*result_, tone);
}

void WhatIfPage::refresh(double /*now*/)
{
    progress_->setVisible(job_ != 0);
    cancel_->setVisible(job_ != 0);
    if (job_ != 0 && worker_)
        progress_->setValue(static_cast<int>(100.0 * worker_->progress().value_or(0.0)));
}

}  // namespace terratact
