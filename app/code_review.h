// Whether the document's own types may run: those that this user wrote or allowed, once a worker has tried their code.
#pragma once

#include "app/trusted_code.h"
#include "app/worker_jobs.h"
#include "graph/document.h"
#include "graph/own_types.h"

#include <deque>
#include <map>
#include <mutex>
#include <thread>

namespace fieldwright::app {

class CodeReview {
public:
    // Tries a fragment shader where it can do no harm. Empty: nothing is tried.
    using Trial = std::function<ShaderVerdict(const std::string& shader, const std::stop_token& stop)>;

    // `on_ready` is called from another thread when `update` has something new.
    CodeReview(std::filesystem::path trusted_file, Trial trial, std::function<void()> on_ready);

    // What EditSession asks.
    std::optional<graph::TextError> verdict(const graph::OwnType& type);
    // Begins and ends trials, under that library. True when verdicts are others now. Call often.
    bool update(const std::shared_ptr<const graph::Library>& library);
    void trust(const std::vector<graph::OwnType>& types);  // graph::Failure: they are trusted until the program ends
    // The types that nodes have and that may not run before the user says so.
    std::vector<graph::OwnType> foreign(const graph::Document& document) const;

private:
    using Outcome = std::optional<graph::TextError>;
    struct Finished {
        std::string text;
        Outcome outcome;
    };

    void start(graph::OwnType type, std::shared_ptr<const graph::Library> library);
    Outcome tried(const graph::OwnType& type, const graph::Library& library, const std::stop_token& stop) const;

    TrustedCode trusted_;
    Trial trial_;
    std::function<void()> on_ready_;
    std::map<std::string, Outcome> outcomes_;  // by text, whatever its name
    std::deque<graph::OwnType> waiting_;
    bool running_ = false;
    std::mutex mutex_;
    std::optional<Finished> finished_;  // guarded by mutex_
    std::jthread thread_;               // the last member: it ends before what it uses
};

// A driver's words about `shader`, as where they are in the text of `type` and what is wrong there.
graph::TextError error_in_type(const std::string& log, const std::string& type, const graph::Library& library,
                               std::string_view shader);

}  // namespace fieldwright::app
