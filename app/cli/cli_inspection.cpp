#include <memory>

#include "app/cli/cli_options.h"
#include "app/cli/cli_subcommands.h"
#include "app/cli/commands.h"
#include "core/learn/model/model_card.h"

namespace terratact {
namespace {

void addContacts(CLI::App& app, Job& job)
{
    auto* c = app.add_subcommand(
        "contacts", "Bias and sd of contact heights, from scenes whose terrain is known");
    const auto o = std::make_shared<ContactsOptions>();
    addRobot(*c, o->robot);
    addInput(*c, "--data", o->data, "Scenes CSV with heights")->required();
    addNumber(*c, "--threshold", o->threshold, "Force of a contact [N]")
        ->check(CLI::Range(0.0, 1000.0));
    c->callback([o, &job] {
        useShippedRobot(o->robot);
        job = [o] { return showContacts(*o); };
    });
}

void addFaults(CLI::App& app, Job& job)
{
    auto* c = app.add_subcommand(
        "faults", "Which faults of sensors are noticed on simulated drives, and what they cost");
    const auto o = std::make_shared<FaultsOptions>();
    addRobot(*c, o->robot);
    addModel(*c, o->model);
    c->add_option("--terrain", o->trial.grounds.terrain, "varied, or a CSV file of profiles")
        ->capture_default_str();
    addNumber(*c, "--drives", o->trial.drives, "Drives; of a file every profile, at most so many")
        ->check(CLI::Range(1, 100'000));
    addNumber(*c, "--spacing", o->trial.spacing, "Driven between two scenes [m]")
        ->check(CLI::Range(0.01, 1.0));
    addNumber(*c, "--step", o->trial.grounds.step, "Distance of a file's heights [m]")
        ->check(CLI::Range(0.001, 1.0));
    c->add_flag("--blocks", o->trial.grounds.blocks,
                "A file's heights are flat-topped blocks with vertical faces");
    c->add_flag(
        "--matrix", o->matrix,
        "Every kind of fault at every sensor: in how many drives it is noticed, or why not");
    c->add_flag("--return", o->trial.comesBack,
                "Every drive turns round at its end and comes back");
    addNumber(*c, "--seed", o->trial.settings.seed, "Seed of terrain, noise and estimates");
    c->callback([o, &job] {
        useShippedRobot(o->robot);
        useShippedModel(o->model);
        o->trial.grounds.seed = o->trial.settings.seed;
        job = [o] { return judgeFaults(*o); };
    });
}

void addProbes(CLI::App& app, Job& job)
{
    auto* c = app.add_subcommand("probes", "The sd of an arm's readings, from a recording of them");
    const auto data = std::make_shared<std::string>();
    addInput(*c, "--data", *data, "CSV with place,height_m,truth_m")->required();
    c->callback([data, &job] { job = [data] { return showProbes(*data); }; });
}

void addCalibrate(CLI::App& app, Job& job)
{
    auto* c = app.add_subcommand(
        "calibrate", "The force elements' bias and curve, from a recording of known forces");
    const auto o = std::make_shared<CalibrateOptions>();
    addInput(*c, "--data", o->data, "CSV with side,element,force_n,voltage_v")->required();
    addRobot(*c, o->robot);
    c->callback([o, &job] {
        useShippedRobot(o->robot);
        job = [o] { return calibrateForces(*o); };
    });
}

void addModelShow(CLI::App& model, Job& job)
{
    struct Options {
        std::string model;
        bool csv = false;
    };
    auto* c = model.add_subcommand("show", "Every hyperparameter, and how the model was made");
    const auto o = std::make_shared<Options>();
    addInput(*c, "model", o->model, "Model (*.ttm)")->required();
    c->add_flag("--csv", o->csv, "Everything a prediction needs, as CSV");
    c->callback([o, &job] { job = [o] { return showModel(o->model, o->csv); }; });
}

void addModelCard(CLI::App& model, Job& job)
{
    auto* c = model.add_subcommand(
        "card", "Write into the card beside a model when and on what ground it was trained");
    const auto o = std::make_shared<ModelCardOptions>();
    addInput(*c, "model", o->model, "Model (*.ttm)")->required();
    declareFiles(*c, FileRole::Update, [o] { return Paths{cardPath(o->model)}; });
    c->add_option("--trained", o->trained, "When, such as 2026-11-22T07:05:00Z");
    c->add_option("--terrain", o->terrain, "On what ground, in 1 to 100 characters");
    c->callback([o, &job] { job = [o] { return describeModel(*o); }; });
}

void addModelPredict(CLI::App& model, Job& job)
{
    struct Options {
        std::string model, data;
    };
    auto* c = model.add_subcommand(
        "predict", "Mean and sd of each bin given the scene's other bins, as CSV: to check "
                   "the model against another program");
    const auto o = std::make_shared<Options>();
    addInput(*c, "model", o->model, "Model (*.ttm)")->required();
    addInput(*c, "--data", o->data, "Scenes CSV with heights")->required();
    c->callback([o, &job] { job = [o] { return predictConditionals(o->model, o->data); }; });
}

}  // namespace

void addInspection(CLI::App& app, Job& job)
{
    addContacts(app, job);
    addFaults(app, job);
    addProbes(app, job);
    addCalibrate(app, job);
    auto* model = app.add_subcommand("model", "Look at models");
    model->require_subcommand(1);
    addModelShow(*model, job);
    addModelCard(*model, job);
    addModelPredict(*model, job);
}

}  // namespace terratact
