#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "bus/topics.hpp"

namespace farrier::cli {

/// Returns the names that an option for topics accepts.
std::vector<std::string> topic_names();

/// --topics
void declare_topic_choice(CLI::App& app, std::vector<std::string>& names);

/// Topics of these names, in the order of the registry.
std::vector<bus::TopicId> topics_of(const std::vector<std::string>& names);

}  // namespace farrier::cli
